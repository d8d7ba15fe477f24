#pragma once
// The vertices and lists that a VertexArray was given, and what is drawn of them. It needs no GL.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::classic {

/// Stands in indices where a primitive ends and the next one begins.
inline constexpr std::uint32_t kRestart = 0xffffffffU;

/// A value per vertex. What was not given reads `fill`.
struct VertexColumn {
    std::string name;
    int components = 0;  ///< of the widest value so far
    std::array<float, 4> fill{0, 0, 0, 1};
    std::array<float, 4> current = fill;
    std::vector<float> values{};  ///< `components` for each vertex
};

/// From glBegin to glEnd.
struct VertexList {
    unsigned int topology = 0;
    int patchVertices = 3;
    std::size_t first = 0;
    std::size_t count = 0;
    std::vector<std::size_t> restarts;  ///< vertices that begin another primitive
};

/// A list as it is drawn.
struct DrawnList {
    unsigned int mode = 0;
    int patchVertices = 3;
    std::uint32_t firstIndex = 0;
    std::uint32_t count = 0;
    bool hasRestarts = false;
};

struct DrawnIndices {
    std::vector<std::uint32_t> indices;
    std::vector<DrawnList> lists;
};

class VertexLists {
  public:
    VertexLists();

    /// The current value of a column from now on.
    void setCurrent(std::string_view name, const std::array<float, 4>& value, int components);
    /// A vertex with the current value of every column.
    void add(const std::array<float, 4>& position, int components);

    [[nodiscard]] std::size_t count() const { return count_; }
    /// The position, aVertex, is the first.
    [[nodiscard]] const std::vector<VertexColumn>& columns() const { return columns_; }
    [[nodiscard]] const std::vector<VertexList>& lists() const { return lists_; }
    std::vector<VertexList>& lists() { return lists_; }

  private:
    VertexColumn& column(std::string_view name, int components);

    std::vector<VertexColumn> columns_;
    std::vector<VertexList> lists_;
    std::size_t count_ = 0;
};

/// The vertices that remain, and which of them each given vertex is.
struct Collapsed {
    std::vector<VertexColumn> columns;
    std::vector<std::uint32_t> vertexOf;
    std::size_t count = 0;
};

/// A vertex becomes the first one before it whose coordinates differ by at most `tolerance` each, and whose
/// other values are the same; a vertex that became another one attracts none. The time is linear. Vertices
/// with NaN stay.
Collapsed collapse(const VertexLists& from, float tolerance);
/// All vertices as they are.
Collapsed uncollapsed(const VertexLists& from);

/// The indices of all lists. Quads, quad strips and polygons become triangles, as in geometry::listIndices.
/// With `asPatches`, for programs that tessellate, each point, line, triangle or quad becomes a patch of its
/// vertices.
DrawnIndices drawnIndices(const std::vector<VertexList>& lists, const std::vector<std::uint32_t>& vertexOf,
                          bool asPatches);

/// True for what glBegin takes.
bool isTopology(unsigned int topology);

}  // namespace glibra::classic
