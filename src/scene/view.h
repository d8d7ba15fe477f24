#pragma once
// Projections, and the view policy `auto`: it moves the eye back if the eye would be inside the scene
// (language, 2.5 and 3.1).

#include <functional>
#include <glm/mat4x4.hpp>

#include "geometry/mesh.h"
#include "scene/scene.h"

namespace glibra::scene {

/// The matrix from eye to clip space with GL's conventions (x, y, z in -w..w). `aspect` is width / height of
/// the target. An orthographic box is extended in one direction about its centre, so that all of it is shown
/// undistorted. Equal limits stand for -1 and 1.
glm::dmat4 projectionMatrix(const Projection& projection, double aspect);

/// Width / height of the targets of the pass; windowAspect for the window.
double aspectOf(const Scene& scene, const Pass& pass, double windowAspect);

/// Returns the mesh of a shape, or null if it has none. Shapes without a mesh are ignored.
using MeshOf = std::function<const geometry::Mesh*(ShapeIndex shape)>;

/// The distance by which the eye is moved back for all draws with a perspective projection, in all passes.
struct ViewMove {
    double distance = 0;      ///< eye space units along z, a multiple of 1/16; 0: not moved
    Diagnostics diagnostics;  ///< the note draw-N01 if the eye is moved
};

/// The policy `auto`. Calls `meshOf` only if the scene executes no LookAt and has perspective draws, and
/// stops when it is clear that the eye stays. Vertices are transformed to eye space in double.
ViewMove autoView(const Scene& scene, const MeshOf& meshOf, double windowAspect);

}  // namespace glibra::scene
