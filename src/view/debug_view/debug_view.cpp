#include "view/debug_view/debug_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glibra::view {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

constexpr Rgb kNothing{24, 24, 28};
constexpr Rgb kFront{70, 130, 220};
constexpr Rgb kBack{235, 120, 40};
constexpr std::array<Rgb, 9> kCounts{{{0, 0, 0},
                                      {20, 30, 110},
                                      {30, 80, 200},
                                      {30, 160, 180},
                                      {50, 180, 60},
                                      {220, 210, 40},
                                      {240, 140, 30},
                                      {220, 40, 30},
                                      {255, 255, 255}}};
constexpr double kFarthestGrey = .12;

bool isSomething(const float* rgba) {
    return rgba[3] > 0;
}

double shownNumber(DebugView kind, const float* rgba) {
    return rgba[kind == DebugView::depth ? 1 : 0];
}

Rgb colorOfCoordinates(const float* rgba) {
    const auto inside = [](double value) { return value >= 0 && value <= 1; };
    const auto part = [&](double value) { return inside(value) ? value : value - std::floor(value); };
    if (!std::isfinite(rgba[0]) || !std::isfinite(rgba[1])) return {255, 0, 255};
    return {asByte(part(rgba[0])), asByte(part(rgba[1])),
            asByte(inside(rgba[0]) && inside(rgba[1]) ? 0 : .5)};
}

Rgb texelColor(DebugView kind, const float* rgba, const ValueRange& range) {
    switch (kind) {
        case DebugView::coordinates:
            return colorOfCoordinates(rgba);
        case DebugView::facing:
            return rgba[0] > .5F ? kFront : kBack;
        case DebugView::depth: {
            const double extent = range.highest - range.lowest;
            const double part = extent > 0 ? (shownNumber(kind, rgba) - range.lowest) / extent : 0;
            const std::uint8_t grey = asByte(1 - (1 - kFarthestGrey) * part);
            return {grey, grey, grey};
        }
        default:
            return colorOfCount(rgba[0]);
    }
}

}  // namespace

std::string_view nameOf(DebugView kind) {
    constexpr std::array<std::string_view, kDebugViewCount> kNames{
        "picture", "normals", "texture coordinates", "facing", "overdraw", "layers", "depth"};
    return kNames.at(static_cast<std::size_t>(kind));
}

ValueRange rangeOf(DebugView kind, const TexelImage& numbers) {
    ValueRange range;
    for (std::size_t i = 0; i + 3 < numbers.rgba.size(); i += 4) {
        const float* texel = numbers.rgba.data() + i;
        const double number = shownNumber(kind, texel);
        if (!isSomething(texel) || !std::isfinite(number)) continue;
        range.lowest = range.isEmpty ? number : std::min(range.lowest, number);
        range.highest = range.isEmpty ? number : std::max(range.highest, number);
        range.isEmpty = false;
    }
    return range;
}

std::array<std::uint8_t, 3> colorOfCount(double count) {
    const double last = static_cast<double>(kCounts.size()) - 1;
    return kCounts.at(static_cast<std::size_t>(std::clamp(count, 0.0, last)));
}

std::vector<std::uint8_t> colorsOf(DebugView kind, const TexelImage& numbers) {
    const ValueRange range = rangeOf(kind, numbers);
    std::vector<std::uint8_t> bytes(numbers.rgba.size(), 255);
    for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
        const float* texel = numbers.rgba.data() + i;
        const Rgb color = isSomething(texel) ? texelColor(kind, texel, range) : kNothing;
        std::copy(color.begin(), color.end(), bytes.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return bytes;
}

std::string wordsOf(DebugView kind, const float* rgba) {
    if (!isSomething(rgba)) return "nothing is drawn here";
    switch (kind) {
        case DebugView::picture:
        case DebugView::normals:
            return {};
        case DebugView::coordinates:
            return fmt::format("s {:.4g}, t {:.4g}, p {:.4g}", rgba[0], rgba[1], rgba[2]);
        case DebugView::facing:
            return rgba[0] > .5F ? "front" : "back";
        case DebugView::depth:
            return fmt::format("depth {:.5g}, {:.4g} from the eye", rgba[0], rgba[1]);
        case DebugView::overdraw:
        case DebugView::layers:
            break;
    }
    return fmt::format("{:g} fragment{}", rgba[0], rgba[0] == 1 ? "" : "s");
}

}  // namespace glibra::view
