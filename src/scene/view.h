#pragma once
// Projections, and the policy that moves the eye back from a scene that would be seen from inside
// (language, 2.5, 3.1).

#include <functional>
#include <glm/mat4x4.hpp>

#include "geometry/mesh.h"
#include "scene/scene.h"

namespace glibra::scene {

/// Eye to clip space, GL's conventions (x, y, z in -w..w). `aspect` is width / height of the target. An
/// orthographic box is grown in one direction about its centre so that it is shown undistorted and whole;
/// limits that are equal stand for -1 and 1.
glm::dmat4 projectionMatrix(const Projection& projection, double aspect);

/// Width / height of what the pass draws into; windowAspect for the window.
double aspectOf(const Scene& scene, const Pass& pass, double windowAspect);

/// The mesh of a shape (index into Scene::shapes); null if there is none, it then counts for nothing.
using MeshOf = std::function<const geometry::Mesh*(ShapeIndex shape)>;

/// How far the eye is moved back.
struct ViewMove {
    double distance = 0;      ///< eye space units along z, a multiple of 1/16; 0: not at all
    Diagnostics diagnostics;  ///< the note draw-N01, if moved
    /// True if it applies to the draw: every one with a perspective projection, in all passes.
    [[nodiscard]] bool appliesTo(const Draw& draw) const {
        return distance != 0 && std::holds_alternative<Perspective>(draw.projection);
    }
    /// ModelView of a draw, moved if it applies.
    [[nodiscard]] glm::dmat4 modelViewOf(const Draw& draw) const;
};

/// The policy `auto`. Calls `meshOf` only if the scene executes no LookAt and has perspective draws, and no
/// more once it is clear that nothing moves. Vertices are taken in eye space by the draw's ModelView, in
/// double.
ViewMove autoView(const Scene& scene, const MeshOf& meshOf, double windowAspect);

}  // namespace glibra::scene
