#pragma once
// From a bound in pixels to the counts, samples and noise sizes of a scene that keep it at the least cost.
//
// The bound holds for each of these by itself: a mesh against the surface it stands for, edges against the
// places that the samples tell, noise against the function it samples. For meshes it is proved for programs
// whose text shows that they place vertices by the model-view-projection alone (glsl::Placement). Not in it:
// where two surfaces cut each other at a flat angle the cut moves further than the surfaces do; what a
// program computes at the vertices but is not linear between them has no bound but CountArgument::smooth.
// Passes into a texture are judged in its texels.

#include <functional>
#include <glm/mat4x4.hpp>
#include <string>
#include <vector>

#include "plan/frame_plan.h"
#include "scene/scene.h"

namespace glibra::budget {

struct Request {
    double maxError = 0;          ///< pixels, above 0
    bool overrideCounts = false;  ///< choose also what the scene states
    int width = 0, height = 0;    ///< of the window, pixels
    bool areSamplesFree = true;
    int mostSamples = 1;  ///< of the driver
    /// Projection * ModelView as the draw will have them; aspect is width / height of what it draws into.
    std::function<glm::dmat4(const scene::Draw& draw, double aspect)> clipFromModel;
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
struct NoiseChoice {
    int texture = scene::kNone;  ///< index into Scene::textures
    int size = 64;
};

struct Choice {
    std::vector<ShapeChoice> shapes;  ///< of draws whose numbers change
    std::vector<NoiseChoice> noise;
    int samples = 1;  ///< as many as the bound needs and the driver has; 1 if they are not free
    std::vector<Decision> decisions;
    Diagnostics diagnostics;  ///< draw-W07: the bound cannot be kept; draw-N03: it is not, for stated numbers
};

/// Chooses for everything in the plan, which is one of the scene. Draws of one shape share a mesh unless some
/// need four times the deviation of others or more, which is half the counts.
Choice choose(const scene::Scene& scene, const plan::FramePlan& plan, const Request& request);

/// Puts the choice into the scene. Returns the indices of the shapes that were there and are now others.
std::vector<int> apply(const Choice& choice, scene::Scene& scene);

}  // namespace glibra::budget
