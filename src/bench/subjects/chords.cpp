// Chords of a Bézier curve whose parameter is slow at the bend, and of a graph with a steep step.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <utility>

#include "bench/core/fit.h"
#include "bench/subjects/curves.h"

namespace glibra::bench {
namespace {

using Cubic = std::array<glm::dvec2, 4>;

/// Almost a cusp in the middle; length 1 from end to end.
constexpr Cubic kCurve{glm::dvec2(0, 0), glm::dvec2(.96, 1), glm::dvec2(.04, 1), glm::dvec2(1, 0)};

/// Horner's scheme in powers of t, as programs evaluate it.
glm::dvec2 powerForm(double t) {
    const glm::dvec2 first = 3. * (kCurve[1] - kCurve[0]),
                     second = 3. * (kCurve[0] - 2. * kCurve[1] + kCurve[2]),
                     third = kCurve[3] - 3. * kCurve[2] + 3. * kCurve[1] - kCurve[0];
    return kCurve[0] + t * (first + t * (second + t * third));
}

/// De Casteljau's algorithm.
glm::dvec2 byDeCasteljau(double t) {
    Cubic p = kCurve;
    for (std::size_t level = 3; level > 0; --level)
        for (std::size_t i = 0; i < level; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
    return p[0];
}

constexpr double kSteepness = 200;

glm::dvec2 step(double t) {
    return {t, .25 * std::tanh(kSteepness * (t - .4))};
}

/// The same with exponentials.
glm::dvec2 stepByExponentials(double t) {
    return {t, .25 - .5 / (std::exp(2 * kSteepness * (t - .4)) + 1)};
}

/// t runs from 0 to 1.
struct ChordShape {
    const char *name, *title, *reference;
    glm::dvec2 (*place)(double t);
    glm::dvec2 (*truth)(double t);  ///< by another formula
};

constexpr ChordShape kBezierShape{
    "chords", "A Bézier curve with a narrow bend, as line segments",
    "de Casteljau's algorithm in double at 32 points of every segment; a length is that from end to end",
    powerForm, byDeCasteljau};
constexpr ChordShape kStepShape{
    "chords-step", "A graph with a steep step, as line segments",
    "the step from exponentials in double at 32 points of every segment; a length is that of the t axis",
    step, stepByExponentials};

struct Vertex {
    double t = 0;
    glm::dvec2 place{0};
};

using Chain = std::vector<Vertex>;

Chain byFixedSteps(const ChordShape& shape, int steps) {
    Chain chain;
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        chain.push_back({t, shape.place(t)});
    }
    return chain;
}

double distanceFromChord(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = b - a;
    const double square = glm::dot(along, along);
    const double s = square > 0 ? std::clamp(glm::dot(p - a, along) / square, 0., 1.) : 0.;
    return glm::distance(p, a + s * along);
}

/// Halves a part until points at its quarters are within the tolerance of the chord.
void addFlat(Chain& chain, const ChordShape& shape, const Vertex& from, const Vertex& to, double tolerance) {
    constexpr double kShortestPart = 1e-9, kLongestPart = .125;
    const auto at = [&](double share) {
        const double t = std::lerp(from.t, to.t, share);
        return Vertex{t, shape.place(t)};
    };
    const Vertex middle = at(.5);
    const auto isNear = [&](const Vertex& v) {
        return distanceFromChord(v.place, from.place, to.place) <= tolerance;
    };
    const double length = to.t - from.t;
    const bool isFlat = length <= kLongestPart && isNear(middle) && isNear(at(.25)) && isNear(at(.75));
    if (isFlat || length < kShortestPart) {
        chain.push_back(to);
        return;
    }
    addFlat(chain, shape, from, middle, tolerance);
    addFlat(chain, shape, middle, to, tolerance);
}

Chain byFlatness(const ChordShape& shape, double tolerance) {
    const Vertex from{0, shape.place(0)}, to{1, shape.place(1)};
    Chain chain{from};
    addFlat(chain, shape, from, to, tolerance);
    return chain;
}

/// The largest distance of the curve from its chords, at 32 points of each.
double largestDistance(const ChordShape& shape, const Chain& chain) {
    constexpr int kPointsEach = 32;
    double largest = 0;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        for (int k = 1; k < kPointsEach; ++k) {
            const double t = std::lerp(chain[i].t, chain[i + 1].t, static_cast<double>(k) / kPointsEach);
            largest =
                std::max(largest, distanceFromChord(shape.truth(t), chain[i].place, chain[i + 1].place));
        }
    return largest;
}

Point chordPoint(const ChordShape& shape, const Chain& chain, std::string label, const Timing& time) {
    return {.setting = static_cast<double>(chain.size() - 1),
            .label = std::move(label),
            .error = largestDistance(shape, chain),
            .time = time,
            .memory = static_cast<double>(chain.size()) * 2 * sizeof(float)};
}

}  // namespace

Figure chordFigure(const Bench& bench, bool isStep) {
    const ChordShape& shape = isStep ? kStepShape : kBezierShape;
    Figure figure;
    figure.name = shape.name;
    figure.title = shape.title;
    figure.reference = shape.reference;
    figure.settingName = "segments";
    figure.errorName = "largest distance of curve and chord";
    figure.errorUnit = "lengths";
    Curve fixed{"fixed steps of t", {}}, adaptive{"halved until flat", {}};
    const int finest = bench.isQuick() ? 1024 : 8192;
    for (int steps = 8; steps <= finest; steps *= 2)
        fixed.points.push_back(chordPoint(shape, byFixedSteps(shape, steps),
                                          fmt::format("{} segments", steps),
                                          bench.time([&] { byFixedSteps(shape, steps); })));
    const int smallest = bench.isQuick() ? -16 : -20;
    for (int power = -4; power >= smallest; power -= 2) {
        const double tolerance = std::ldexp(1., power);
        adaptive.points.push_back(chordPoint(shape, byFlatness(shape, tolerance),
                                             fmt::format("tolerance 2^{}", power),
                                             bench.time([&] { byFlatness(shape, tolerance); })));
    }
    figure.findings = {orderSentence(fixed, "segments", 256), orderSentence(adaptive, "segments", 30)};
    // The number of fixed steps that reaches the error of the finest adaptive chain, by the fitted order.
    const double order = fittedOrder(fixed, 256);
    const Point &goal = adaptive.points.back(), &from = fixed.points.back();
    const double needed = from.setting * std::pow(goal.error / from.error, 1 / order);
    figure.findings.push_back(
        fmt::format("{} segments halved until flat are {} lengths off; fixed steps take {:.0f} segments for "
                    "that, {:.2g} times as many",
                    goal.setting, numberText(goal.error), needed, needed / goal.setting));
    figure.curves = {std::move(fixed), std::move(adaptive)};
    return figure;
}

}  // namespace glibra::bench
