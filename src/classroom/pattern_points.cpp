#include "classroom/pattern_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glibra::classroom {
namespace {

constexpr float kSmallest = 1.4F;  // radius of the smallest blob, in pixels
constexpr int kLevels = 8;         // of blobs, each larger by the square root of two
constexpr float kAround = 16;      // pixels over which colours are compared with their mean
constexpr std::size_t kMostPoints = 90;

/// One number per pixel of a scale.
using Plane = std::vector<float>;

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

struct Tones {
    Plane inside, tone;
    double contrast = 0;
};

Tones tonesOf(const Scale& objects) {
    const std::size_t count = objects.colors.size();
    Tones made{Plane(count), Plane(count, 0), 0};
    for (std::size_t i = 0; i < count; ++i) made.inside[i] = objects.inside[i] >= 0.5F ? 1.0F : 0.0F;
    const Means around(made.inside, objects.side, kAround);
    std::array<Plane, 3> local;
    std::array<double, 3> mean{};
    double pixels = 0, all = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        Plane component(count);
        for (std::size_t i = 0; i < count; ++i) {
            component[i] = made.inside[i] * objects.colors[i][k];
            mean[k] += component[i];
        }
        local[k] = around.of(component);
        for (std::size_t i = 0; i < count; ++i) local[k][i] = made.inside[i] * (component[i] - local[k][i]);
    }
    for (const float each : made.inside) pixels += each;
    if (pixels < 16) return made;
    std::array<std::array<double, 3>, 3> covariance{};
    for (std::size_t i = 0; i < count; ++i) {
        if (made.inside[i] <= 0) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            all += std::pow(objects.colors[i][k] - mean[k] / pixels, 2) / pixels;
            for (std::size_t l = 0; l < 3; ++l)
                covariance[k][l] += static_cast<double>(local[k][i]) * local[l][i] / pixels;
        }
    }
    const std::array<double, 3> axis = principalAxis(covariance);
    double variance = 0;
    for (std::size_t i = 0; i < count; ++i) {
        double tone = 0;
        for (std::size_t k = 0; k < 3; ++k) tone += axis[k] * local[k][i];
        made.tone[i] = static_cast<float>(tone);
        variance += tone * tone / pixels;
    }
    made.contrast = all > 0 ? std::sqrt(variance / all) : 0;
    const auto deviation = static_cast<float>(std::sqrt(variance));
    constexpr float kNoise = 2.0F / 255;
    if (deviation < kNoise) {
        made.contrast = 0;
        return made;
    }
    // What lies in the dark has less contrast and is the same pattern.
    Plane squares(count);
    for (std::size_t i = 0; i < count; ++i) squares[i] = made.tone[i] * made.tone[i];
    const Plane power = around.of(squares);
    for (std::size_t i = 0; i < count; ++i)
        made.tone[i] /= std::max(std::sqrt(std::max(power[i], 0.0F)), 0.3F * deviation);
    return made;
}

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

/// The largest correlation of two surroundings over all angles; places that one of them does not know are left
/// out.
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
        if (n < 0.6F * kRings * kAngles) continue;
        const float varianceA = aa - sumA * sumA / n, varianceB = bb - sumB * sumB / n;
        if (varianceA <= 0 || varianceB <= 0) continue;
        best = std::max(best, (ab - sumA * sumB / n) / std::sqrt(varianceA * varianceB));
    }
    return best;
}

}  // namespace

