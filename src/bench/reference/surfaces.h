#pragma once
// Surfaces in double, and how far meshes are from them.

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/shapes/teapot.h"

namespace glibra::bench {

// Bicubic patches in double.

struct PatchPoint {
    glm::dvec3 position{0}, alongS{0}, alongT{0};  ///< position, and derivatives by s and t
};

struct CurvePoint {
    glm::dvec3 position{0}, slope{0};
};

inline CurvePoint deCasteljau(std::array<glm::dvec3, 4> p, double u) {
    for (std::size_t level = 3; level > 1; --level)
        for (std::size_t i = 0; i < level; ++i) p[i] = glm::mix(p[i], p[i + 1], u);
    return {glm::mix(p[0], p[1], u), 3. * (p[1] - p[0])};
}

/// By de Casteljau's algorithm, which orders its operations differently from Bernstein polynomials.
inline PatchPoint patchPoint(const geometry::Patch& patch, const glm::dvec2& st) {
    std::array<glm::dvec3, 4> columns, slopes;
    for (std::size_t column = 0; column < 4; ++column) {
        const CurvePoint down =
            deCasteljau({patch[0][column], patch[1][column], patch[2][column], patch[3][column]}, st.y);
        columns[column] = down.position;
        slopes[column] = down.slope;
    }
    const CurvePoint across = deCasteljau(columns, st.x);
    return {across.position, across.slope, deCasteljau(slopes, st.x).position};
}

/// The parameters, within 0..1, of the point of the patch that is nearest to `point`, searched from `start`
/// by damped Gauss-Newton steps.
inline glm::dvec2 nearestOnPatch(const geometry::Patch& patch, const glm::dvec3& point, glm::dvec2 start) {
    constexpr int kSteps = 4;
    constexpr double kDamping = 1e-9;  // prevents a division by 0 at the poles, where dP/ds is 0
    glm::dvec2 st = start;
    for (int i = 0; i < kSteps; ++i) {
        const PatchPoint at = patchPoint(patch, st);
        const glm::dvec3 miss = point - at.position;
        const double ss = glm::dot(at.alongS, at.alongS) + kDamping,
                     tt = glm::dot(at.alongT, at.alongT) + kDamping, mixed = glm::dot(at.alongS, at.alongT);
        const double s = glm::dot(at.alongS, miss), t = glm::dot(at.alongT, miss);
        const double determinant = ss * tt - mixed * mixed;
        const glm::dvec2 step((tt * s - mixed * t) / determinant, (ss * t - mixed * s) / determinant);
        st = glm::clamp(st + step, 0., 1.);
    }
    return st;
}

using TeapotPatches = std::array<geometry::Patch, 32>;

/// The patches of the teapot at their places in the meshes of scenes, whose body is two units wide.
inline TeapotPatches placedTeapotPatches() {
    TeapotPatches patches = geometry::teapotPatches();
    for (geometry::Patch& patch : patches)
        for (auto& row : patch)
            for (glm::dvec3& point : row) point = geometry::teapotPlace(point);
    return patches;
}

/// The volume between the patches and the origin, which also exists for the teapot although it is open: the
/// integral of P . (Ps x Pt) / 3, a polynomial of degree 8 in s and in t, for which five Gauss points are
/// exact.
inline double patchVolume(const TeapotPatches& patches) {
    constexpr std::array<std::array<double, 2>, 5> kGauss{{{-.9061798459386640, .2369268850561891},
                                                           {-.5384693101056831, .4786286704993665},
                                                           {0, .5688888888888889},
                                                           {.5384693101056831, .4786286704993665},
                                                           {.9061798459386640, .2369268850561891}}};
    double sum = 0;
    for (const geometry::Patch& patch : patches)
        for (const auto& [s, weightS] : kGauss)
            for (const auto& [t, weightT] : kGauss) {
                const PatchPoint at = patchPoint(patch, {(s + 1) / 2, (t + 1) / 2});
                sum += weightS * weightT / 4 * glm::dot(at.position, glm::cross(at.alongS, at.alongT)) / 3;
            }
    return std::abs(sum);
}

/// The extent of the patches in a direction: the best of 17 x 17 points of each patch, refined by ever
/// smaller steps.
class PatchExtent {
  public:
    explicit PatchExtent(const TeapotPatches& patches) : patches_(patches) {
        for (std::size_t patch = 0; patch < patches.size(); ++patch)
            for (int j = 0; j <= kCells; ++j)
                for (int i = 0; i <= kCells; ++i) {
                    const glm::dvec2 st = glm::dvec2(i, j) / static_cast<double>(kCells);
                    places_.push_back({patch, st, patchPoint(patches[patch], st).position});
                }
    }

