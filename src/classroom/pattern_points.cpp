#include "classroom/pattern_points.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <utility>

namespace glibra::classroom {
namespace {

constexpr float kSmallest = 1.18F;  // deviation of the first scale, in pixels
constexpr float kAround = 16;       // pixels over which colours are compared with their mean

/// Convolves with a Gaussian; pixels beyond the border count as 0.
Plane smoothed(const Plane& plane, int side, float deviation) {
    const int reach = std::max(1, static_cast<int>(std::ceil(2.5F * deviation)));
    std::vector<float> weights;
    for (int i = -reach; i <= reach; ++i)
        weights.push_back(std::exp(-0.5F * static_cast<float>(i * i) / (deviation * deviation)));
    Plane rows(plane.size(), 0), made(plane.size(), 0);
    const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * side + x); };
    for (int y = 0; y < side; ++y)
        for (int i = -reach; i <= reach; ++i) {
            const float weight = weights[static_cast<std::size_t>(i + reach)];
            for (int x = std::max(0, -i); x < std::min(side, side - i); ++x)
                rows[at(x, y)] += weight * plane[at(x + i, y)];
        }
    for (int y = 0; y < side; ++y)
        for (int i = std::max(-reach, -y); i <= std::min(reach, side - 1 - y); ++i) {
            const float weight = weights[static_cast<std::size_t>(i + reach)];
            for (int x = 0; x < side; ++x) made[at(x, y)] += weight * rows[at(x, y + i)];
        }
    return made;
}

/// Means over the objects alone, so that their outlines make no blobs.
class Means {
  public:
    Means(const Plane& inside, int side, float deviation)
        : weights_(smoothed(inside, side, deviation)), side_(side), deviation_(deviation) {}
    /// `plane` is 0 outside of the objects.
    [[nodiscard]] Plane of(const Plane& plane) const {
        Plane sums = smoothed(plane, side_, deviation_);
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = weights_[i] > 0 ? sums[i] / weights_[i] : 0;
        return sums;
    }
    /// The share of each mean that comes from the objects, 1 far from their outlines.
    [[nodiscard]] Plane known() const {
        Plane shares = weights_;
        const float full = *std::ranges::max_element(shares);
        for (float& each : shares) each = full > 0 ? each / full : 0;
        return shares;
    }

  private:
    Plane weights_;
    int side_;
    float deviation_;
};

/// The direction in which colours vary most: the first eigenvector of their covariances, by iteration.
std::array<double, 3> principalAxis(const std::array<std::array<double, 3>, 3>& covariance) {
    std::array<double, 3> axis{1, 1, 1};
    for (std::size_t k = 0; k < 3; ++k)  // the largest column is near to it, and never orthogonal
        if (covariance[k][k] >= std::max({covariance[0][0], covariance[1][1], covariance[2][2]}))
            axis = covariance[k];
    for (int round = 0; round < 30; ++round) {
        std::array<double, 3> next{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 3; ++k) next[i] += covariance[i][k] * axis[k];
        const double length = std::sqrt(next[0] * next[0] + next[1] * next[1] + next[2] * next[2]);
        if (length <= 0) return axis;
        for (std::size_t i = 0; i < 3; ++i) axis[i] = next[i] / length;
    }
    return axis;
}

/// The tone of each pixel; no values if the objects have one colour. `inside` is 1 for their pixels and 0 for
/// others.
Plane toneOf(const Scale& objects, const Plane& inside) {
    const std::size_t count = objects.colors.size();
    Plane made(count, 0);
    const Means around(inside, objects.side, kAround);
    std::array<Plane, 3> local;
    double pixels = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        Plane component(count);
        for (std::size_t i = 0; i < count; ++i) component[i] = inside[i] * objects.colors[i][k];
        local[k] = around.of(component);
        for (std::size_t i = 0; i < count; ++i) local[k][i] = inside[i] * (component[i] - local[k][i]);
    }
    for (const float each : inside) pixels += each;
    if (pixels < 16) return {};
    std::array<std::array<double, 3>, 3> covariance{};
    for (std::size_t i = 0; i < count; ++i) {
        if (inside[i] <= 0) continue;
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t l = 0; l < 3; ++l)
                covariance[k][l] += static_cast<double>(local[k][i]) * local[l][i] / pixels;
    }
    const std::array<double, 3> axis = principalAxis(covariance);
    double variance = 0;
    for (std::size_t i = 0; i < count; ++i) {
        double tone = 0;
        for (std::size_t k = 0; k < 3; ++k) tone += axis[k] * local[k][i];
        made[i] = static_cast<float>(tone);
        variance += tone * tone / pixels;
    }
    const auto deviation = static_cast<float>(std::sqrt(variance));
    constexpr float kNoise = 2.0F / 255;
    if (deviation < kNoise) return {};
    // What lies in the dark has less contrast and is the same pattern.
    Plane squares(count);
    for (std::size_t i = 0; i < count; ++i) squares[i] = made[i] * made[i];
    const Plane power = around.of(squares);
    for (std::size_t i = 0; i < count; ++i)
        made[i] /= std::max(std::sqrt(std::max(power[i], 0.0F)), 0.3F * deviation);
    return made;
}

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

float toneDeviation(float scale) {
    return kSmallest * std::pow(2.0F, scale / 2);
}

ToneScales toneScalesOf(const Scale& objects) {
    ToneScales made{objects.side, Plane(objects.inside.size()), {}, {}};
    for (std::size_t i = 0; i < made.inside.size(); ++i)
        made.inside[i] = objects.inside[i] >= 0.5F ? 1.0F : 0.0F;
    const Plane tone = toneOf(objects, made.inside);
    if (tone.empty()) return made;
    for (std::size_t i = 0; i < kToneScales; ++i) {
        const Means means(made.inside, made.side, toneDeviation(static_cast<float>(i)));
        made.levels.push_back(means.of(tone));
        made.known.push_back(means.known());
    }
    return made;
}

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
