#pragma once
// The solids in closed form: the references for their meshes. Lengths are in units of the radius; the meshes
// have a radius of .7, so that no vertex is exact only because its numbers are round.

#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>

#include "geometry/mesh.h"

namespace glibra::bench {

/// The surface point closest to a point.
struct Foot {
    double distance = 0;
    glm::dvec3 normal{0};   ///< outward, unit length
    bool hasNormal = true;  ///< false at the apex of the cone
};

struct Solid {
    std::string_view name;
    /// The mesh with n slices around (n >= 6). Stacks and sides are n / 2; cylinder and cone have 1.
    geometry::Mesh (*mesh)(int n);
    /// `face` is the outward normal of the triangle that holds the point: it distinguishes a cap from the
    /// side.
    Foot (*foot)(const glm::dvec3& point, const glm::dvec3& face);
    double volume = 0;
    /// The largest dot(p, direction) over the solid (support function), for a unit direction.
    double (*extent)(const glm::dvec3& direction);
};

inline constexpr double kSolidRadius = .7;  ///< radius of the meshes

/// Sphere, torus (tube .4), cylinder and cone (height 2), in this order.
std::span<const Solid> solids();

/// The distance of a mesh from a surface, measured at a net of points on every triangle.
struct MeshError {
    double distance = 0;    ///< largest
    double normal = 0;      ///< largest angle in degrees between the interpolated normal and the surface's
    double faceNormal = 0;  ///< the same for the normals of the triangles
};

MeshError meshError(const geometry::Mesh& mesh, Foot (*foot)(const glm::dvec3&, const glm::dvec3&));

/// The same for a mesh of the unit sphere scaled by kSolidRadius.
MeshError sphereError(const geometry::Mesh& mesh);

inline constexpr double kOutlineRadius = 512;  ///< pixels of a radius where outlines are compared

/// The largest distance between the outlines of mesh and solid in three views without perspective: the
/// largest difference of the extents of their convex hulls in 360 directions per view.
double outlineError(const geometry::Mesh& mesh, const std::function<double(const glm::dvec3&)>& extent);

/// The volume of a closed mesh in cubed radii; positive if triangles are counter-clockwise seen from outside.
double signedVolume(const geometry::Mesh& mesh);

/// Bytes of vertices and indices together.
double meshBytes(const geometry::Mesh& mesh);

}  // namespace glibra::bench