    [[nodiscard]] double operator()(const glm::dvec3& direction) const {
        const Place& best = *std::ranges::max_element(
            places_, {}, [&](const Place& each) { return glm::dot(each.position, direction); });
        glm::dvec2 at = best.st;
        double farthest = glm::dot(best.position, direction);
        for (double step = 1. / kCells; step > 1e-7;) {
            bool isBetter = false;
            for (const glm::dvec2 side : {glm::dvec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                const glm::dvec2 there = glm::clamp(at + step * side, 0., 1.);
                const double reach = glm::dot(patchPoint(patches_[best.patch], there).position, direction);
                if (reach <= farthest) continue;
                farthest = reach;
                at = there;
                isBetter = true;
            }
            if (!isBetter) step /= 2;
        }
        return farthest;
    }

  private:
    static constexpr int kCells = 16;
    struct Place {
        std::size_t patch = 0;
        glm::dvec2 st{0};
        glm::dvec3 position{0};
    };
    const TeapotPatches& patches_;
    std::vector<Place> places_;
};

// A curved PN triangle in double.

/// The cubic Bezier triangle through three corners with normals (A. Vlachos et al., Curved PN Triangles,
/// 2001), evaluated by de Casteljau's algorithm.
class PnTriangle {
  public:
    PnTriangle(const std::array<glm::dvec3, 3>& corners, const std::array<glm::dvec3, 3>& normals) {
        const auto towards = [&](std::size_t from, std::size_t to) {
            const glm::dvec3 step = corners[to] - corners[from];
            return corners[from] + (step - glm::dot(step, normals[from]) * normals[from]) / 3.;
        };
        const auto set = [&](int i, int j, const glm::dvec3& point) { points_[placeOf(3, i, j)] = point; };
        set(3, 0, corners[0]);
        set(0, 3, corners[1]);
        set(0, 0, corners[2]);
        set(2, 1, towards(0, 1));
        set(1, 2, towards(1, 0));
        set(0, 2, towards(1, 2));
        set(0, 1, towards(2, 1));
        set(1, 0, towards(2, 0));
        set(2, 0, towards(0, 2));
        const glm::dvec3 edges =
            (towards(0, 1) + towards(1, 0) + towards(1, 2) + towards(2, 1) + towards(2, 0) + towards(0, 2)) /
            6.;
        const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.;
        set(1, 1, edges + (edges - middle) / 2.);
    }

    /// The point at barycentric coordinates, which add up to 1.
    [[nodiscard]] glm::dvec3 at(const glm::dvec3& barycentric) const {
        return deCasteljau(barycentric).position;
    }

    /// The distance of a point from the surface, searched by Gauss-Newton steps from the given coordinates.
    /// The surface continues beyond its edges.
    [[nodiscard]] double distance(const glm::dvec3& point, const glm::dvec3& start) const {
        constexpr int kSteps = 6;
        constexpr double kDegree = 3;
        glm::dvec3 where = start;
        for (int step = 0; step < kSteps; ++step) {
            const Near near = deCasteljau(where);
            const glm::dvec3 along = kDegree * (near.last[0] - near.last[2]),
                             across = kDegree * (near.last[1] - near.last[2]), miss = point - near.position;
            const double aa = glm::dot(along, along), bb = glm::dot(across, across),
                         ab = glm::dot(along, across);
            const double a = glm::dot(along, miss), b = glm::dot(across, miss);
            const double determinant = aa * bb - ab * ab;
            where.x += (bb * a - ab * b) / determinant;
            where.y += (aa * b - ab * a) / determinant;
            where.z = 1 - where.x - where.y;
        }
        return glm::length(point - at(where));
    }

  private:
    struct Near {
        glm::dvec3 position{0};
        std::array<glm::dvec3, 3>
            last{};  ///< the last triangle of the algorithm: its plane is tangent to the surface
    };

