#pragma once
// Meshes against their surfaces: solids in closed form, and bicubic patches in double. Lengths are in units
// of the radius; the meshes of solids have a radius of .7, so that no vertex is exact only because its
// numbers are round.

#include <array>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "bench/core/bench.h"
#include "geometry/mesh.h"
#include "geometry/shapes/teapot.h"

namespace glibra::bench {

inline constexpr double kSolidRadius = .7;  ///< radius of the meshes

/// The surface point closest to a point.
struct Foot {
    double distance = 0;
    glm::dvec3 normal{0};   ///< outward, unit length
    bool hasNormal = true;  ///< false at the apex of the cone
};
/// `face` is the outward normal of the triangle that holds the point: it distinguishes a cap from the side.
using FootOn = Foot (*)(const glm::dvec3& point, const glm::dvec3& face);

/// The distance of a mesh from a surface, measured at a net of points on every triangle.
struct MeshError {
    double distance = 0;    ///< largest
    double normal = 0;      ///< largest angle in degrees between the interpolated normal and the surface's
    double faceNormal = 0;  ///< the same for the normals of the triangles
};
MeshError meshError(const geometry::Mesh& mesh, FootOn foot);
/// The same for a mesh of the unit sphere scaled by kSolidRadius.
MeshError sphereError(const geometry::Mesh& mesh);

/// The volume of a closed mesh in cubed radii; positive if triangles are counter-clockwise seen from outside.
double signedVolume(const geometry::Mesh& mesh);
/// Bytes of vertices and indices together.
double meshBytes(const geometry::Mesh& mesh);

struct PatchPoint {
    glm::dvec3 position{0}, alongS{0}, alongT{0};  ///< position, and derivatives by s and t
};
/// By de Casteljau's algorithm, which orders its operations differently from Bernstein polynomials.
PatchPoint patchPoint(const geometry::Patch& patch, const glm::dvec2& st);
/// The parameters, within 0..1, of the point of the patch that is nearest to `point`, searched from `start`
/// by damped Gauss-Newton steps.
glm::dvec2 nearestOnPatch(const geometry::Patch& patch, const glm::dvec3& point, glm::dvec2 start);

std::vector<Figure> measurePrimitives(Bench& bench);

}  // namespace glibra::bench
