#include "view/debug_view/state_choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "glib/statement_table.h"

namespace glibra::view {
namespace {

using base::Blend;
using base::BlendEquation;
using base::BlendFactor;
using base::RasterState;

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