    /// The index of b(i,j,k) with i + j + k = degree among all, i falling, then j falling.
    static std::size_t placeOf(int degree, int i, int j) {
        const auto row = static_cast<std::size_t>(degree - i);
        return row * (row + 1) / 2 + row - static_cast<std::size_t>(j);
    }

    [[nodiscard]] Near deCasteljau(const glm::dvec3& barycentric) const {
        std::array<glm::dvec3, 10> points = points_;
        for (int degree = 2; degree > 0; --degree)
            // In rising order, each result overwrites a point that is no longer needed.
            for (int i = degree; i >= 0; --i)
                for (int j = degree - i; j >= 0; --j)
                    points[placeOf(degree, i, j)] = barycentric.x * points[placeOf(degree + 1, i + 1, j)] +
                                                    barycentric.y * points[placeOf(degree + 1, i, j + 1)] +
                                                    barycentric.z * points[placeOf(degree + 1, i, j)];
        return {barycentric.x * points[0] + barycentric.y * points[1] + barycentric.z * points[2],
                {points[0], points[1], points[2]}};
    }

    std::array<glm::dvec3, 10> points_{};  ///< b(i,j,k), i falling, then j falling
};

// The error of a mesh: its distance from a surface, its normals, outline and volume. Lengths are in units of
// the radius; the meshes of solids have a radius of .7, so that no vertex is exact only because its numbers
// are round.

inline constexpr double kSolidRadius = .7;  ///< radius of the meshes

/// The surface point closest to a point.
struct Foot {
    double distance = 0;
    glm::dvec3 normal{0};   ///< outward, unit length
    bool hasNormal = true;  ///< false at the apex of the cone
};
/// `face` is the outward normal of the triangle that holds the point: it distinguishes a cap from the side.
using FootOn = Foot (*)(const glm::dvec3& point, const glm::dvec3& face);
/// On the unit sphere.
inline Foot footOnSphere(const glm::dvec3& p, const glm::dvec3& /*face*/) {
    const double length = glm::length(p);
    return {std::abs(length - 1), p / length};
}

/// 0..180 degrees; accurate for small angles too.
inline double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi;
}

/// Three components of an attribute of every vertex, in double; missing components are 0. Empty if the mesh
/// has no such attribute.
inline std::vector<glm::dvec3> vectorsOf(const geometry::Mesh& mesh, std::string_view name) {
    const geometry::Attribute* attribute = mesh.attribute(name);
    if (!attribute) return {};
    const auto components = static_cast<std::size_t>(attribute->components);
    std::vector<glm::dvec3> vectors(attribute->values.size() / components);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        for (std::size_t c = 0; c < components && c < 3; ++c)
            vectors[i][static_cast<glm::length_t>(c)] = attribute->values[i * components + c];
    return vectors;
}

/// Interpolates linearly, as the pipeline does.
struct Triangle {
    std::array<std::uint32_t, 3> vertices{};
    std::array<glm::dvec3, 3> positions{}, normals{}, texCoords{};
    glm::dvec3 faceNormal{0};  ///< unit length

    [[nodiscard]] glm::dvec3 position(const glm::dvec3& weights) const { return mixed(positions, weights); }
    /// Normalised.
    [[nodiscard]] glm::dvec3 normal(const glm::dvec3& weights) const {
        return glm::normalize(mixed(normals, weights));
    }
    [[nodiscard]] glm::dvec2 texCoord(const glm::dvec3& weights) const { return mixed(texCoords, weights); }

