#include "classroom/pattern_kinds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace glibra::classroom {
namespace {

constexpr float kFlat = 0.15F;           // response of a flat place, in deviations of the tone
constexpr std::size_t kCoarser = 2;      // scales between the two that are looked at together
constexpr double kPerScale = 0.93;       // what a pattern keeps whose size differs by one scale
constexpr std::uint8_t kUnknown = 0xFF;  // a place at the outline

/// The kind of each pixel in one scale.
std::vector<std::uint8_t> kindsOf(const ToneScales& tones, std::size_t scale) {
    const int side = tones.side;
    const Plane& tone = tones.levels[scale];
    std::vector<std::uint8_t> kinds(tone.size(), kUnknown);
    const float deviation = toneDeviation(static_cast<float>(scale));
    const int step = std::max(1, static_cast<int>(std::lround(deviation / 2)));
    const float unit = deviation / static_cast<float>(step);
    for (int y = step; y + step < side; ++y)
        for (int x = step; x + step < side; ++x) {
            const auto index = [&](int u, int v) {
                return static_cast<std::size_t>((y + v * step) * side + x + u * step);
            };
            const auto isInside = [&](int u, int v) { return tones.inside[index(u, v)] > 0; };
            if (tones.known[scale][index(0, 0)] < 0.8F || !isInside(0, 0) || !isInside(1, 0) ||
                !isInside(-1, 0) || !isInside(0, 1) || !isInside(0, -1))
                continue;
            const auto at = [&](int u, int v) { return tone[index(u, v)]; };
            const float dx = unit * (at(1, 0) - at(-1, 0)) / 2, dy = unit * (at(0, 1) - at(0, -1)) / 2;
            const float xx = unit * unit * (at(1, 0) - 2 * at(0, 0) + at(-1, 0));
            const float yy = unit * unit * (at(0, 1) - 2 * at(0, 0) + at(0, -1));
            const float xy = unit * unit * (at(1, 1) - at(-1, 1) - at(1, -1) + at(-1, -1)) / 4;
            const float sum = xx + yy, spread = std::hypot(xx - yy, 2 * xy), root = std::sqrt(0.5F);
            const std::array<float, kPlaceKinds> responses{
                kFlat, 2 * std::hypot(dx, dy), sum, -sum, root * (spread + sum), root * (spread - sum),
                spread};
            kinds[index(0, 0)] =
                static_cast<std::uint8_t>(std::ranges::max_element(responses) - responses.begin());
        }
    return kinds;
}

/// The kind after dark and light are exchanged.
std::size_t exchanged(std::size_t kind) {
    constexpr std::array<std::size_t, kPlaceKinds> kOther{0, 1, 3, 2, 5, 4, 6};
    return kOther[kind];
}

}  // namespace

PatternKinds patternKindsOf(const ToneScales& tones) {
    std::vector<std::vector<std::uint8_t>> kinds;
    for (std::size_t i = 0; i < tones.levels.size(); ++i) kinds.push_back(kindsOf(tones, i));
    PatternKinds made;
    for (std::size_t scale = 0; scale + kCoarser < kinds.size(); ++scale) {
        KindShares shares{};
        double count = 0;
        for (std::size_t i = 0; i < kinds[scale].size(); ++i) {
            const std::uint8_t fine = kinds[scale][i], coarse = kinds[scale + kCoarser][i];
            if (fine == kUnknown || coarse == kUnknown) continue;
            ++shares[fine * kPlaceKinds + coarse];
            ++count;
        }
        constexpr double kLeast = 100;  // pixels
        for (double& each : shares) each /= std::max(count, 1.0);
        made.scales.push_back(count < kLeast ? std::nullopt : std::optional(shares));
    }
    return made;
}

double commonKinds(const PatternKinds& a, const PatternKinds& b) {
    constexpr int kMostScales = 4;
    const auto count = static_cast<int>(std::min(a.scales.size(), b.scales.size()));
    double best = 0;
    for (int shift = -kMostScales; shift <= kMostScales; ++shift)
        for (const bool exchanges : {false, true}) {
            double sum = 0, weights = 0;
            for (int scale = std::max(0, -shift); scale < std::min(count, count - shift); ++scale) {
                const auto& own = a.scales[static_cast<std::size_t>(scale)];
                const auto& other = b.scales[static_cast<std::size_t>(scale + shift)];
                if (!own || !other) continue;
                double common = 0;
                for (std::size_t i = 0; i < own->size(); ++i) {
                    const std::size_t k =
                        exchanges ? exchanged(i / kPlaceKinds) * kPlaceKinds + exchanged(i % kPlaceKinds) : i;
                    common += std::sqrt((*own)[i] * (*other)[k]);
                }
                // Scales in which all is flat say little.
                const double weight = 1 - std::min(own->front(), other->front());
                sum += weight * common;
                weights += weight;
            }
            if (weights > 0.5) best = std::max(best, sum / weights * std::pow(kPerScale, std::abs(shift)));
        }
    return best;
}

}  // namespace glibra::classroom
