#include "geometry/list_topology.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "base/text.h"

namespace glibra::geometry {
namespace {

using Indices = std::vector<std::uint32_t>;

void putIndices(Indices& indices, std::initializer_list<std::uint32_t> more) {
    indices.insert(indices.end(), more);
}

/// Returns triangle i of a strip with adjacency that has `count` triangles (OpenGL 4.6 core, table 10.1).
/// Even vertices form the strip; odd ones are the neighbours across its outer edges. Across an inner edge the
/// neighbour is the far corner of the next triangle.
void putStripAdjacency(Indices& indices, std::uint32_t i, std::uint32_t count) {
    const std::uint32_t at = 2 * i;
    const std::uint32_t before = i == 0 ? 1 : at - 2;
    const std::uint32_t after = i + 1 == count ? at + 5 : at + 6;
    if (i % 2 == 0)
        putIndices(indices, {at, before, at + 2, after, at + 4, at + 3});
    else
        putIndices(indices, {at + 2, before, at, at + 3, at + 4, after});
}

}  // namespace

std::optional<ListTopology> listTopology(std::string_view word) {
    const std::string plain = base::lower(word.substr(0, 64));
    std::string_view bare = plain;
    if (bare.starts_with("gl_")) bare.remove_prefix(3);
    const auto* const found = std::ranges::find(kListTopologyWords, bare);
    if (found == kListTopologyWords.end()) return std::nullopt;
    return static_cast<ListTopology>(found - kListTopologyWords.begin());
}

Topology meshTopology(ListTopology topology) {
    switch (topology) {
        case ListTopology::points:
            return Topology::points;
        case ListTopology::lines:
        case ListTopology::lineStrip:
        case ListTopology::lineLoop:
            return Topology::lines;
        case ListTopology::linesAdjacency:
        case ListTopology::lineStripAdjacency:
            return Topology::linesAdjacency;
        case ListTopology::trianglesAdjacency:
        case ListTopology::triangleStripAdjacency:
            return Topology::trianglesAdjacency;
        case ListTopology::patches:
            return Topology::patches;
        default:
            return Topology::triangles;
    }
}

ListIndices listIndices(ListTopology topology, std::size_t count, int patchVertices) {
    Indices out;
    const auto n = static_cast<std::uint32_t>(count);
    // Primitives that share vertices: the first takes `least` vertices, each further one `step` more.
    const auto shared = [&](std::uint32_t least, std::uint32_t step, auto putPrimitive) {
        if (n < least) return n;
        const std::uint32_t primitives = (n - least) / step + 1;
        for (std::uint32_t i = 0; i < primitives; ++i) putPrimitive(i, primitives);
        return (n - least) % step;
    };
    std::uint32_t dropped = 0;
    switch (topology) {
        case ListTopology::points:
        case ListTopology::lines:
        case ListTopology::triangles:
        case ListTopology::linesAdjacency:
        case ListTopology::trianglesAdjacency:
        case ListTopology::patches: {
            const int size = verticesPerPrimitive(meshTopology(topology), patchVertices);
            assert(size >= 1);
            dropped = n % static_cast<std::uint32_t>(size);
            out.resize(n - dropped);
            std::iota(out.begin(), out.end(), 0U);
            break;
        }
        case ListTopology::lineStrip:
        case ListTopology::lineLoop:
            dropped = shared(2, 1, [&](std::uint32_t i, std::uint32_t) { putIndices(out, {i, i + 1}); });
            if (topology == ListTopology::lineLoop && n >= 2) putIndices(out, {n - 1, 0});
            break;
        case ListTopology::triangleStrip:
            dropped = shared(3, 1, [&](std::uint32_t i, std::uint32_t) {
                putIndices(out, {i + i % 2, i + 1 - i % 2, i + 2});
            });
            break;
        case ListTopology::triangleFan:
        case ListTopology::polygon:
            dropped =
                shared(3, 1, [&](std::uint32_t i, std::uint32_t) { putIndices(out, {0, i + 1, i + 2}); });
            break;
        case ListTopology::quads:
            for (std::uint32_t a = 0; a + 4 <= n; a += 4) putIndices(out, {a, a + 1, a + 2, a, a + 2, a + 3});
            dropped = n % 4;
            break;
        case ListTopology::quadStrip:
            dropped = shared(4, 2, [&](std::uint32_t i, std::uint32_t) {
                const std::uint32_t a = 2 * i;
                putIndices(out, {a, a + 1, a + 3, a, a + 3, a + 2});
            });
            break;
        case ListTopology::lineStripAdjacency:
            dropped = shared(
                4, 1, [&](std::uint32_t i, std::uint32_t) { putIndices(out, {i, i + 1, i + 2, i + 3}); });
            break;
        case ListTopology::triangleStripAdjacency:
            dropped =
                shared(6, 2, [&](std::uint32_t i, std::uint32_t all) { putStripAdjacency(out, i, all); });
            break;
    }
    return {std::move(out), dropped};
}

}  // namespace glibra::geometry
