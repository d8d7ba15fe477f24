#pragma once
// Builds the meshes of shapes, and the parts that surfaces of revolution share.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

#include "geometry/mesh.h"

namespace glibra::geometry {

// Builds the mesh of a shape: values in double are rounded once to float and stored in arrays of exactly the
// announced size.

struct SurfacePoint {
    glm::dvec3 position{0};
    glm::dvec3 normal{0, 0, 1};
    glm::dvec3 tangent{0, 1, 0};
    glm::dvec3 texCoord{0};  ///< s, t, p
};

/// A mesh under construction. Exactly as many vertices and primitives must be added as the constructor was
/// given.
class Surface {
  public:
    /// `texCoordComponents` is 2 (s, t) or 3 (s, t, p).
    Surface(Topology topology, int texCoordComponents, const Counts& counts);

    /// The index of the next vertex.
    [[nodiscard]] std::uint32_t size() const { return size_; }
    void add(const SurfacePoint& point);

    void point(std::uint32_t a);
    void segment(std::uint32_t a, std::uint32_t b);
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    /// Adds a cell with the corners 00, 10, 11, 01, counter-clockwise, as (00, 10, 11) and (00, 11, 01).
    void cell(std::uint32_t a00, std::uint32_t a10, std::uint32_t a11, std::uint32_t a01);

    /// Adds all cells of a grid of (columns + 1) x (rows + 1) vertices, s fastest, the first vertex being
    /// `base`.
    void gridCells(std::uint32_t base, std::uint32_t columns, std::uint32_t rows);

    [[nodiscard]] Mesh finish() &&;

  private:
    Mesh mesh_;
    std::uint32_t capacity_;
    std::uint32_t size_ = 0;
    std::size_t indexCount_ = 0;
};

/// The edges of a grid that are drawn: rows firstRow <= j < endRow along s, columns 0 <= i < endColumn along
/// t. The second copy of a seam, or a row that is one point, is left out.
struct GridEdges {
    std::uint32_t columns = 0, rows = 0;
    std::uint32_t firstRow = 0, endRow = 0, endColumn = 0;
};

void addGridEdges(Surface& surface, std::uint32_t base, const GridEdges& edges);

// Parts of surfaces of revolution: bands, caps and rings. Cylinders, cones, disks and arrows consist of them.

/// A right-handed frame: zero x quarter = along. All three are unit vectors along coordinate axes.
struct Axis {
    glm::dvec3 along;    ///< the axis of revolution
    glm::dvec3 zero;     ///< where s = 0
    glm::dvec3 quarter;  ///< where s = 1/4
};

/// The axis of shapes that stand on the plane y = 0.
inline const Axis kStanding{.along = {0, 1, 0}, .zero = {-1, 0, 0}, .quarter = {0, 0, 1}};

/// A straight profile from (startAlong, startRadius) to (endAlong, endRadius), in equal rows with t from
/// startT to endT. If `apex` is set, endRadius is 0, and the apex has one vertex per slice.
struct Band {
    double startAlong = 0, startRadius = 0, startT = 0;
    double endAlong = 0, endRadius = 0, endT = 1;
    int rows = 1;
    bool apex = false;
};

/// A flat disk or ring across the axis. s and t are the coordinates along sDirection and tDirection, from 0
/// to 1 across the outer circle. The normal is sDirection x tDirection, which is +along or -along.
struct Cap {
    double along = 0, radius = 0;
    glm::dvec3 sDirection, tDirection;
};

/// Adds the vertices of the band, row after row. `circle` is unitCircle(slices). Normals point away from the
/// axis; the direction of s, the direction of t and the normal are right-handed.
void addBandPoints(Surface& surface, const Axis& axis, const Band& band, std::span<const glm::dvec2> circle);
void addBandCells(Surface& surface, std::uint32_t base, const Band& band, std::uint32_t slices);
/// Of a band whose first point is the first of the surface.
void addBandEdges(Surface& surface, const Band& band, std::uint32_t slices);

/// Adds a cap: the centre once per slice, then `rings` circles at equal steps of the radius, and the
/// triangles.
void addCap(Surface& surface, const Axis& axis, const Cap& cap, int rings,
            std::span<const glm::dvec2> circle);

/// Adds the part of a cap outside innerRadius, one cell wide: inner circle, outer circle, cells. The cap's
/// normal is -along.
void addBackRing(Surface& surface, const Axis& axis, const Cap& cap, double innerRadius,
                 std::span<const glm::dvec2> circle);

}  // namespace glibra::geometry