PatternPoints findPatternPoints(const Scale& objects) {
    PatternPoints found;
    const int side = objects.side;
    const Tones tones = tonesOf(objects);
    found.contrast = tones.contrast;
    if (tones.contrast <= 0) return found;
    // levels[i] is smoothed by kSmallest * 2^((i - 1) / 2), so that blobs of level i have that radius.
    std::vector<Plane> levels;
    const auto radiusOf = [](float level) { return kSmallest * std::pow(2.0F, level / 2); };
    for (int i = 0; i <= kLevels; ++i)
        levels.push_back(Means(tones.inside, side, radiusOf(static_cast<float>(i) - 0.5F)).of(tones.tone));
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
            int best = 0;
            for (int i = 0; i < kLevels; ++i) {
                response[static_cast<std::size_t>(i)] =
                    levels[static_cast<std::size_t>(i)][at] - levels[static_cast<std::size_t>(i) + 1][at];
                if (std::abs(response[static_cast<std::size_t>(i)]) > std::abs(response[static_cast<std::size_t>(best)]))
                    best = i;
            }
            const float strength = response[static_cast<std::size_t>(best)];
            float level = static_cast<float>(best);
            if (best > 0 && best + 1 < kLevels) {  // the parabola through three levels
                const float below = std::abs(response[static_cast<std::size_t>(best) - 1]),
                            above = std::abs(response[static_cast<std::size_t>(best) + 1]);
                const float bend = below + above - 2 * std::abs(strength);
                if (bend < 0) level += 0.5F * (below - above) / bend;
            }
            candidates.push_back({strength, level, x, y});
        }
    if (candidates.empty()) return found;
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return std::abs(a.strength) > std::abs(b.strength);
    });
    const float least = 0.25F * std::abs(candidates[candidates.size() / 50].strength);
    double covered = 0, pixels = 0;
    Plane isCovered(tones.inside.size(), 0);
    for (const Candidate& each : candidates) {
        if (std::abs(each.strength) < least || found.points.size() >= kMostPoints) break;
        const float radius = radiusOf(each.level);
        const auto x = static_cast<float>(each.x), y = static_cast<float>(each.y);
        if (std::any_of(found.points.begin(), found.points.end(), [&](const PatternPoint& other) {
                const float near = 1.3F * std::max(radius, other.radius);
                return (other.x - x) * (other.x - x) + (other.y - y) * (other.y - y) < near * near;
            }))
            continue;
        PatternPoint& point = found.points.emplace_back();
        point.x = x;
        point.y = y;
        point.radius = radius;
        point.strength = std::abs(each.strength);
        const auto level = static_cast<std::size_t>(std::clamp(each.level - 1.5F, 0.0F, static_cast<float>(kLevels)));
        readAround(point, levels[level], tones.inside, side, each.strength < 0 ? -1.0F : 1.0F);
        const int reach = static_cast<int>(3 * radius);
        for (int v = std::max(0, each.y - reach); v <= std::min(side - 1, each.y + reach); ++v)
            for (int u = std::max(0, each.x - reach); u <= std::min(side - 1, each.x + reach); ++u)
                isCovered[static_cast<std::size_t>(v * side + u)] = 1;
    }
    for (std::size_t i = 0; i < isCovered.size(); ++i) {
        pixels += tones.inside[i];
        covered += tones.inside[i] * isCovered[i];
    }
    found.covered = pixels > 0 ? covered / pixels : 0;
    return found;
}

double foundAgain(const PatternPoints& a, const PatternPoints& b) {
    if (a.points.empty() || b.points.empty()) return 0;
    std::vector<float> bestA(a.points.size(), 0), bestB(b.points.size(), 0);
    for (std::size_t i = 0; i < a.points.size(); ++i)
        for (std::size_t k = 0; k < b.points.size(); ++k) {
            const float value = correlationOf(a.points[i], b.points[k]);
            bestA[i] = std::max(bestA[i], value);
            bestB[k] = std::max(bestB[k], value);
        }
    const auto mean = [](const std::vector<float>& best, const std::vector<PatternPoint>& points) {
        double sum = 0, weights = 0;
        for (std::size_t i = 0; i < best.size(); ++i) {
            sum += static_cast<double>(points[i].radius) * best[i];
            weights += points[i].radius;
        }
        return weights > 0 ? sum / weights : 0;
    };
    return std::sqrt(mean(bestA, a.points) * mean(bestB, b.points));
}

}  // namespace glibra::classroom
