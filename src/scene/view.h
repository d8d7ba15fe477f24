#pragma once
// Matrices, cameras, projections, and how far the eye is moved back.

#include <cstddef>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <utility>

#include "base/matrices.h"
#include "geometry/mesh.h"
#include "scene/scene.h"

namespace glibra::scene {

// ---- Matrices
// The matrices of a scene and those that shaders get (language, 6.2). All are double precision and multiply
// column vectors. They are rounded once, when they go to the graphics device.

using base::cosineOfDegrees;
using base::inverseOrZero;
using base::isSingular;
using base::rotation;
using base::scaling;
using base::sineOfDegrees;
using base::translation;
using base::viewingMatrix;

/// The matrix for normals: the inverse transpose of the upper left 3 x 3. If that is singular, the result is
/// its cofactor matrix, which gives the same directions except for sign. If the elements are too large or all
/// too small for a float, they are divided by the largest, which keeps directions.
glm::dmat3 normalMatrix(const glm::dmat4& modelView);

/// True if all elements are finite as 32-bit floats.
bool isFinite(const glm::dmat4& matrix);

// ---- Cameras
// Cameras (language, 12.3): a place, a direction, and a projection, as matrices in double precision.

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

// ---- Views
// Projections, and the view policy `auto`: it moves the eye back if the eye would be inside the scene
// (language, 2.5 and 3.1).

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
