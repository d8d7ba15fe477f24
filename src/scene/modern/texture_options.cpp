#include "scene/modern/texture_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "glib/modern/statement_table.h"
#include "scene/run/evaluate.h"

namespace glibra::scene {

namespace {

using base::Filter;
using base::Wrap;

constexpr int kMostSamples = 64;
constexpr double kMostAnisotropy = 64;

constexpr std::pair<std::string_view, Filter> kFilters[] = {
    {"nearest", Filter::nearest},
    {"linear", Filter::linear},
    {"mipmap", Filter::linearMipmapLinear},
    {"nearest_mipmap_nearest", Filter::nearestMipmapNearest},
    {"linear_mipmap_nearest", Filter::linearMipmapNearest},
    {"nearest_mipmap_linear", Filter::nearestMipmapLinear},
    {"linear_mipmap_linear", Filter::linearMipmapLinear},
};
constexpr std::pair<std::string_view, Wrap> kWraps[] = {
    {"repeat", Wrap::repeat},
    {"mirror", Wrap::mirroredRepeat},
    {"clamp", Wrap::clampToEdge},
    {"border", Wrap::clampToBorder},
};

template <class T, std::size_t N>
std::optional<T> valueOfWord(const std::pair<std::string_view, T> (&rows)[N], std::string_view word) {
    for (const auto& [name, value] : rows)
        if (name == word) return value;
    return std::nullopt;
}

/// The colour of a border: three or four components, or one for all of a depth texture.
std::optional<std::array<double, 4>> borderColor(Interpreter& in, const Command& command,
                                                 const KeyedValues& key) {
    const auto numbers = floatsOf(in, key.values);
    if (!numbers) return std::nullopt;
    const std::size_t count = numbers->size();
    if (count != 1 && count != 3 && count != 4)
        return refuse(in, "glib-E26", command, key.position,
                      fmt::format("a border has 1, 3 or 4 components, not {}", count));
    std::array<double, 4> color{};
    if (count == 1) color.fill(numbers->front());
    color[3] = 1;
    std::copy(numbers->begin(), numbers->end(), color.begin());
    return color;
}

}  // namespace

std::optional<base::Wrap> wrapNamed(std::string_view word) {
    return valueOfWord(kWraps, word);
}

std::optional<TextureOptions> readOptions(Interpreter& in, const Command& command, std::size_t axes) {
    TextureOptions options;
    const auto integer = [&](const KeyedValues& key, int most) {
        return integerIn(in, key.values.front(), fmt::format("{}: {}", command.word, key.key), 1, most);
    };
    for (const KeyedValues& key : command.keys) {
        if (const auto filter = valueOfWord(kFilters, key.key)) {
            options.filter = *filter;
            options.filterPosition = key.position;
        } else if (const auto wrap = wrapNamed(key.key)) {
            if (options.wraps.size() == axes)
                return refuse(in, "glib-E18", command, key.position,
                              fmt::format("'{}' is one wrap mode too many; write one, or {}", key.key, axes));
            options.wraps.push_back(*wrap);
            if (key.values.empty()) continue;
            options.border = borderColor(in, command, key);
            if (!options.border) return std::nullopt;
        } else if (key.key == "aniso") {
            options.anisotropy =
                numberIn(in, key.values.front(), command.word + ": aniso", 1, kMostAnisotropy);
            if (!options.anisotropy) return std::nullopt;
        } else if (key.key == "compare") {
            const auto test = wordOf(in, key.values.front(), glib::wordsOfFragment("compare"));
            if (!test) return std::nullopt;
            options.compare = static_cast<base::Comparison>(*test);
            options.comparePosition = key.position;
        } else if (key.key == "samples") {
            options.samples = integer(key, kMostSamples);
            options.samplesKey = &key;
            if (!options.samples) return std::nullopt;
        } else if (key.key == "levels") {
            options.levels = integer(key, 15);
            options.levelsKey = &key;
            if (!options.levels) return std::nullopt;
        } else if (key.key == "flip") {
            options.flip = &key;
        } else if (key.key == "srgb") {
            options.srgb = &key;
        } else if (key.key == "generate") {
            options.generate = &key;
        } else if (key.key == "history") {
            options.history = &key;
        }
    }
    if (options.wraps.size() > 1 && options.wraps.size() < axes)
        return refuse(
            in, "glib-E26", command, command.position,
            fmt::format("{} wrap modes for {} axes; write one, or {}", options.wraps.size(), axes, axes));
    return options;
}

base::SamplerState stateOf(const TextureOptions& options, base::SamplerState state) {
    if (options.filter) state.filter = *options.filter;
    if (options.anisotropy) state.anisotropy = *options.anisotropy;
    if (options.border) state.border = *options.border;
    if (options.compare) state.compare = *options.compare;
    for (std::size_t i = 0; i < state.wrap.size() && !options.wraps.empty(); ++i)
        state.wrap[i] = options.wraps[std::min(i, options.wraps.size() - 1)];
    return state;
}

}  // namespace glibra::scene
