#include "view/debug_view/draw_state.h"

#include <fmt/format.h>

#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <string_view>

#include "base/raster_state.h"
#include "plan/texture_binding.h"
#include "view/debug_view/pixel_probe.h"

namespace glibra::view {
namespace {

using base::RasterState;

template <class Enum, std::size_t count>
std::string wordOf(Enum value, const std::array<std::string_view, count>& words) {
    const auto at = static_cast<std::size_t>(value);
    return std::string(at < count ? words.at(at) : "?");
}

constexpr std::array<std::string_view, 8> kComparisons{"never",  "less",    "lequal",   "equal",
                                                       "gequal", "greater", "notequal", "always"};
constexpr std::array<std::string_view, 4> kCulls{"off", "back", "front", "both"};
constexpr std::array<std::string_view, 3> kPolygons{"filled", "lines", "points"};
constexpr std::array<std::string_view, 8> kActions{"keep",      "zero",   "replace",       "increment",
                                                   "decrement", "invert", "incrementWrap", "decrementWrap"};
constexpr std::array<std::string_view, 15> kFactors{"0",
                                                    "1",
                                                    "source colour",
                                                    "1 - source colour",
                                                    "stored colour",
                                                    "1 - stored colour",
                                                    "source alpha",
                                                    "1 - source alpha",
                                                    "stored alpha",
                                                    "1 - stored alpha",
                                                    "constant colour",
                                                    "1 - constant colour",
                                                    "constant alpha",
                                                    "1 - constant alpha",
                                                    "saturated alpha"};
constexpr std::array<std::string_view, 5> kEquations{"+", "-", "reversed -", "min", "max"};

std::string textOf(const base::BlendFunction& function) {
    const std::string equation = wordOf(function.equation, kEquations);
    if (function.equation >= base::BlendEquation::min) return equation;
    const auto factor = [](auto value) {
        const std::string word = wordOf(value, kFactors);
        return word.starts_with("1 - ") ? "(" + word + ")" : word;
    };
    return fmt::format("{} x source {} {} x stored", factor(function.source), equation,
                       factor(function.destination));
}

std::string textOf(const base::Blend& blend) {
    if (!blend.isOn) return "off";
    return "colour: " + textOf(blend.color) + "\nalpha: " + textOf(blend.alpha);
}

std::string textOf(const base::StencilFace& face) {
    return fmt::format("{} {} (mask {:x}); fails: {}, depth fails: {}, passes: {}; writes mask {:x}",
                       wordOf(face.function, kComparisons), face.reference, face.mask,
                       wordOf(face.fail, kActions), wordOf(face.depthFail, kActions),
                       wordOf(face.pass, kActions), face.writeMask);
}

std::string textOf(const base::FractionRectangle& part) {
    return fmt::format("{:g} {:g}, {:g} x {:g} of the target", part.x, part.y, part.width, part.height);
}

std::string textOf(const base::ColorMask& mask) {
    std::string text;
    if (mask.red) text += "red ";
    if (mask.green) text += "green ";
    if (mask.blue) text += "blue ";
    if (mask.alpha) text += "alpha";
    return text.empty() ? "nothing" : text;
}

class StateLines {
  public:
    void add(std::string name, std::string value, bool isChanged = false, scene::TextureIndex texture = {}) {
        lines.push_back({std::move(name), std::move(value), isChanged, texture});
    }

    void addRaster(const RasterState& state) {
        const RasterState usual;
        add("depth test",
            !state.depthTest ? "off, writes no depth"
                             : wordOf(state.depthFunction, kComparisons) +
                                   (state.depthWrite ? ", writes depth" : ", writes no depth"),
            state.depthTest != usual.depthTest || state.depthFunction != usual.depthFunction ||
                state.depthWrite != usual.depthWrite);
        if (state.depthOrder != usual.depthOrder) add("depth buffer", "reversed: 1 near, 0 far", true);
        if (state.depthNear != 0 || state.depthFar != 1)
            add("depth range", fmt::format("{:g} to {:g}", state.depthNear, state.depthFar), true);
        if (state.offsetFactor != 0 || state.offsetUnits != 0)
            add("offset", fmt::format("factor {:g}, units {:g}", state.offsetFactor, state.offsetUnits),
                true);
        if (state.depthClamp) add("depth clamp", "on", true);
        add("cull",
            wordOf(state.cull, kCulls) + (state.front == base::Winding::ccw
                                              ? "; counter-clockwise is the front"
                                              : "; clockwise is the front"),
            state.cull != usual.cull || state.front != usual.front);
        if (state.polygon != usual.polygon) add("polygons", wordOf(state.polygon, kPolygons), true);
        if (state.discard) add("discard", "no fragments", true);
        if (state.stencilTest) {
            add("stencil, front", textOf(state.stencilFront), true);
            add("stencil, back", textOf(state.stencilBack), true);
        }
        for (std::size_t i = 0; i < state.blend.size(); ++i) {
            const bool isSame = i > 0 && state.blend.at(i) == state.blend.at(0);
            if (!isSame)
                add(i == 0 ? "blending" : fmt::format("blending {}", i), textOf(state.blend.at(i)),
                    state.blend.at(i).isOn);
            const base::ColorMask& mask = state.write.at(i);
            if (mask != base::ColorMask{}) add(fmt::format("writes, output {}", i), textOf(mask), true);
        }
        if (state.viewport != usual.viewport) add("viewport", textOf(state.viewport), true);
        if (state.scissor) add("scissor", textOf(*state.scissor), true);
        if (state.lineWidth != 1) add("line width", fmt::format("{:g}", state.lineWidth), true);
        if (state.alphaToCoverage) add("alpha to coverage", "on", true);
    }

    std::vector<StateLine> lines;
};

}  // namespace

std::string matrixText(const glm::dmat4& matrix) {
    constexpr int kNumbers = 16;
    return numbersText({"", "mat4", {glm::value_ptr(matrix), glm::value_ptr(matrix) + kNumbers}});
}

std::vector<StateLine> stateOf(const scene::Scene& scene, const plan::FramePlan& plan,
                               const plan::PlannedDraw& planned, const render::ViewMatrices& view,
                               double aspect) {
    const scene::Draw& draw = plan.drawOf(planned);
    const plan::PlannedProgram& program = plan.programs[planned.program];
    StateLines all;
    all.add("draws", std::string(geometry::wordsOf(planned.submission.topology)) +
                         (draw.instances != 1 ? fmt::format(", {} instances", draw.instances) : ""));
    all.add("program", draw.program ? fmt::format("{}, line {}", scene.programs[draw.program].name,
                                                  scene.programs[draw.program].place.line)
                                    : "glibra's own");
    all.addRaster(*draw.raster);
    for (const plan::TextureUse& each : planned.textures) {
        if (!program.interface) break;
        const auto& uniforms = program.interface->uniforms;
        const std::string name =
            at(uniforms, each.uniform).name +
            (at(uniforms, each.uniform).isArray ? fmt::format("[{}]", each.element) : "");
        const std::string value = each.view.texture    ? plan::nameOf(scene, each.view)
                                  : each.buffer.buffer ? "'" + scene.buffers[each.buffer.buffer].name + "'"
                                                       : "nothing: reads (0, 0, 0, 1)";
        all.add(name, value, !each.view.texture && !each.buffer.buffer, each.view.texture);
    }
    if (!std::holds_alternative<scene::ClipSpace>(*draw.projection)) {
        all.add("model-view", matrixText(view.modelView(draw)));
        all.add("projection", matrixText(view.projection(draw, aspect)));
    }
    return std::move(all.lines);
}

}  // namespace glibra::view
