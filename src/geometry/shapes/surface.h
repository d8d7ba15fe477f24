#pragma once
// Builds the mesh of a shape: values in double are rounded once to float and stored in arrays of exactly the
// announced size.

#include <cstdint>
#include <glm/vec3.hpp>

#include "geometry/counts.h"
#include "geometry/mesh.h"

namespace glibra::geometry {

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

}  // namespace glibra::geometry
