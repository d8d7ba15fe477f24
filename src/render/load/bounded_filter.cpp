#include "render/load/bounded_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace glibra::render {
namespace {

/// A sampler that the functions below pass on, and the type of its coordinates.
struct PassedSampler {
    std::string_view suffix, coordinates;
    bool takesBias;
};
constexpr std::array<PassedSampler, 7> kColorSamplers{{{"1D", "float", true},
                                                       {"3D", "vec3", true},
                                                       {"Cube", "vec3", true},
                                                       {"1DArray", "vec2", true},
                                                       {"2DArray", "vec3", true},
                                                       {"CubeArray", "vec4", true},
                                                       {"2DRect", "vec2", false}}};
constexpr std::array<PassedSampler, 6> kShadowSamplers{{{"1D", "vec3", true},
                                                        {"2D", "vec3", true},
                                                        {"Cube", "vec4", true},
                                                        {"1DArray", "vec3", true},
                                                        {"2DArray", "vec4", false},
                                                        {"2DRect", "vec3", false}}};

/// The gradients make an ellipse of half axes `w` around the pixel, in texels of the coarsest level. The
/// driver takes gradients from the coordinates in every texture function, so the four pixels of a quad decide
/// together, and those that cover too much give it constant coordinates. `{3}` wraps the coordinates.
constexpr std::string_view kBounded =
    "vec4 glibra_bounded(sampler2D s, vec2 p{0}) {{ "
    "vec2 dx = dFdx(p), dy = dFdy(p); "
    "int last = textureQueryLevels(s) - 1; "
    "vec2 size = vec2(textureSize(s, last)), w = sqrt(dx * dx + dy * dy) * size; "
    "float wide = step({2}., (2. * w.x + 1.) * (2. * w.y + 1.)); "
    "wide = max(wide, fwidth(wide)); wide = max(wide, fwidth(wide)); "
    "vec4 all = texture(s, wide > 0. ? vec2(0.) : p{1}), few = vec4(0.); "
    "for (int i = 0; i < 16; ++i) {{ "
    "vec2 at = p + (float(i % 4) - 1.5) * .25 * dx + (float(i / 4) - 1.5) * .25 * dy; "
    "few += texelFetch(s, min(ivec2({3} * size), ivec2(size) - 1), last) * .0625; }} "
    "return wide > 0. ? few : all; }} ";

std::string passedOn(std::string_view value, const std::string& sampler, const PassedSampler& row) {
    std::string text = fmt::format("{0} glibra_bounded({1} s, {2} p) {{ return texture(s, p); }} ", value,
                                   sampler, row.coordinates);
    if (row.takesBias)
        text += fmt::format("{0} glibra_bounded({1} s, {2} p, float b) {{ return texture(s, p, b); }} ",
                            value, sampler, row.coordinates);
    return text;
}

std::string functions(bool repeats) {
    const char* wrapped = repeats ? "fract(at)" : "clamp(at, vec2(0.), vec2(1.))";
    std::string text = fmt::format(fmt::runtime(kBounded), "", "", kMostTexels, wrapped);
    text += fmt::format(fmt::runtime(kBounded), ", float b", ", b", kMostTexels, wrapped);
    for (const std::string_view prefix : {"", "i", "u"}) {
        const std::string value = fmt::format("{}vec4", prefix);
        for (const PassedSampler& each : kColorSamplers)
            text += passedOn(value, fmt::format("{}sampler{}", prefix, each.suffix), each);
        if (!prefix.empty())
            text += passedOn(value, fmt::format("{}sampler2D", prefix), {"2D", "vec2", true});
    }
    for (const PassedSampler& each : kShadowSamplers)
        text += passedOn("float", fmt::format("sampler{}Shadow", each.suffix), each);
    return text +
           "float glibra_bounded(samplerCubeArrayShadow s, vec4 p, float c) { return texture(s, p, c); }";
}

/// The number of the #version line; 0 without one.
int versionOf(std::string_view source) {
    constexpr std::string_view kWord = "#version ";
    int version = 0;
    if (source.starts_with(kWord))
        std::from_chars(source.data() + kWord.size(), source.data() + source.size(), version);
    return version;
}

/// The byte and the number of the line after the #version and #extension lines.
struct Spot {
    std::size_t byte = 0, line = 0;
};
Spot afterExtensions(std::string_view source) {
    Spot spot;
    while (spot.byte < source.size()) {
        const std::size_t end = source.find('\n', spot.byte);
        if (end == std::string_view::npos) break;
        const std::string_view line = source.substr(spot.byte, end - spot.byte);
        if (!line.empty() && !line.starts_with("#version") && !line.starts_with("#extension")) break;
        spot = {end + 1, spot.line + 1};
    }
    return spot;
}

}  // namespace

std::optional<FilterBound> filterBoundOf(const scene::Scene& scene) {
    std::optional<FilterBound> bound;
    const auto look = [&](const base::SamplerState& state) {
        if (state.anisotropy <= 1) return;
        if (!bound) bound = FilterBound{};
        bound->repeats = bound->repeats || base::repeats(state.wrap[0]) || base::repeats(state.wrap[1]);
    };
    for (const scene::Texture& each : scene.textures) look(each.sampler);
    for (const scene::Sampler& each : scene.samplers) look(each.state);
    return bound;
}

bool boundFilter(glsl::TranslatedStage& stage, const FilterBound& bound) {
    constexpr int kWithLevels = 430;  // textureQueryLevels()
    if (stage.stage != glsl::Stage::fragment || versionOf(stage.source) < kWithLevels ||
        stage.source.find("texture") == std::string::npos)
        return false;
    const Spot spot = afterExtensions(stage.source);
    stage.source.insert(spot.byte, functions(bound.repeats) + "\n#define texture glibra_bounded\n");
    const auto at = static_cast<std::ptrdiff_t>(std::min(spot.line, stage.lineMap.lines.size()));
    stage.lineMap.lines.insert(stage.lineMap.lines.begin() + at, 2, glsl::LineOrigin{});
    stage.lineMap.columns.insert(stage.lineMap.columns.begin() +
                                     std::min(at, static_cast<std::ptrdiff_t>(stage.lineMap.columns.size())),
                                 2, std::vector<glsl::ColumnShift>{});
    return true;
}

}  // namespace glibra::render
