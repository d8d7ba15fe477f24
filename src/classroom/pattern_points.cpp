#include "classroom/pattern_points.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <utility>

namespace glibra::classroom {
namespace {

constexpr float kLeastKnown = 0.6F;  // share of the surroundings that belongs to objects
constexpr std::size_t kMostPoints = 60;

float sampled(const Plane& plane, int side, float x, float y) {
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    if (left < 0 || top < 0 || left + 1 >= side || top + 1 >= side) return 0;
    const float u = x - static_cast<float>(left), v = y - static_cast<float>(top);
    const auto at = [&](int column, int row) { return plane[static_cast<std::size_t>(row * side + column)]; };
    return (at(left, top) * (1 - u) + at(left + 1, top) * u) * (1 - v) +
           (at(left, top + 1) * (1 - u) + at(left + 1, top + 1) * u) * v;
}

/// Reads the surroundings of a point from tones that were smoothed by about half of its radius.
void readAround(PatternPoint& point, const Plane& tones, const Plane& inside, int side, float sign) {
    for (int ring = 0; ring < kRings; ++ring)
        for (int angle = 0; angle < kAngles; ++angle) {
            const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(angle) / kAngles;
            const float radius = point.radius * static_cast<float>(ring + 1);
            const float x = point.x + radius * std::cos(turn), y = point.y + radius * std::sin(turn);
            const float known = sampled(inside, side, x, y) > 0.5F ? 1.0F : 0.0F;
            for (const int copy : {0, kAngles}) {
                const auto i = static_cast<std::size_t>(ring * 2 * kAngles + angle + copy);
                point.known[i] = known;
                point.tones[i] = known * sign * sampled(tones, side, x, y);
            }
        }
}

/// The largest correlation of two surroundings over all angles; places that one of them does not know are
/// left out.
float correlationOf(const PatternPoint& a, const PatternPoint& b) {
    float best = 0;
    for (std::size_t turn = 0; turn < kAngles; ++turn) {
        float ab = 0, aa = 0, bb = 0, n = 0, sumA = 0, sumB = 0;
        for (std::size_t ring = 0; ring < kRings; ++ring) {
            const std::size_t i = ring * 2 * kAngles, k = i + turn;
            for (std::size_t angle = 0; angle < kAngles; ++angle) {
                const float both = a.known[i + angle] * b.known[k + angle];
                const float p = a.tones[i + angle] * both, q = b.tones[k + angle] * both;
                n += both;
                sumA += p;
                sumB += q;
                ab += p * q;
                aa += p * p;
                bb += q * q;
            }
        }
        if (n < kLeastKnown * kRings * kAngles) continue;
        const float varianceA = aa - sumA * sumA / n, varianceB = bb - sumB * sumB / n;
        if (varianceA <= 0 || varianceB <= 0) continue;
        best = std::max(best, (ab - sumA * sumB / n) / std::sqrt(varianceA * varianceB));
    }
    return best;
}

}  // namespace

std::vector<PatternPoint> findPatternPoints(const ToneScales& tones) {
    constexpr std::size_t kLevels = kToneScales - 1;
    const int side = tones.side;
    std::vector<PatternPoint> found;
    if (tones.levels.empty()) return found;
    struct Candidate {
        float strength, level;
        int x, y;
    };
    std::vector<Candidate> candidates;
    for (int y = 1; y + 1 < side; ++y)
        for (int x = 1; x + 1 < side; ++x) {
            const auto at = static_cast<std::size_t>(y * side + x);
            if (tones.inside[at] <= 0) continue;
            std::array<float, kLevels> response{};
            std::size_t best = 0;
            for (std::size_t i = 0; i < kLevels; ++i) {
                response[i] = tones.levels[i][at] - tones.levels[i + 1][at];
                if (std::abs(response[i]) > std::abs(response[best])) best = i;
            }
            auto level = static_cast<float>(best) + 0.5F;
            if (best > 0 && best + 1 < kLevels) {  // the parabola through three levels
                const float below = std::abs(response[best - 1]), above = std::abs(response[best + 1]);
                const float bend = below + above - 2 * std::abs(response[best]);
                if (bend < 0) level += 0.5F * (below - above) / bend;
            }
            candidates.push_back({response[best], level, x, y});
        }
    if (candidates.empty()) return found;
    std::ranges::stable_sort(candidates, [](const Candidate& a, const Candidate& b) {
        return std::abs(a.strength) > std::abs(b.strength);
    });
    const float least = 0.25F * std::abs(candidates[candidates.size() / 50].strength);
    for (const Candidate& each : candidates) {
        if (std::abs(each.strength) < least || found.size() >= kMostPoints) break;
        PatternPoint point;
        point.x = static_cast<float>(each.x);
        point.y = static_cast<float>(each.y);
        point.radius = toneDeviation(each.level);
        if (std::ranges::any_of(found, [&](const PatternPoint& other) {
                return std::hypot(other.x - point.x, other.y - point.y) <
                       1.3F * std::max(point.radius, other.radius);
            }))
            continue;
        // Tones that were smoothed by about half of the radius.
        const auto level = static_cast<std::size_t>(std::max(each.level - 2, 0.0F));
        readAround(point, tones.levels[level], tones.inside, side, each.strength < 0 ? -1.0F : 1.0F);
        // What stands at the outline has nothing to compare.
        if (std::accumulate(point.known.begin(), point.known.end(), 0.0F) >=
            kLeastKnown * 2 * kRings * kAngles)
            found.push_back(point);
    }
    return found;
}

FoundAgain foundAgain(std::span<const PatternPoint> a, std::span<const PatternPoint> b) {
    if (a.empty() || b.empty()) return {};
    struct Best {
        float value = 0, octaves = 0;
    };
    std::vector<Best> bestA(a.size()), bestB(b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < b.size(); ++k) {
            const float value = correlationOf(a[i], b[k]);
            const float octaves = std::log2(b[k].radius / a[i].radius);
            if (value > bestA[i].value) bestA[i] = {value, octaves};
            if (value > bestB[k].value) bestB[k] = {value, octaves};
        }
    std::vector<std::pair<float, float>> sizes;  // octaves, with their weights
    const auto mean = [&](const std::vector<Best>& best, std::span<const PatternPoint> points) {
        double sum = 0, weights = 0;
        for (std::size_t i = 0; i < best.size(); ++i) {
            sum += static_cast<double>(points[i].radius) * best[i].value;
            weights += points[i].radius;
            sizes.emplace_back(best[i].octaves, points[i].radius);
        }
        return sum / weights;
    };
    FoundAgain found;
    found.correlation = std::sqrt(mean(bestA, a) * mean(bestB, b));
    std::ranges::sort(sizes);
    float half = 0;
    for (const auto& [octaves, weight] : sizes) half += weight / 2;
    for (const auto& [octaves, weight] : sizes) {
        found.octaves = octaves;
        half -= weight;
        if (half <= 0) break;
    }
    return found;
}

double repetition(std::span<const PatternPoint> points) {
    constexpr std::size_t kOthers = 3;
    if (points.size() < 2) return 0;
    std::vector<std::vector<float>> values(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const float value = correlationOf(points[i], points[k]);
            values[i].push_back(value);
            values[k].push_back(value);
        }
    double sum = 0, weights = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t others = std::min(kOthers, values[i].size());
        std::partial_sort(values[i].begin(), values[i].begin() + static_cast<std::ptrdiff_t>(others),
                          values[i].end(), std::greater<>());
        const float best =
            std::accumulate(values[i].begin(), values[i].begin() + static_cast<std::ptrdiff_t>(others), 0.0F);
        sum += static_cast<double>(points[i].radius) * best / static_cast<double>(others);
        weights += points[i].radius;
    }
    return sum / weights;
}

}  // namespace glibra::classroom
