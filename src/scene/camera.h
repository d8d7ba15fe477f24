#pragma once
// Cameras (language, 12.3): a place, a direction, and a projection, as matrices in double precision.

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <utility>

#include "scene/scene.h"

namespace glibra::scene {

/// A camera, and its element if it belongs to an array.
using CameraName = std::pair<std::string, std::size_t>;

/// Everything that an expression may ask of a camera. All in world space, angles in degrees.
struct CameraValues {
    glm::dmat4 view{1.0};        ///< from world to eye space
    glm::dmat4 projection{1.0};  ///< from eye to clip space
    double near = 0, far = 0;    ///< distances of the planes from the eye
    double fieldOfView = 0;      ///< vertical, full angle; 0 for projections without one
    double aspect = 1;           ///< width / height

    [[nodiscard]] glm::dmat4 viewProjection() const { return projection * view; }
    [[nodiscard]] glm::dmat4 inverseView() const;
    [[nodiscard]] glm::dvec3 position() const;   ///< of the eye
    [[nodiscard]] glm::dvec3 direction() const;  ///< unit vector in which it looks
    /// Takes world space to 0..1 in all three coordinates, before the division by w: what a shadow map is
    /// read with.
    [[nodiscard]] glm::dmat4 shadow() const;
};

/// What a projection matrix says of its volume.
struct Lens {
    double near = 0, far = 0;  ///< distances of the planes from the eye
    double fieldOfView = 0;    ///< vertical, full angle in degrees; 0 for a box
};

/// The lens of a frustum, also one off the axis, or a box; zeros for a matrix that makes neither.
Lens lensOf(const glm::dmat4& projection);

/// The mirror image of everything about the plane n . x + d = 0; `normal` may have any length but 0.
glm::dmat4 reflection(const glm::dvec3& normal, double d);

/// `projection` with its near plane replaced by a plane of eye space (a, b, c, d), which the eye is behind:
/// what lies on the plane's negative side is clipped. Source: E. Lengyel, Oblique View Frustum Depth
/// Projection and Clipping, Journal of Game Development 1(2), 2005.
glm::dmat4 withNearPlane(const glm::dmat4& projection, const glm::dvec4& plane);

/// The view of a face of a cube map (0..5: +x -x +y -y +z -z) from `eye`, as GL orients cube maps.
glm::dmat4 faceView(int face, const glm::dvec3& eye);

}  // namespace glibra::scene