  private:
    static glm::dvec3 mixed(const std::array<glm::dvec3, 3>& of, const glm::dvec3& weights) {
        return weights[0] * of[0] + weights[1] * of[1] + weights[2] * of[2];
    }
};

/// Calls visit(const Triangle&, const glm::dvec3& weights) at (cells + 1)(cells + 2) / 2 points of every
/// triangle that has an area, including its corners and edges. The mesh has normals and texture coordinates.
template <class Visit>
void forEachTriangle(const geometry::Mesh& mesh, int cells, const Visit& visit) {
    const std::vector<glm::dvec3> positions = vectorsOf(mesh, geometry::kPosition),
                                  normals = vectorsOf(mesh, geometry::kNormal),
                                  texCoords = vectorsOf(mesh, geometry::kTexCoord);
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        Triangle triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = mesh.indices[first + i];
            triangle.vertices[i] = vertex;
            triangle.positions[i] = positions[vertex];
            triangle.normals[i] = normals[vertex];
            triangle.texCoords[i] = texCoords[vertex];
        }
        const glm::dvec3 across = glm::cross(triangle.positions[1] - triangle.positions[0],
                                             triangle.positions[2] - triangle.positions[0]);
        const double area = glm::length(across);
        if (!(area > 0)) continue;
        triangle.faceNormal = across / area;
        for (int i = 0; i <= cells; ++i)
            for (int j = 0; i + j <= cells; ++j)
                visit(triangle, glm::dvec3(i, j, cells - i - j) / static_cast<double>(cells));
    }
}

/// The distance of a mesh from a surface, measured at a net of points on every triangle.
struct MeshError {
    double distance = 0;    ///< largest
    double normal = 0;      ///< largest angle in degrees between the interpolated normal and the surface's
    double faceNormal = 0;  ///< the same for the normals of the triangles
};
inline MeshError meshError(const geometry::Mesh& mesh, FootOn foot) {
    MeshError largest;
    forEachTriangle(mesh, 6, [&](const Triangle& triangle, const glm::dvec3& weights) {
        const Foot at = foot(triangle.position(weights) / kSolidRadius, triangle.faceNormal);
        largest.distance = std::max(largest.distance, at.distance);
        if (!at.hasNormal) return;
        largest.normal = std::max(largest.normal, angleBetween(triangle.normal(weights), at.normal));
        largest.faceNormal = std::max(largest.faceNormal, angleBetween(triangle.faceNormal, at.normal));
    });
    return largest;
}

/// The same for a mesh of the unit sphere scaled by kSolidRadius.
inline MeshError sphereError(const geometry::Mesh& mesh) {
    return meshError(mesh, footOnSphere);
}

/// The volume of a closed mesh in cubed radii; positive if triangles are counter-clockwise seen from outside.
inline double signedVolume(const geometry::Mesh& mesh) {
    const std::vector<glm::dvec3> p = vectorsOf(mesh, geometry::kPosition);
    double six = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        six += glm::dot(p[mesh.indices[i]], glm::cross(p[mesh.indices[i + 1]], p[mesh.indices[i + 2]]));
    return six / (6 * kSolidRadius * kSolidRadius * kSolidRadius);
}

/// Bytes of vertices and indices together.
inline double meshBytes(const geometry::Mesh& mesh) {
    std::size_t values = mesh.indices.size();
    for (const geometry::Attribute& each : mesh.attributes) values += each.values.size();
    return 4. * static_cast<double>(values);
}

inline constexpr double kOutlineRadius = 512;  ///< pixels of a radius where outlines are compared
/// The largest distance between the outlines of mesh and solid in three views without perspective: the
/// largest difference of the extents of their convex hulls in 360 directions per view. `extent` is the
/// largest dot(p, direction) over the solid (support function), for a unit direction.
inline double outlineError(const geometry::Mesh& mesh,
                           const std::function<double(const glm::dvec3&)>& extent) {
    constexpr int kDirections = 360;
    const std::vector<glm::dvec3> positions = vectorsOf(mesh, geometry::kPosition);
    const std::array<std::array<glm::dvec3, 2>, 3> views{{
        {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)},
        {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1)},
        {glm::dvec3(.6, .48, .64), glm::dvec3(0, .8, -.6)},
    }};
    double largest = 0;
    for (const auto& [right, up] : views)
        for (int i = 0; i < kDirections; ++i) {
            // The golden section spreads the directions so that they meet slices at every phase.
            const double angle = 2 * std::numbers::pi * i * std::numbers::phi;
            const glm::dvec3 direction = std::cos(angle) * right + std::sin(angle) * up;
            double farthest = -1e300;
            for (const glm::dvec3& p : positions) farthest = std::max(farthest, glm::dot(p, direction));
            largest = std::max(largest, std::abs(farthest / kSolidRadius - extent(direction)));
        }
    return largest;
}

}  // namespace glibra::bench
