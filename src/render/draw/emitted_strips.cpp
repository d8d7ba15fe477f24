#include "render/draw/emitted_strips.h"

#include <algorithm>
#include <cstddef>

namespace glibra::render {

std::vector<std::uint32_t> indicesOf(const EmittedStrips& strips, int corners) {
    std::vector<std::uint32_t> indices;
    std::uint32_t first = 0;  // of the strip
    for (std::uint32_t i = 0; i < strips.vertices; ++i) {
        if ((strips.begins.at(i / 32) >> (i % 32) & 1U) != 0) first = i;
        const std::uint32_t place = i - first;
        if (place + 1 < static_cast<std::uint32_t>(corners)) continue;
        for (std::uint32_t each = i + 1 - static_cast<std::uint32_t>(corners); each <= i; ++each)
            indices.push_back(each);
        if (corners == 3 && place % 2 != 0)
            std::swap(indices[indices.size() - 3], indices[indices.size() - 2]);
    }
    return indices;
}

const StripDrawer::Indices* StripDrawer::indicesFor(const EmittedStrips& strips, int corners) {
    constexpr std::size_t kMostKnown = 64;
    const std::pair key{strips, corners};
    if (const auto known = known_.find(key); known != known_.end()) return &known->second;
    const std::vector<std::uint32_t> indices = indicesOf(strips, corners);
    Result<gpu::Buffer> buffer = gpu::Buffer::create(std::as_bytes(std::span(indices)));
    append(problems_, std::move(buffer.diagnostics));
    if (!buffer) return nullptr;
    if (known_.size() == kMostKnown) {
        known_.clear();
        edges_ = {};  // of these buffers
    }
    return &known_.try_emplace(key, std::move(*buffer), static_cast<int>(indices.size())).first->second;
}

void StripDrawer::draw(const BuiltProgram& built, int count, bool asEdges, const QuadDrawer& quads) {
    const glsl::ExpandedGeometry& expanded = built.interface.facts.expanded;
    constexpr std::array<GLenum, 3> kModes{GL_POINTS, GL_LINES, GL_TRIANGLES};
    const GLenum mode = kModes.at(static_cast<std::size_t>(expanded.ofPrimitive) - 1);
    int vertices = expanded.vertices;
    if (expanded.mostEmitted > 0 && count > 0) {
        std::vector<EmittedStrips> strips(static_cast<std::size_t>(count));
        if (!captured_.read(built, {"glibra_Mode", 2}, count, std::as_writable_bytes(std::span(strips)),
                            problems_))
            return;
        std::size_t most = 0;
        for (EmittedStrips& each : strips) {
            each.vertices = std::min(each.vertices, static_cast<std::uint32_t>(expanded.mostEmitted));
            if (&each == &strips.front() || each != *(&each - 1))
                most = std::max(most, indicesOf(each, expanded.ofPrimitive).size());
        }
        if (most == 0) return;
        if (std::ranges::adjacent_find(strips, std::ranges::not_equal_to()) == strips.end()) {
            const Indices* indices = indicesFor(strips.front(), expanded.ofPrimitive);
            if (indices == nullptr) return;
            setOwnUniform(built, "glibra_Mode", 1);
            if (asEdges && expanded.ofPrimitive == 3) {
                edges_.draw(&indices->buffer, 0, indices->count, GL_TRIANGLES, count);
            } else {
                indices->buffer.bind(GL_ELEMENT_ARRAY_BUFFER);
                glDrawElementsInstanced(mode, indices->count, GL_UNSIGNED_INT, nullptr, count);
            }
            glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);  // a part of the vertex array, which has none
            setOwnUniform(built, "glibra_Mode", 0);
            return;
        }
        vertices = std::min(vertices, static_cast<int>(most));
    }
    if (quads && quads(mode, vertices, count)) return;
    if (asEdges && expanded.ofPrimitive == 3)
        edges_.draw(nullptr, 0, vertices, GL_TRIANGLES, count);
    else
        glDrawArraysInstanced(mode, 0, vertices, count);
}

}  // namespace glibra::render
