#include "classic/vertex_lists.h"

#include <glad/gl.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "geometry/list_mesh.h"

namespace glibra::classic {
namespace {

using geometry::ListTopology;

constexpr GLenum kQuads = 0x0007;  // glad knows the core profile
constexpr GLenum kQuadStrip = 0x0008;
constexpr GLenum kPolygon = 0x0009;

struct ListRow {
    GLenum topology;
    ListTopology list;
    bool isCore;
    int patchVertices;  ///< of a separate primitive of it
};
constexpr ListRow kRows[] = {{GL_POINTS, ListTopology::points, true, 1},
                             {GL_LINES, ListTopology::lines, true, 2},
                             {GL_LINE_LOOP, ListTopology::lineLoop, true, 2},
                             {GL_LINE_STRIP, ListTopology::lineStrip, true, 2},
                             {GL_TRIANGLES, ListTopology::triangles, true, 3},
                             {GL_TRIANGLE_STRIP, ListTopology::triangleStrip, true, 3},
                             {GL_TRIANGLE_FAN, ListTopology::triangleFan, true, 3},
                             {kQuads, ListTopology::quads, false, 4},
                             {kQuadStrip, ListTopology::quadStrip, false, 4},
                             {kPolygon, ListTopology::polygon, false, 3},
                             {GL_LINES_ADJACENCY, ListTopology::linesAdjacency, true, 4},
                             {GL_LINE_STRIP_ADJACENCY, ListTopology::lineStripAdjacency, true, 4},
                             {GL_TRIANGLES_ADJACENCY, ListTopology::trianglesAdjacency, true, 6},
                             {GL_TRIANGLE_STRIP_ADJACENCY, ListTopology::triangleStripAdjacency, true, 6},
                             {GL_PATCHES, ListTopology::patches, true, 0}};

const ListRow* rowOf(GLenum topology) {
    const auto* found = std::ranges::find(kRows, topology, &ListRow::topology);
    return found != std::end(kRows) ? found : nullptr;
}

/// The corners of whole quads, in the order around each.
std::vector<std::uint32_t> quadCorners(ListTopology topology, std::size_t count) {
    std::vector<std::uint32_t> corners;
    const bool isStrip = topology == ListTopology::quadStrip;
    for (std::uint32_t i = 0; i + 4 <= count; i += isStrip ? 2 : 4)
        for (const std::uint32_t each : {0U, 1U, isStrip ? 3U : 2U, isStrip ? 2U : 3U})
            corners.push_back(i + each);
    return corners;
}

/// One primitive or more, between restarts, as vertices that count from 0.
std::vector<std::uint32_t> pieceIndices(const ListRow& row, std::size_t count, int patchVertices,
                                        bool asPatches) {
    if (asPatches && row.patchVertices == 4 && !row.isCore) return quadCorners(row.list, count);
    if (asPatches || !row.isCore) return geometry::listIndices(row.list, count, patchVertices).indices;
    std::vector<std::uint32_t> indices(count);
    std::iota(indices.begin(), indices.end(), 0U);
    return indices;
}

}  // namespace

bool isTopology(unsigned int topology) {
    return rowOf(topology) != nullptr;
}

VertexLists::VertexLists() {
    columns_.push_back({.name = "aVertex", .components = 3});
}

VertexColumn& VertexLists::column(std::string_view name, int components) {
    auto found = std::ranges::find(columns_, name, &VertexColumn::name);
    if (found == columns_.end()) {
        found = columns_.insert(columns_.end(), {.name = std::string(name)});
        if (name == "aColor") found->fill = {1, 1, 1, 1};
        if (name == "aNormal") found->fill = {0, 0, 1, 1};
        found->current = found->fill;
    }
    if (components > found->components) {  // the values so far get the components that they lack
        std::vector<float> wider;
        wider.reserve(count_ * static_cast<std::size_t>(components));
        for (std::size_t i = 0; i < count_; ++i)
            for (int c = 0; c < components; ++c)
                wider.push_back(c < found->components
                                    ? found->values[i * static_cast<std::size_t>(found->components) +
                                                    static_cast<std::size_t>(c)]
                                    : found->fill[static_cast<std::size_t>(c)]);
        found->values = std::move(wider);
        found->components = components;
    }
    return *found;
}

void VertexLists::setCurrent(std::string_view name, const std::array<float, 4>& value, int components) {
    column(name, components).current = value;
}

void VertexLists::add(const std::array<float, 4>& position, int components) {
    VertexColumn& place =
        components > columns_.front().components ? column("aVertex", components) : columns_.front();
    place.current = position;
    for (VertexColumn& each : columns_)
        each.values.insert(each.values.end(), each.current.begin(), each.current.begin() + each.components);
    ++count_;
}

DrawnIndices drawnIndices(const std::vector<VertexList>& lists, const std::vector<std::uint32_t>& vertexOf,
                          bool asPatches) {
    DrawnIndices drawn;
    drawn.indices.reserve(vertexOf.size());
    for (const VertexList& list : lists) {
        const ListRow& row = *rowOf(list.topology);
        DrawnList& made = drawn.lists.emplace_back();
        made.firstIndex = static_cast<std::uint32_t>(drawn.indices.size());
        const bool isSplit = asPatches || !row.isCore;
        made.mode = asPatches ? GL_PATCHES : row.isCore ? row.topology : GL_TRIANGLES;
        made.patchVertices = row.patchVertices != 0 ? row.patchVertices : list.patchVertices;
        std::size_t begin = list.first;
        for (std::size_t i = 0; i <= list.restarts.size(); ++i) {
            const std::size_t end = i < list.restarts.size() ? list.restarts[i] : list.first + list.count;
            if (begin == end) continue;
            if (!isSplit && drawn.indices.size() > made.firstIndex) {
                drawn.indices.push_back(kRestart);
                made.hasRestarts = true;
            }
            for (const std::uint32_t each : pieceIndices(row, end - begin, list.patchVertices, asPatches))
                drawn.indices.push_back(vertexOf[begin + each]);
            begin = end;
        }
        made.count = static_cast<std::uint32_t>(drawn.indices.size()) - made.firstIndex;
    }
    return drawn;
}

}  // namespace glibra::classic
