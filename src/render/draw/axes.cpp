#include "render/draw/axes.h"

#include <embedded/builtin_shaders.h>
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/gtc/type_ptr.hpp>
#include <set>
#include <tuple>
#include <utility>

#include "gpu/state/state_tracker.h"
#include "image/text.h"
#include "plan/uniform_names.h"

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

/// The last draw into the window that has a projection, or one with the usual state.
const scene::Draw& lastDraw(const scene::Scene& scene) {
    static const scene::Draw kUsual;
    const scene::Draw* last = nullptr;
    scene.frame.visitDraws([&](const scene::Draw& draw, const scene::Pass& pass) {
        if (pass.isWindow && !std::holds_alternative<scene::ClipSpace>(*draw.projection)) last = &draw;
    });
    return last != nullptr ? *last : kUsual;
}

}  // namespace

Axes::Axes(const gpu::Capabilities& driver, gpu::Program program, gpu::Buffer vertices,
           gpu::VertexArray lines, int count)
    : driver_(&driver),
      program_(std::move(program)),
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
    return Axes(context.capabilities(), std::move(*built.program), std::move(*buffer), std::move(array),
                static_cast<int>(lines.size()));
}

void Axes::draw(const gpu::Target& target, const scene::Scene& scene, const ViewMatrices& view,
                const Tile& tile, int width, int height) const {
    const double aspect = static_cast<double>(width) / height;
    const scene::Draw& last = lastDraw(scene);
    const glm::mat4 matrix(view.projection(last, aspect) * view.worldView());
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
    gpu::RasterTracker raster(*driver_);
    raster.targetBound(tile.width, tile.height);
    base::RasterState state;
    state.depthOrder = last.raster->depthOrder;
    if (state.depthOrder != base::DepthOrder::usual) raster.apply(state);
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, count_);
    if (state.depthOrder != base::DepthOrder::usual) raster.apply({});
}

namespace {

constexpr int kLabelMargin = 4;  ///< pixels around the block, at scale 1

std::string valueText(const std::vector<double>& values, const plan::ValueType& type) {
    std::string text;
    for (const double each : values) {
        if (!text.empty()) text += ' ';
        if (type.base == plan::BaseType::boolean)
            text += each != 0 ? "true" : "false";
        else
            text += fmt::format("{:.{}f}", each, type.isInteger() ? 0 : 4);
    }
    return text;
}

std::string labelOf(const scene::Variable& variable) {
    std::string value;
    if (!variable.words.empty()) {
        const auto chosen = static_cast<std::size_t>(std::max(0.0, variable.current.front()));
        value = variable.words.at(std::min(chosen, variable.words.size() - 1));
    } else {
        plan::ValueType type;
        if (variable.form == glib::UniformForm::truth) type.base = plan::BaseType::boolean;
        value = valueText(variable.current, type);
    }
    return variable.name + " = " + value;
}

/// The value of the binding that a tag names; null if there is none that a user could see as a number.
const std::vector<double>* valuesOf(const plan::PlannedProgram& planned, const plan::NamedUniform& named) {
    for (const plan::UniformBinding& each : planned.values) {
        const auto* literal = std::get_if<plan::Literal>(&each.value);
        if (literal && each.uniform == named.uniform && each.firstElement == named.element &&
            !literal->values.empty())
            return &literal->values;
    }
    return nullptr;
}

}  // namespace

std::string titleOf(const scene::Scene& scene, scene::ProgramIndex program) {
    const std::string& name = scene.programs[program].name;
    int sameName = 0;
    int before = 0;
    for (const scene::ProgramIndex i : scene.programs.indices()) {
        if (scene.programs[i].name != name) continue;
        ++sameName;
        if (i <= program) ++before;
    }
    return sameName > 1 ? fmt::format("{} ({})", name, before) : name;
}

std::vector<std::string> labelsOf(const scene::Scene& scene, std::span<const plan::FramePlan* const> plans) {
    std::vector<std::string> lines;
    for (const scene::Variable& each : scene.variables) lines.push_back(labelOf(each));
    std::vector<const plan::PlannedProgram*> programs;
    for (const plan::FramePlan* plan : plans)
        for (const plan::PlannedProgram& each : plan->programs)
            if (each.variant.program && each.interface->usable) programs.push_back(&each);
    std::ranges::stable_sort(
        programs, [](const auto* a, const auto* b) { return a->variant.program < b->variant.program; });
    std::set<std::pair<scene::ProgramIndex, std::string>> known;  // a program may be planned in variants
    for (const plan::PlannedProgram* planned : programs) {
        const plan::UniformNames names(*planned->interface);
        for (const glib::UniformSpec& spec : scene.programs[planned->variant.program].uniforms)
            for (const plan::NamedUniform& named : names.find(spec.tag)) {
                const plan::ValueType& type = at(planned->interface->uniforms, named.uniform).type;
                const std::vector<double>* values = valuesOf(*planned, named);
                if (!values || type.isOpaque() || !known.emplace(planned->variant.program, spec.tag).second)
                    continue;
                lines.push_back(fmt::format("{} : {} = {}", titleOf(scene, planned->variant.program),
                                            spec.tag, valueText(*values, type)));
            }
    }
    return lines;
}

LabelBlock labelBlock(int width, int height, std::vector<std::string> lines, LabelCorner corner) {
    constexpr int kRowsPerScale = 720;
    LabelBlock block;
    block.scale = std::max(1, (height + kRowsPerScale / 2) / kRowsPerScale);
    const int margin = kLabelMargin * block.scale;
    const auto most =
        static_cast<std::size_t>(std::max(0, height - 2 * margin) / (image::kLineHeight * block.scale));
    if (lines.size() > most) {
        const std::size_t left = lines.size() - most + 1;
        lines.resize(most);
        if (most > 0) lines.back() = fmt::format("... and {} more", left);
    }
    std::size_t longest = 0;
    for (const std::string& each : lines) longest = std::max(longest, each.size());
    // A pixel more on each side for the outline.
    block.width = (static_cast<int>(longest) * image::kCharacterWidth + 2) * block.scale;
    block.height = static_cast<int>(lines.size()) * image::kLineHeight * block.scale;
    const bool isRight = corner == LabelCorner::bottomRight || corner == LabelCorner::topRight;
    const bool isTop = corner == LabelCorner::topLeft || corner == LabelCorner::topRight;
    block.left = isRight ? std::max(margin, width - margin - block.width) : margin;
    block.top = isTop ? margin : height - margin - block.height;
    block.lines = std::move(lines);
    return block;
}

void drawLabels(image::Image& picture, const LabelBlock& block, int left, int top) {
    for (const std::string& each : block.lines) {
        image::drawText(picture, left + block.scale, top, each, block.scale);
        top += image::kLineHeight * block.scale;
    }
}

}  // namespace glibra::render
