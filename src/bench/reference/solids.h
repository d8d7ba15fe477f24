#pragma once
// The solids in closed form: what their meshes are measured against. Lengths are in units of the radius,
// while the meshes have a radius of .7, so that no vertex is exact because its numbers are round.

#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>

#include "geometry/mesh.h"

namespace glibra::bench {

/// The surface at the foot of the perpendicular from a point.
struct Foot {
    double distance = 0;
    glm::dvec3 normal{0};   ///< outward, unit length
    bool hasNormal = true;  ///< false at the apex of the cone
};

struct Solid {
    std::string_view name;
    /// The mesh with n slices around; stacks and sides are n / 2, of cylinder and cone 1. n >= 6.
    geometry::Mesh (*mesh)(int n);
    /// `face` is the outward normal of the triangle that holds the point: it tells a cap from the side.
    Foot (*foot)(const glm::dvec3& point, const glm::dvec3& face);
    double volume = 0;
    /// Largest dot(p, direction) over the solid (support function), for a unit direction.
    double (*extent)(const glm::dvec3& direction);
};

inline constexpr double kSolidRadius = .7;  ///< of the meshes

/// Sphere, torus (tube .4), cylinder and cone (height 2), in this order.
std::span<const Solid> solids();

/// How far a mesh is from a surface, by a net of points on every triangle.
struct MeshError {
    double distance = 0;    ///< largest
    double normal = 0;      ///< largest angle between interpolated normal and surface, degrees
    double faceNormal = 0;  ///< the same of the triangles' own normals
};

MeshError meshError(const geometry::Mesh& mesh, Foot (*foot)(const glm::dvec3&, const glm::dvec3&));

/// The same for a mesh on the unit sphere times kSolidRadius.
MeshError sphereError(const geometry::Mesh& mesh);

/// Largest distance between the outlines of mesh and solid, seen from three sides without perspective: of
/// their convex hulls, as the difference of the extents in 360 directions of each view.
double outlineError(const geometry::Mesh& mesh, const std::function<double(const glm::dvec3&)>& extent);

/// Of a closed mesh, in cubed radii; positive if triangles are counter-clockwise from outside.
double signedVolume(const geometry::Mesh& mesh);

/// Vertices and indices together.
double meshBytes(const geometry::Mesh& mesh);

}  // namespace glibra::bench
