#pragma once
// Chooses counts, tessellation levels, samples and noise textures for a scene: the cheapest ones that keep a
// bound in pixels.
//
// The bound holds for each of these separately: for a mesh compared with its surface, for edges compared with
// where the samples show them, for noise compared with the function that the texture samples. For meshes it
// is proved if the program's text shows that it places vertices by the model-view-projection alone
// (glsl::Placement). Everything else that programs compute at the vertices or from their normals is measured
// on small pictures, and tessellated patches are captured. Two things are not covered: where two surfaces
// intersect at a flat angle, the intersection moves further than the surfaces do; and tessellation stages may
// compute other values than places. Passes into a texture are judged in its texels.

#include <functional>
#include <glm/mat4x4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "budget/contour_shift.h"
#include "budget/decision.h"
#include "budget/error_models.h"
#include "plan/frame_plan.h"
#include "plan/overrides.h"
#include "scene/scene.h"

namespace glibra::budget {

struct NoiseChoice {
    scene::TextureIndex texture{};
    NoiseFormat format;
};

/// A value of a uniform that decides a tessellation level.
struct LevelValue {
    plan::UniformIndex uniform{};  ///< of the draw's program
    double value = 0;
};

/// The levels of tessellated patches: those of the scene, with values in place of its own.
struct Levels {
    std::span<const LevelValue> values{};
    /// Above 0: the level of all patches in place of what the program computes, except for the number of
    /// isolines.
    double all = 0;
};

struct Choice;

struct Request {
    double maxError = 0;          ///< pixels, above 0
    bool overrideCounts = false;  ///< also choose what the scene states; levels always count as stated
    int width = 0, height = 0;    ///< of the window, pixels
    bool areSamplesFree = true;
    int mostSamples = 1;  ///< the driver's limit
    /// Returns Projection * ModelView of a draw; aspect is width / height of what it draws into.
    std::function<glm::dmat4(const scene::Draw& draw, double aspect)> clipFromModel;
    /// Measures how far contours move, in pixels of the picture, from one choice to the other. Without it, or
    /// if it returns nothing, a period of noise is taken to be one unit of the model on which it is seen, and
    /// the values that programs compute at the vertices have no bound.
    std::function<std::optional<ContourShifts>(const Choice& from, const Choice& to)> contourShift{};
    int mostLevel = 64;                           ///< the driver's limit for tessellation levels
    std::span<const plan::Override> overrides{};  ///< values that must not be replaced
    /// Returns the tessellated patches of the draw at Scene::passes[pass].steps[step]; the same patches at
    /// every call, without vertices if they are culled. Without it levels are kept.
    std::function<std::optional<std::vector<Patch>>(std::size_t pass, std::size_t step, const Levels& levels)>
        patches{};
};

/// New numbers for the shape of one draw.
struct ShapeChoice {
    std::size_t pass = 0, step = 0;  ///< indices into Scene::passes and Pass::steps
    std::vector<double> numbers;
};

struct Choice {
    std::vector<ShapeChoice> shapes;  ///< only for draws whose numbers change
    std::vector<NoiseChoice> noise;
    std::vector<plan::Override> levels;  ///< values of uniforms that decide tessellation levels
    int samples = 1;  ///< as many as the bound needs, up to the driver's limit; 1 if they are not free
    std::vector<Decision> decisions;
    /// draw-W07: the bound cannot be kept; draw-N03: stated numbers do not keep it; draw-N05: no bound is
    /// known.
    Diagnostics diagnostics;
};

/// Chooses for everything in the plan, which must belong to the scene. Draws of one shape share a mesh,
/// unless some of them allow at least four times the deviation of others and so need only half the counts.
Choice choose(const scene::Scene& scene, const plan::FramePlan& plan, const Request& request);

/// Puts the chosen shapes and noise textures into the scene. Returns the indices of the shapes that have been
/// replaced.
std::vector<scene::ShapeIndex> apply(const Choice& choice, scene::Scene& scene);

}  // namespace glibra::budget
