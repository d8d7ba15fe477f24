#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "bench/core/fit.h"
#include "bench/draw/depth_target.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

constexpr double kNear = 1;  // only ratios matter
constexpr int kBufferSide = 256;
constexpr const char* kOrderReference =
    "the order of the two distances, known in double; theory: one step of the buffer times z^2 (f - n) / (f "
    "n)";

/// Gaps as shares of the distance, rising.
std::vector<double> triedGaps(bool isQuick) {
    const int perOctave = isQuick ? 4 : 8;
    constexpr int kOctaves = 25;
    std::vector<double> gaps;
    for (int i = -kOctaves * perOctave; i <= 0; ++i)
        gaps.push_back(std::exp2(static_cast<double>(i) / perOctave));
    return gaps;
}

/// The smallest gap, as a share of z, such that every gap from there on is resolved at all distances from .7
/// z to z, which meet the steps of the buffer in every phase; NaN if not even the largest is.
Result<double> smallestGap(DepthTarget& target, const DepthKind& kind, double far, double z, bool isQuick) {
    const std::vector<double> gaps = triedGaps(isQuick);
    const std::size_t jitters = isQuick ? 32 : 96;
    std::vector<DepthPair> pairs;
    for (std::size_t jitter = 0; jitter < jitters; ++jitter)
        for (const double gap : gaps) {
            const double there = z * (1 - .3 * static_cast<double>(jitter) / static_cast<double>(jitters));
            pairs.push_back({there, std::min(there * (1 + gap), far)});
        }
    Result<std::vector<bool>> isResolved = target.resolvePairs(kind, kNear, far, pairs);
    if (!isResolved) return std::move(isResolved.diagnostics);
    std::size_t first = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (!(*isResolved)[i]) first = std::max(first, i % gaps.size() + 1);
    return first < gaps.size() ? gaps[first] : kNaN;
}

/// Bits per pixel: 24 bits are stored in 32.
double bitsKept(const DepthKind& kind) {
    return kind.format == GL_DEPTH_COMPONENT16 ? 16 : 32;
}
/// Bytes of a buffer with `side` x `side` pixels.
double bufferBytes(const DepthKind& kind, int side) {
    return bitsKept(kind) / 8 * side * side;
}

/// The place where a gap is measured.
struct GapPlace {
    double setting = 0, far = 0, z = 0;
    std::string label;
};

std::string againstTheory(const Curve& measured, const Curve& theory) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (std::size_t i = 0; i < measured.points.size(); ++i) {
        const double steps = measured.points[i].error / theory.points[i].error;
        if (std::isnan(steps)) continue;
        least = std::min(least, steps);
        most = std::max(most, steps);
    }
    if (most == 0) return fmt::format("{}: nothing is resolved", measured.name);
    return fmt::format("{}: the smallest gap is {:.2g} to {:.2g} times one step in theory", measured.name,
                       least, most);
}

/// A measured curve and a theoretical one for each kind.
Diagnostics sweep(Figure& figure, const Bench& bench, const gpu::Capabilities& capabilities,
                  const std::vector<GapPlace>& places) {
    std::vector<Curve> theories;
    for (const DepthKind& kind : usableKinds(capabilities)) {
        Result<DepthTarget> target = DepthTarget::create(capabilities, kind.format, kBufferSide);
        if (!target) return std::move(target.diagnostics);
        // A scene has no statement that turns depth round.
        Curve curve{.name = std::string(kind.name), .isForScenes = !kind.isReversed};
        Curve theory{.name = fmt::format("theory: {}", kind.name), .theoryOf = figure.curves.size()};
        for (const GapPlace& place : places) {
            Result<double> gap = smallestGap(*target, kind, place.far, place.z, bench.isQuick());
            if (!gap) return std::move(gap.diagnostics);
            curve.points.push_back({.setting = place.setting,
                                    .label = place.label,
                                    .error = *gap,
                                    .memory = bufferBytes(kind, kBufferSide)});
            theory.points.push_back({.setting = place.setting,
                                     .label = place.label,
                                     .error = depthStep(kind, kNear, place.far, place.z) / place.z});
        }
        figure.findings.push_back(againstTheory(curve, theory));
        figure.curves.push_back(std::move(curve));
        theories.push_back(std::move(theory));
    }
    std::ranges::move(theories, std::back_inserter(figure.curves));
    if (!capabilities.atLeast(4, 5))
        figure.findings.emplace_back(
            "this driver has no glClipControl (GL 4.5), so that reversed depth in 0..1 is not measured");
    return {};
}

std::vector<double> ratios(bool isQuick) {
    std::vector<double> values;
    const int perDecade = isQuick ? 1 : 3;
    for (int i = perDecade; i <= 7 * perDecade; ++i)
        values.push_back(std::pow(10, static_cast<double>(i) / perDecade));
    return values;
}

/// The geometric mean of one curve's errors over another's, at the points where both have one.
double meanRatio(const Curve& above, const Curve& below) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < above.points.size(); ++i) {
        const double ratio = std::log(above.points[i].error / below.points[i].error);
        if (!std::isfinite(ratio)) continue;
        sum += ratio;
        ++count;
    }
    return count > 0 ? std::exp(sum / count) : kNaN;
}

Figure gapFigure(std::string name, std::string title, std::string settingName) {
    return {.name = std::move(name),
            .title = std::move(title),
            .settingName = std::move(settingName),
            .errorName = "smallest gap that is always resolved",
            .errorUnit = "distances",
            .reference = kOrderReference,
            .alternatives = Alternatives::setting};
}

