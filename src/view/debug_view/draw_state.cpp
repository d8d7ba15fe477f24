#include "view/debug_view/draw_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <type_traits>
#include <utility>

#include "glib/statement_table.h"
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

using base::Blend;
using base::BlendEquation;
using base::BlendFactor;

constexpr Blend sameForAlpha(BlendFactor source, BlendFactor destination) {
    return {true, {source, destination, BlendEquation::add}, {source, destination, BlendEquation::add}};
}

/// By the words of `blend`.
constexpr std::array<Blend, 5> kBlends{Blend{}, base::kBlendOver,
                                       sameForAlpha(BlendFactor::one, BlendFactor::one),
                                       sameForAlpha(BlendFactor::destinationColor, BlendFactor::zero),
                                       sameForAlpha(BlendFactor::one, BlendFactor::oneMinusSourceAlpha)};

/// "none", "r", "rg" ... of the statement table.
const std::vector<std::string_view>& maskWords() {
    static const std::vector<std::string_view> words = glib::wordsOfFragment("mask");
    return words;
}

base::ColorMask maskOf(std::string_view word) {
    const auto has = [&](char component) {
        return word != "none" && word.find(component) != std::string_view::npos;
    };
    return {has('r'), has('g'), has('b'), has('a')};
}

std::vector<std::string_view> depthWords() {
    std::vector<std::string_view> words{"off"};
    for (const std::string_view each : glib::wordsOfFragment("compare")) words.push_back(each);
    return words;
}

/// The index of the value that all colour targets have.
template <class Values, class Values2, class Same>
std::size_t indexOfAll(const Values& targets, const Values2& known, const Same& same) {
    const bool isOne = std::all_of(targets.begin(), targets.end(),
                                   [&](const auto& each) { return each == targets.front(); });
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const auto& each) { return same(each, targets.front()); });
    return isOne ? static_cast<std::size_t>(found - known.begin()) : known.size();
}

/// A choice whose words are in the order of the member's values.
template <auto kMember>
StateChoice memberChoice(std::string_view key, std::vector<std::string_view> words) {
    return {key, std::move(words),
            [](const RasterState& state) { return static_cast<std::size_t>(state.*kMember); },
            [](RasterState& state, std::size_t word) {
                state.*kMember = static_cast<std::remove_reference_t<decltype(state.*kMember)>>(word);
            }};
}

const std::vector<StateChoice>& choices() {
    static const std::vector<StateChoice> all{
        memberChoice<&RasterState::cull>("cull", {"off", "back", "front", "both"}),
        memberChoice<&RasterState::front>("front", {"ccw", "cw"}),
        memberChoice<&RasterState::polygon>("polygon", {"fill", "line", "point"}),
        {"depth", depthWords(),
         [](const RasterState& state) {
             return state.depthTest ? static_cast<std::size_t>(state.depthFunction) + 1 : std::size_t{0};
         },
         [](RasterState& state, std::size_t word) {
             state.depthTest = word > 0;
             if (word > 0) state.depthFunction = static_cast<base::Comparison>(word - 1);
         }},
        memberChoice<&RasterState::depthWrite>("depthwrite", {"off", "on"}),
        memberChoice<&RasterState::depthClamp>("depthclamp", {"off", "on"}),
        {"blend",
         {"off", "alpha", "add", "multiply", "premultiplied"},
         [](const RasterState& state) {
             return indexOfAll(state.blend, kBlends,
                               [](const Blend& a, const Blend& b) { return a == b || (!a.isOn && !b.isOn); });
         },
         [](RasterState& state, std::size_t word) { state.blendAll(kBlends.at(word)); }},
        {"write", maskWords(),
         [](const RasterState& state) {
             return indexOfAll(state.write, maskWords(),
                               [](std::string_view a, const base::ColorMask& b) { return maskOf(a) == b; });
         },
         [](RasterState& state, std::size_t word) { state.write.fill(maskOf(maskWords().at(word))); }}};
    return all;
}

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

std::span<const StateChoice> stateChoices() {
    return choices();
}

std::string stateStatement(const base::RasterState& from, const base::RasterState& to) {
    std::string text;
    for (const StateChoice& each : choices()) {
        const std::size_t word = each.wordOf(to);
        if (word != each.wordOf(from) && word < each.words.size())
            text += fmt::format("  {} {}", each.key, each.words[word]);
    }
    if (from.offsetFactor != to.offsetFactor || from.offsetUnits != to.offsetUnits)
        text += fmt::format("  offset {:g} {:g}", to.offsetFactor, to.offsetUnits);
    return text.empty() ? text : "State" + text.substr(1);
}

}  // namespace glibra::view
