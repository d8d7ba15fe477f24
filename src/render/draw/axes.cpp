#include "render/draw/axes.h"

#include <embedded/builtin_shaders.h>
#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <utility>
#include <vector>

#include "gpu/object/reflection.h"
#include "gpu/object/uniform.h"

namespace glibra::render {
namespace {

/// One end of a line.
struct Vertex {
    std::array<float, 3> position;
};

using Stroke = std::pair<std::array<float, 2>, std::array<float, 2>>;

constexpr float kLength = 2.0F;
constexpr float kLetter = 0.2F;

/// Strokes of the letters in the unit square.
const std::array<std::vector<Stroke>, 3> kLetters{
    {{{{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}},
     {{{0, 1}, {.5F, .5F}}, {{1, 1}, {.5F, .5F}}, {{.5F, .5F}, {.5F, 0}}},
     {{{0, 1}, {1, 1}}, {{1, 1}, {0, 0}}, {{0, 0}, {1, 0}}}}};

std::vector<Vertex> vertices() {
    std::vector<Vertex> lines;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<float, 3> end{};
        end[axis] = kLength;
        lines.push_back({{0, 0, 0}});
        lines.push_back({end});
        // The letter is upright in a plane parallel to XY, just past the end.
        end[axis] += kLetter / 2;
        const auto corner = [&](const std::array<float, 2>& at) {
            const float shift = axis == 1 ? -kLetter / 2 : 0;
            const float rise = axis == 1 ? 0 : -kLetter / 2;
            return std::array<float, 3>{end[0] + shift + at[0] * kLetter, end[1] + rise + at[1] * kLetter,
                                        end[2]};
        };
        for (const auto& [from, to] : kLetters[axis]) {
            lines.push_back({corner(from)});
            lines.push_back({corner(to)});
        }
    }
    return lines;
}

/// The projection of the last draw into the window that has one.
scene::Projection lastProjection(const scene::Scene& scene) {
    scene::Projection projection;
    for (const scene::Pass& pass : scene.frame.passes) {
        if (!pass.isWindow) continue;
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<scene::Draw>(&step);
                draw && !std::holds_alternative<scene::ClipSpace>(draw->projection))
                projection = draw->projection;
    }
    return projection;
}

}  // namespace

Axes::Axes(gpu::Program program, base::ActiveUniform matrix, gpu::Buffer vertices, gpu::VertexArray lines,
           int count)
    : program_(std::move(program)),
      matrix_(std::move(matrix)),
      vertices_(std::move(vertices)),
      lines_(std::move(lines)),
      count_(count) {}

Result<Axes> Axes::create(const gpu::Context& context) {
    const std::array<gpu::StageSource, 2> stages{{{GL_VERTEX_SHADER, builtin_shaders::axes_vert()},
                                                  {GL_FRAGMENT_SHADER, builtin_shaders::axes_frag()}}};
    gpu::BuildOutcome built =
        gpu::buildProgram(context.capabilities(),
                          {.stages = stages, .vertexInputs = {{"aPosition", 0}}, .fragmentOutputs = {}});
    if (!built.program)
        return diagnose("gpu-E02", "the driver does not link the program of --axes: " + built.linkLog);
    const base::ActiveResources resources = gpu::reflect(*built.program);
    const std::vector<Vertex> lines = vertices();
    Result<gpu::Buffer> buffer = gpu::Buffer::create(std::as_bytes(std::span(lines)));
    if (!buffer) return std::move(buffer.diagnostics);
    const std::array<gpu::AttributeSource, 1> sources{
        {{.buffer = &*buffer, .location = 0, .components = 3, .stride = sizeof(Vertex)}}};
    gpu::VertexArray array(sources);
    return Axes(std::move(*built.program), resources.uniforms.front(), std::move(*buffer), std::move(array),
                static_cast<int>(lines.size()));
}

void Axes::draw(const scene::Scene& scene, const ViewMatrices& view, const Tile& tile, int width,
                int height) const {
    const double aspect = static_cast<double>(width) / height;
    // The tile's part of clip space, as for the scene's own programs.
    glm::dmat4 part(1.0);
    part[0][0] = static_cast<double>(width) / tile.width;
    part[1][1] = static_cast<double>(height) / tile.height;
    part[3][0] = (width - 2.0 * tile.x - tile.width) / tile.width;
    part[3][1] = (height - 2.0 * tile.y - tile.height) / tile.height;
    const glm::dmat4 matrix = part * view.projection(lastProjection(scene), aspect) * view.worldView();
    program_.use();
    gpu::setUniform(program_, matrix_, {glm::value_ptr(matrix), 16});
    lines_.bind();
    glDisable(GL_BLEND);
    glLineWidth(1);
    glDrawArrays(GL_LINES, 0, count_);
}

}  // namespace glibra::render
