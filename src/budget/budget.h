#pragma once
// From a bound in pixels to the counts, tessellation levels, samples and noise textures of a scene that keep
// it at the least cost.
//
// The bound holds for each of these by itself: a mesh against the surface it stands for, edges against the
// places that the samples tell, noise against the function it samples. For meshes it is proved for programs
// whose text shows that they place vertices by the model-view-projection alone (glsl::Placement). What
// programs compute at the vertices or from their normals is measured, on small pictures. Not in it: where two
// surfaces cut each other at a flat angle the cut moves further than the surfaces do; what tessellation
// stages compute at their vertices but places. Passes into a texture are judged in its texels.

#include <functional>
#include <glm/mat4x4.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "budget/contour_shift.h"
#include "budget/patch_error.h"
#include "budget/sampling_model.h"
#include "plan/frame_plan.h"
#include "scene/scene.h"

namespace glibra::budget {

struct NoiseChoice {
    scene::TextureIndex texture{};
    NoiseFormat format;
};

/// A value of a uniform of the draw's program.
struct LevelValue {
    plan::UniformIndex uniform{};
    double value = 0;
};

struct Choice;

struct Request {
    double maxError = 0;          ///< pixels, above 0
    bool overrideCounts = false;  ///< choose also what the scene states, levels always among it
    int width = 0, height = 0;    ///< of the window, pixels
    bool areSamplesFree = true;
    int mostSamples = 1;  ///< of the driver
    /// Projection * ModelView as the draw will have them; aspect is width / height of what it draws into.
    std::function<glm::dmat4(const scene::Draw& draw, double aspect)> clipFromModel;
    /// How far contours move, in pixels of the picture, from the one shapes, noise and samples to the other.
    /// Without an answer a period of noise is taken to be one unit of the model that it is seen on, and what
    /// programs compute at the vertices has no bound.
    std::function<std::optional<ContourShifts>(const Choice& from, const Choice& to)> contourShift{};
    int mostLevel = 64;                           ///< of tessellation, of the driver
    std::span<const plan::Override> overrides{};  ///< values that nothing else replaces
    /// What the tessellation stages make of the patches of the draw at Scene::passes[pass].steps[step] with
    /// these values in place of the scene's; the same patches at every call. Without it levels are kept.
    std::function<std::optional<std::vector<Patch>>(std::size_t pass, std::size_t step,
                                                    std::span<const LevelValue> values)>
        patches{};
};

/// For --explain and --stats: what was chosen or kept, and why.
struct Decision {
    std::string what;  ///< "Sphere", "samples", "Noise3D"
    std::string why;
    Place place;
};

/// New numbers for the shape of one draw.
struct ShapeChoice {
    std::size_t pass = 0, step = 0;  ///< indices into Scene::passes and Pass::steps
    std::vector<double> numbers;
};

struct Choice {
    std::vector<ShapeChoice> shapes;  ///< of draws whose numbers change
    std::vector<NoiseChoice> noise;
    std::vector<plan::Override> levels;  ///< values of uniforms that decide tessellation levels
    int samples = 1;  ///< as many as the bound needs and the driver has; 1 if they are not free
    std::vector<Decision> decisions;
    Diagnostics diagnostics;  ///< draw-W07: the bound cannot be kept; draw-N03: it is not, for stated numbers
};

/// Chooses for everything in the plan, which is one of the scene. Draws of one shape share a mesh unless some
/// need four times the deviation of others or more, which is half the counts.
Choice choose(const scene::Scene& scene, const plan::FramePlan& plan, const Request& request);

/// Puts shapes and noise into the scene. Returns the indices of the shapes that were there and are now
/// others.
std::vector<scene::ShapeIndex> apply(const Choice& choice, scene::Scene& scene);

}  // namespace glibra::budget
