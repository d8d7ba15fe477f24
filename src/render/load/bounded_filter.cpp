#include "render/load/bounded_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
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

/// The gradients make an ellipse of half axes `w` around the pixel, in texels of the coarsest level. The four
/// pixels of a quad decide together, because their coordinates make the gradients.
constexpr std::string_view kBounded =
    "vec4 glibra_bounded(sampler2D s, vec2 p{0}) {{ "
    "vec2 dx = dFdx(p), dy = dFdy(p); "
    "vec2 w = sqrt(dx * dx + dy * dy) * vec2(textureSize(s, textureQueryLevels(s) - 1)); "
    "float wide = step({2}., (2. * w.x + 1.) * (2. * w.y + 1.)); "
    "wide = max(wide, fwidth(wide)); wide = max(wide, fwidth(wide)); "
    "float k = wide * min(1., 8. / max(max(w.x, w.y), 1.)); "
    "vec4 few = textureGrad(s, wide > 0. ? p : vec2(0.), dx * k, dy * k); "
    "vec4 all = texture(s, wide > 0. ? vec2(0.) : p{1}); "
    "return wide > 0. ? few : all; }} ";

std::string passedOn(std::string_view value, const std::string& sampler, const PassedSampler& row) {
    std::string text = fmt::format("{0} glibra_bounded({1} s, {2} p) {{ return texture(s, p); }} ", value,
                                   sampler, row.coordinates);
    if (row.takesBias)
        text += fmt::format("{0} glibra_bounded({1} s, {2} p, float b) {{ return texture(s, p, b); }} ",
                            value, sampler, row.coordinates);
    return text;
}

std::string functions() {
    std::string text = fmt::format(fmt::runtime(kBounded), "", "", kMostTexels);
    text += fmt::format(fmt::runtime(kBounded), ", float b", ", b", kMostTexels);
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
    Spot spot, found;
    while (spot.byte < source.size()) {
        const std::size_t end = source.find('\n', spot.byte);
        if (end == std::string_view::npos) break;
        const std::string_view line = source.substr(spot.byte, end - spot.byte);
        if (!line.empty() && !line.starts_with("#version") && !line.starts_with("#extension")) break;
        spot = {end + 1, spot.line + 1};
        found = spot;
    }
    return found;
}

}  // namespace

bool filtersAnisotropically(const scene::Scene& scene) {
    const auto isAnisotropic = [](const base::SamplerState& state) { return state.anisotropy > 1; };
    return std::any_of(scene.textures.begin(), scene.textures.end(),
                       [&](const scene::Texture& each) { return isAnisotropic(each.sampler); }) ||
           std::any_of(scene.samplers.begin(), scene.samplers.end(),
                       [&](const scene::Sampler& each) { return isAnisotropic(each.state); });
}

bool boundFilter(glsl::TranslatedStage& stage) {
    constexpr int kWithLevels = 430;  // textureQueryLevels()
    if (stage.stage != glsl::Stage::fragment || versionOf(stage.source) < kWithLevels ||
        stage.source.find("texture") == std::string::npos)
        return false;
    const Spot spot = afterExtensions(stage.source);
    stage.source.insert(spot.byte, functions() + "\n#define texture glibra_bounded\n");
    const auto at = static_cast<std::ptrdiff_t>(std::min(spot.line, stage.lineMap.lines.size()));
    stage.lineMap.lines.insert(stage.lineMap.lines.begin() + at, 2, glsl::LineOrigin{});
    stage.lineMap.columns.insert(stage.lineMap.columns.begin() +
                                     std::min(at, static_cast<std::ptrdiff_t>(stage.lineMap.columns.size())),
                                 2, std::vector<glsl::ColumnShift>{});
    return true;
}

}  // namespace glibra::render
