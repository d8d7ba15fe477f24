#include "render/draw/axes.h"

#include <embedded/builtin_shaders.h>
#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/gtc/type_ptr.hpp>
#include <utility>
#include <vector>

namespace glibra::render {
namespace {

/// A corner of the rectangle that a line becomes.
struct Vertex {
    std::array<float, 3> from, to;
    std::array<float, 2> corner;  ///< along: 0 or 1; across: -1 or 1
};

using Point = std::array<float, 3>;
using Stroke = std::pair<std::array<float, 2>, std::array<float, 2>>;

constexpr auto kLength = static_cast<float>(kAxisLength);
constexpr float kLetter = kLength / 10;

/// Strokes of the letters in the unit square.
const std::array<std::vector<Stroke>, 3> kLetters{
    {{{{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}},
     {{{0, 1}, {.5F, .5F}}, {{1, 1}, {.5F, .5F}}, {{.5F, .5F}, {.5F, 0}}},
     {{{0, 1}, {1, 1}}, {{1, 1}, {0, 0}}, {{0, 0}, {1, 0}}, {{.25F, .5F}, {.75F, .5F}}}}};

void addLine(std::vector<Vertex>& vertices, const Point& from, const Point& to) {
    constexpr std::array<std::array<float, 2>, 6> kCorners{
        {{0, -1}, {1, -1}, {1, 1}, {0, -1}, {1, 1}, {0, 1}}};
    for (const std::array<float, 2>& corner : kCorners) vertices.push_back({from, to, corner});
}

std::vector<Vertex> vertices() {
    std::vector<Vertex> lines;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Point end{};
        end[axis] = kLength;
        addLine(lines, {0, 0, 0}, end);
        // The letter is upright in a plane parallel to XY, just past the end.
        end[axis] += kLetter;
        const auto corner = [&](const std::array<float, 2>& at) {
            const float shift = axis == 1 ? -kLetter / 2 : 0;
            const float rise = axis == 1 ? 0 : -kLetter / 2;
            return Point{end[0] + shift + at[0] * kLetter, end[1] + rise + at[1] * kLetter, end[2]};
        };
        for (const auto& [from, to] : kLetters[axis]) addLine(lines, corner(from), corner(to));
    }
    return lines;
}

/// The projection of the last draw into the window that has one.
scene::Projection lastProjection(const scene::Scene& scene) {
    scene::Projection projection;
    scene.frame.visitDraws([&](const scene::Draw& draw, const scene::Pass& pass) {
        if (pass.isWindow && !std::holds_alternative<scene::ClipSpace>(draw.projection))
            projection = draw.projection;
    });
    return projection;
}

}  // namespace

Axes::Axes(gpu::Program program, gpu::Buffer vertices, gpu::VertexArray lines, int count)
    : program_(std::move(program)),
      matrix_(glGetUniformLocation(program_.id(), "uMatrix")),
      part_(glGetUniformLocation(program_.id(), "uPart")),
      half_(glGetUniformLocation(program_.id(), "uHalf")),
      vertices_(std::move(vertices)),
      lines_(std::move(lines)),
      count_(count) {}

Result<Axes> Axes::create(const gpu::Context& context) {
    const std::array<gpu::StageSource, 2> stages{{{GL_VERTEX_SHADER, builtin_shaders::axes_vert()},
                                                  {GL_FRAGMENT_SHADER, builtin_shaders::axes_frag()}}};
    gpu::BuildOutcome built =
        gpu::buildProgram(context.capabilities(), {.stages = stages,
                                                   .vertexInputs = {{"aFrom", 0}, {"aTo", 1}, {"aCorner", 2}},
                                                   .fragmentOutputs = {}});
    if (!built.program)
        return diagnose("gpu-E02", "the driver does not link the program of --axes: " + built.linkLog);
    const std::vector<Vertex> lines = vertices();
    Result<gpu::Buffer> buffer = gpu::Buffer::create(std::as_bytes(std::span(lines)));
    if (!buffer) return std::move(buffer.diagnostics);
    const auto source = [&](GLuint location, int components, std::size_t offset) {
        return gpu::AttributeSource{.buffer = &*buffer,
                                    .location = location,
                                    .components = components,
                                    .offset = offset,
                                    .stride = sizeof(Vertex)};
    };
    const std::array<gpu::AttributeSource, 3> sources{source(0, 3, offsetof(Vertex, from)),
                                                      source(1, 3, offsetof(Vertex, to)),
                                                      source(2, 2, offsetof(Vertex, corner))};
    gpu::VertexArray array(sources);
    return Axes(std::move(*built.program), std::move(*buffer), std::move(array),
                static_cast<int>(lines.size()));
}

void Axes::draw(const gpu::Target& target, const scene::Scene& scene, const ViewMatrices& view,
                const Tile& tile, int width, int height) const {
    const double aspect = static_cast<double>(width) / height;
    const glm::mat4 matrix(view.projection(lastProjection(scene), aspect) * view.worldView());
    // The tile's part of clip space, as for the scene's own programs.
    const glm::vec4 part(static_cast<double>(width) / tile.width, static_cast<double>(height) / tile.height,
                         (width - 2.0 * tile.x - tile.width) / tile.width,
                         (height - 2.0 * tile.y - tile.height) / tile.height);
    const double pixels = std::max(kLeastAxisWidth, kAxisWidth * height);
    const glm::vec2 half(pixels / width, pixels / height);
    target.bind();
    program_.use();
    glUniformMatrix4fv(matrix_, 1, GL_FALSE, glm::value_ptr(matrix));
    glUniform4fv(part_, 1, glm::value_ptr(part));
    glUniform2fv(half_, 1, glm::value_ptr(half));
    lines_.bind();
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, count_);
}

}  // namespace glibra::render
