#include "classroom/tone_scales.h"

#include <algorithm>
#include <array>
#include <cmath>

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

}  // namespace glibra::classroom