Result<Figure> gapByRatio(const Bench& bench, const gpu::Capabilities& capabilities) {
    Figure figure = gapFigure("gap-by-range", "Smallest gap resolved at half the far distance", "far / near");
    std::vector<GapPlace> places;
    for (const double ratio : ratios(bench.isQuick()))
        places.push_back({ratio, kNear * ratio, kNear * ratio / 2, fmt::format("{:.3g}:1", ratio)});
    Diagnostics problems = sweep(figure, bench, capabilities, places);
    if (!problems.empty()) return problems;
    for (const Curve& curve : figure.curves) {
        if (curve.theoryOf) continue;
        double widest = 0;
        for (const Point& point : curve.points)
            if (point.error <= .001) widest = std::max(widest, point.setting);
        figure.findings.push_back(fmt::format(
            "{}: a gap of 1/1000 of the distance is resolved up to far / near = {:.3g}", curve.name, widest));
    }
    figure.findings.push_back(
        fmt::format("floats that are not reversed: their smallest gaps are {:.3g} times those of 24 bits "
                    "(geometric mean)",
                    meanRatio(figure.curves[2], figure.curves[1])));
    return figure;
}

Result<Figure> gapByDistance(const Bench& bench, const gpu::Capabilities& capabilities) {
    constexpr double kFar = 1e4;
    Figure figure =
        gapFigure("gap-by-distance", "Smallest gap resolved, far / near = 10000", "distance / near");
    std::vector<GapPlace> places;
    for (int octave = 1; octave <= 12; octave += bench.isQuick() ? 3 : 1) {
        const double z = std::ldexp(1., octave);
        places.push_back({z, kFar, z, fmt::format("{:g}", z)});
    }
    Diagnostics problems = sweep(figure, bench, capabilities, places);
    if (!problems.empty()) return problems;
    for (const Curve& curve : figure.curves)
        if (!curve.theoryOf) figure.findings.push_back(orderSentence(curve, "distance", 8));
    return figure;
}

Result<Figure> fightingByGap(const Bench& bench, const gpu::Capabilities& capabilities) {
    constexpr double kFar = 1e4, kDistance = 1e3;
    Figure figure{.name = "fighting",
                  .title = "Two tilted planes at 1000 times the near distance, far / near = 10000",
                  .settingName = "steps of the buffer between them",
                  .errorName = "pixels in which the farther one wins",
                  .errorUnit = "",
                  .reference = "the nearer plane, which must be visible in every pixel",
                  .alternatives = Alternatives::none};
    for (const DepthKind& kind : usableKinds(capabilities)) {
        Result<DepthTarget> target = DepthTarget::create(capabilities, kind.format, kBufferSide);
        if (!target) return std::move(target.diagnostics);
        Curve curve{.name = std::string(kind.name)};
        double clean = kNaN;
        for (int half = -6; half <= 12; half += bench.isQuick() ? 2 : 1) {
            const double steps = std::exp2(half / 2.);
            const double gap = steps * depthStep(kind, kNear, kFar, kDistance) / kDistance;
            Result<double> wrong = target->fighting(kind, kNear, kFar, kDistance, gap);
            if (!wrong) return std::move(wrong.diagnostics);
            curve.points.push_back({.setting = steps,
                                    .label = fmt::format("{:.3g} steps", steps),
                                    .error = *wrong,
                                    .memory = bufferBytes(kind, kBufferSide)});
            if (*wrong > 0)
                clean = kNaN;
            else if (std::isnan(clean))
                clean = steps;
        }
        figure.findings.push_back(
            fmt::format("{}: no pixel is wrong from {} steps on", curve.name, numberText(clean)));
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

Result<Figure> cost(const Bench& bench, const gpu::Capabilities& capabilities) {
    constexpr double kFar = 1e4;
    constexpr int kCostSide = 512, kLayers = 8;
    Figure figure{
        .name = "cost",
        .title = "Eight layers of 512 x 512 pixels; gap at half the far distance, far / near = 10000",
        .settingName = "bits per pixel",
        .errorName = "smallest gap that is always resolved",
        .errorUnit = "distances",
        .reference = kOrderReference};
    for (const DepthKind& kind : usableKinds(capabilities)) {
        Result<DepthTarget> target = DepthTarget::create(capabilities, kind.format, kCostSide);
        if (!target) return std::move(target.diagnostics);
        Result<double> gap = smallestGap(*target, kind, kFar, kFar / 2, bench.isQuick());
        if (!gap) return std::move(gap.diagnostics);
        Diagnostics problems;
        const Timing timing = bench.time([&] { problems = target->drawLayers(kind, kLayers); });
        if (!problems.empty()) return problems;
        figure.curves.push_back({.name = std::string(kind.name),
                                 .points = {{.setting = bitsKept(kind),
                                             .label = std::string(kind.name),
                                             .error = *gap,
                                             .time = timing,
                                             .memory = bufferBytes(kind, kCostSide)}},
                                 .isForScenes = !kind.isReversed});
    }
    const Point& standard = figure.curves[1].points.front();
    const Point& last = figure.curves.back().points.front();
    figure.findings.push_back(fmt::format(
        "{} takes {:.2f} times the time of {} and resolves gaps that are {:.3g} times smaller", last.label,
        last.time->median / standard.time->median, standard.label, standard.error / last.error));
    return figure;
}

}  // namespace

Result<std::vector<Figure>> measureDepth(Bench& bench) {
    Result<gpu::Context*> context = bench.context();
    if (!context) return std::move(context.diagnostics);
    return measureEach({gapByRatio, gapByDistance, fightingByGap, cost}, bench, (*context)->capabilities());
}

}  // namespace glibra::bench
