#include "suite/serve/difference_sign.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "image/convert.h"

namespace glibra::suite {
namespace {

double lengthOf(const std::array<double, 3>& color) {
    return std::hypot(color[0], color[1], color[2]);
}

}  // namespace

std::optional<DifferenceSign> differenceSign(const image::Image& expected, const image::Image& got) {
    if (expected.width != got.width || expected.height != got.height) return std::nullopt;
    const auto bytes = [](const image::Image& each) {
        return image::withComponents(image::withType(each, image::Component::u8), 3);
    };
    const image::Image before = bytes(expected), after = bytes(got);
    DifferenceSign sign;
    double differing = 0;
    for (std::size_t at = 0; at + 2 < after.data.size(); at += 3) {
        std::array<int, 3> change{};
        for (std::size_t c = 0; c < 3; ++c)
            change[c] = std::to_integer<int>(after.data[at + c]) - std::to_integer<int>(before.data[at + c]);
        if (change == std::array<int, 3>{}) continue;
        ++differing;
        for (std::size_t c = 0; c < 3; ++c) {
            sign.color[c] += change[c];
            sign.size += std::abs(change[c]) / 3.;
        }
    }
    if (differing == 0) return std::nullopt;
    for (double& each : sign.color) each /= differing;
    sign.size /= differing;
    sign.share = differing / (static_cast<double>(after.width) * after.height);
    return sign;
}

bool areAlike(const DifferenceSign& a, const DifferenceSign& b) {
    constexpr double kFactor = 2, kSameDirection = .9, kNoDirection = .3;
    const auto isNear = [](double x, double y) { return x <= kFactor * y && y <= kFactor * x; };
    if (!isNear(a.size, b.size) || !isNear(a.share, b.share)) return false;
    // Where pixels become lighter as well as darker, the mean says nothing.
    const double lengthA = lengthOf(a.color), lengthB = lengthOf(b.color);
    const bool isMixedA = lengthA < kNoDirection * a.size, isMixedB = lengthB < kNoDirection * b.size;
    if (isMixedA || isMixedB) return isMixedA && isMixedB;
    double product = 0;
    for (std::size_t c = 0; c < 3; ++c) product += a.color[c] * b.color[c];
    return product >= kSameDirection * lengthA * lengthB;
}

std::string toText(const DifferenceSign& sign) {
    const double mean = (sign.color[0] + sign.color[1] + sign.color[2]) / 3;
    constexpr double kMostly = .7;
    const char* way = std::abs(mean) < kMostly * sign.size ? "other colours"
                      : mean > 0                           ? "lighter"
                                                           : "darker";
    return fmt::format("{:.3g} of 255 {} in {:.3g} % of the pixels", sign.size, way, 100 * sign.share);
}

}  // namespace glibra::suite
