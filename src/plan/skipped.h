#pragma once
// What a plan leaves out, in words, for --explain and --stats.

#include <glibra/diagnostic.h>

#include <string>
#include <vector>

namespace glibra::scene {
struct Scene;
struct Shape;
}  // namespace glibra::scene

namespace glibra::plan {

struct Needs;
struct FramePlan;

struct Skipped {
    std::string what;  ///< "texture", "noise texture", "attribute", "mesh", "program", "pass", "draw",
                       ///< "dispatch", "statement", "file"
    std::string why;   ///< which one, and why: "unit 5 / 3D: no active sampler reads it"
    Place place;
};

/// Lists everything of the scene that is not in the plan: passes, draws, statements, programs, meshes,
/// attributes, textures, files, in this order, and each kind in the order of the scene.
std::vector<Skipped> listSkipped(const scene::Scene& scene, const Needs& needs, const FramePlan& plan);

/// The attributes that the mesh of a shape may have, in the order of the constants of geometry.
std::vector<std::string> attributesOf(const scene::Shape& shape);

}  // namespace glibra::plan
