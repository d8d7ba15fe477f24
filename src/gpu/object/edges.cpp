#include "gpu/object/edges.h"

#include <bit>
#include <limits>
#include <numeric>
#include <utility>

namespace glibra::gpu {

std::vector<std::uint32_t> edgesOf(std::span<const std::uint32_t> indices, GLenum mode) {
    constexpr std::uint32_t kRestart = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> edges;
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        edges.insert(edges.end(), {a, b, b, c, c, a});
    };
    const bool areLines = mode == GL_LINES || mode == GL_LINE_STRIP || mode == GL_LINE_LOOP;
    std::size_t first = 0;
    const auto close = [&](std::size_t end) {
        if (mode == GL_LINE_LOOP && end > first + 1)
            edges.insert(edges.end(), {indices[end - 1], indices[first]});
    };
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] == kRestart) {
            close(i);
            first = i + 1;
            continue;
        }
        const std::size_t place = i - first;
        if (areLines) {
            if (place > 0 && (mode != GL_LINES || place % 2 == 1))
                edges.insert(edges.end(), {indices[i - 1], indices[i]});
            continue;
        }
        if (place < 2 || (mode == GL_TRIANGLES && place % 3 != 2)) continue;
        triangle(mode == GL_TRIANGLE_FAN ? indices[first] : indices[i - 2], indices[i - 1], indices[i]);
    }
    close(indices.size());
    return edges;
}

void EdgeBuffers::draw(const Buffer* indices, std::size_t offset, int count, GLenum mode, int instances) {
    // Those of fewer triangles are the first of those of more.
    const bool isPart = indices == nullptr && mode == GL_TRIANGLES;
    const std::uint32_t all = static_cast<std::uint32_t>(count);
    const Key key{indices != nullptr ? indices->id() : 0, offset, isPart ? std::bit_ceil(all) : all, mode};
    auto known = made_.find(key);
    const std::uint64_t content = indices != nullptr ? indices->content() : 0;
    if (known == made_.end() || known->second.content != content) {
        std::vector<std::uint32_t> read(std::get<2>(key));
        if (indices != nullptr)
            indices->read(offset, std::as_writable_bytes(std::span(read)));
        else
            std::iota(read.begin(), read.end(), 0U);
        const std::vector<std::uint32_t> edges = edgesOf(read, mode);
        Result<Buffer> buffer = Buffer::create(std::as_bytes(std::span(edges)));
        if (!buffer) return;
        known =
            made_.insert_or_assign(key, Edges{std::move(*buffer), static_cast<int>(edges.size()), content})
                .first;
    }
    // The buffer of indices is a part of the vertex array.
    known->second.buffer.bind(GL_ELEMENT_ARRAY_BUFFER);
    glDrawElementsInstanced(GL_LINES, isPart ? count / 3 * 6 : known->second.count, GL_UNSIGNED_INT, nullptr,
                            instances);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices != nullptr ? indices->id() : 0);
}

}  // namespace glibra::gpu
