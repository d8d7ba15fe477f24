#include "image/compare/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/text.h"
#include "image/bytes.h"
#include "image/compare/alike.h"
#include "image/compare/flip.h"
#include "image/compare/structure.h"
#include "image/convert.h"
#include "image/inspect.h"

namespace glibra::image {
namespace {

/// "1 pixel differs", "2 pixels in row 7 differ".
std::string differ(std::uint64_t pixels, std::string_view which = "") {
    return fmt::format("{}{} {}", base::counted(pixels, "pixel"), which, pixels == 1 ? "differs" : "differ");
}

/// A difference in 255ths with its place.
std::string largestDifference(const Comparison& found) {
    return fmt::format("the largest difference is {:.4g} of 255 at {}, {}", found.largest * 255, found.x,
                       found.y);
}

ExcessLimits limitsFor(const Image& a, const Image& b, const Tolerance& tolerance) {
    const double pixels = static_cast<double>(a.width) * a.height;
    ExcessLimits limits;
    limits.largest = tolerance.largest;
    limits.relativeOnly = a.type == Component::f32 && b.type == Component::f32;
    limits.relative = tolerance.relative;
    limits.absolute = tolerance.absolute;
    limits.allowed = static_cast<std::uint64_t>(std::max(std::floor(tolerance.fraction * pixels + 1e-9), 0.));
    limits.block = kBiasBlock;
    return limits;
}

/// The plain measures: their decision with the reason.
void judgePlainly(const ExcessLimits& limits, const Tolerance& tolerance, Judgement& result) {
    const std::string limit = limits.relativeOnly
                                  ? fmt::format("{:g} + {:g} of the value", limits.absolute, limits.relative)
                                  : fmt::format("{:g} of 255", limits.largest);
    result.decidedBy = Rung::differences;
    if (std::isinf(result.comparison.largest)) {
        result.reason = fmt::format("a value is NaN or infinite in only one of the pictures, at {}, {}",
                                    result.comparison.x, result.comparison.y);
    } else if (result.beyond > limits.allowed) {
        result.reason = fmt::format("{} by more than {} (allowed: {}); {}", differ(result.beyond), limit,
                                    limits.allowed, largestDifference(result.comparison));
    } else if (result.cluster > static_cast<std::uint64_t>(std::max(tolerance.cluster, 0))) {
        result.reason = fmt::format(
            "{} by more than {} (allowed: {}); {}",
            differ(result.cluster, fmt::format(" that touch at {}, {}", result.clusterX, result.clusterY)),
            limit, tolerance.cluster, largestDifference(result.comparison));
    } else if (result.line > static_cast<std::uint64_t>(std::max(tolerance.line, 0))) {
        const std::string line =
            result.lineY >= 0 ? fmt::format("row {}", result.lineY) : fmt::format("column {}", result.lineX);
        result.reason =
            fmt::format("{} by more than {} (allowed: {}); {}", differ(result.line, " in " + line), limit,
                        tolerance.line, largestDifference(result.comparison));
    } else if (result.bias > tolerance.bias) {
        result.decidedBy = Rung::bias;
        result.reason = fmt::format("the mean difference of the block at {}, {} is {}, the limit is {:g}",
                                    result.biasX, result.biasY, biasText(result, tolerance), tolerance.bias);
    } else {
        result.same = true;
        result.reason = result.beyond == 0
                            ? fmt::format("{}, within {}", largestDifference(result.comparison), limit)
                            : fmt::format("{} by more than {} (allowed: {})", differ(result.beyond), limit,
                                          limits.allowed);
    }
}

/// The pixel that firstOutOfRange() finds.
struct OutOfRange {
    int x = 0, y = 0;
};

/// The first pixel of two float pictures with a value outside of 0..1 that differs by more than the plain
/// limit. The perceptual measures see such values as 0 or 1.
std::optional<OutOfRange> firstOutOfRange(const Image& a, const Image& b, const ExcessLimits& limits) {
    if (a.type != Component::f32) return std::nullopt;
    const auto components = static_cast<std::size_t>(a.components);
    const auto isInRange = [](double value) { return value >= 0 && value <= 1; };
    for (int y = 0; y < a.height; ++y) {
        const std::byte* rowA = a.row(y).data();
        const std::byte* rowB = b.row(y).data();
        if (std::memcmp(rowA, rowB, a.rowBytes()) == 0) continue;
        for (std::size_t i = 0; i < static_cast<std::size_t>(a.width) * components; ++i) {
            const auto p = static_cast<double>(valueAt<float>(rowA, i)),
                       q = static_cast<double>(valueAt<float>(rowB, i));
            if (isInRange(p) && isInRange(q)) continue;
            if (p == q || (std::isnan(p) && std::isnan(q))) continue;
            const double allowed =
                limits.relativeOnly ? limits.absolute + limits.relative * std::max(std::abs(p), std::abs(q))
                                    : limits.largest / 255;
            if (!(std::abs(p - q) <= allowed)) return OutOfRange{static_cast<int>(i / components), y};
        }
    }
    return std::nullopt;
}

/// Applies one perceptual measure: false if the picture fails it.
bool judgeMeasure(Rung rung, const char* what, double value, double limit, Judgement& result) {
    result.same = value <= limit;
    result.decidedBy = rung;
    result.reason =
        fmt::format("{} is {:.4g}, {} {:g}", what, value, result.same ? "within" : "the limit is", limit);
    return result.same;
}

/// `outside`: see firstOutOfRange().
void judgePerceptually(const Image& expected, const Image& got, const Tolerance& tolerance, bool everything,
                       const std::optional<OutOfRange>& outside, Judgement& result) {
    const bool isFinite = !std::isinf(result.comparison.largest);
    const bool needed = !result.same && isFinite && !outside;
    if (!result.same && isFinite && outside && (tolerance.structure || tolerance.flip))
        result.reason +=
            fmt::format("; {} decide{} within 0..1 only, but values outside of it differ at {}, {}",
                        !tolerance.flip        ? "structure"
                        : !tolerance.structure ? "flip"
                                               : "flip and structure",
                        tolerance.flip && tolerance.structure ? "" : "s", outside->x, outside->y);
    if (everything || (needed && tolerance.structure)) result.structure = structure(expected, got).difference;
    const bool refused = needed && tolerance.structure &&
                         !judgeMeasure(Rung::structure, "the structural difference", *result.structure,
                                       *tolerance.structure, result);
    if (everything || (needed && tolerance.flip && !refused)) result.flip = flip(expected, got).mean;
    if (needed && tolerance.flip && !refused)
        judgeMeasure(Rung::flip, "the mean FLIP", *result.flip, *tolerance.flip, result);
}

Judgement equalBytes(const Image& picture) {
    Judgement result;
    result.same = true;
    result.reason = "equal";
    const NonFinite found = countNonFinite(picture);
    result.comparison.nonFinite = found.nan + found.infinite;
    if (result.comparison.nonFinite > 0)
        result.reason =
            fmt::format("equal, but {} components are NaN or infinite", result.comparison.nonFinite);
    return result;
}

}  // namespace

Tolerance exactTolerance() {
    Tolerance nothing;
    nothing.largest = nothing.fraction = nothing.bias = nothing.relative = nothing.absolute = 0;
    nothing.cluster = nothing.line = 0;
    return nothing;
}

Limited limitedBias(const Judgement& judged, const Tolerance& tolerance) {
    if (judged.bias <= 0 || judged.beyond == 0) return Limited::no;
    return judged.bias >= tolerance.largest * 0.9995 ? Limited::wholly : Limited::partly;
}

std::string biasText(const Judgement& judged, const Tolerance& tolerance) {
    const std::string figure = fmt::format("{:.3g} of 255", judged.bias);
    switch (limitedBias(judged, tolerance)) {
        case Limited::no:
            return figure;
        case Limited::partly:
            return figure + fmt::format(" (differences above {:g} count as {:g})", tolerance.largest,
                                        tolerance.largest);
        case Limited::wholly:
            break;
    }
    return "at least " + figure;
}

const char* name(Rung rung) {
    constexpr const char* kNames[] = {"size", "bytes", "differences", "bias", "structure", "flip"};
    return kNames[static_cast<std::size_t>(rung)];
}

Judgement judge(const Image& expected, const Image& got, const Tolerance& tolerance, bool everything) {
    Judgement result;
    if (expected.width != got.width || expected.height != got.height || !isConsistent(expected) ||
        !isConsistent(got)) {
        result.decidedBy = Rung::size;
        result.comparison.sameSize = result.comparison.identical = false;
        result.reason = fmt::format("the sizes differ: expected {} x {}, found {} x {}", expected.width,
                                    expected.height, got.width, got.height);
        return result;
    }
    if (expected.components == got.components && expected.type == got.type && expected.data == got.data)
        return equalBytes(expected);
    const ExcessLimits limits = limitsFor(expected, got, tolerance);
    std::optional<OutOfRange> outside;
    withAlike(expected, got, [&](const Image& a, const Image& b) {
        result.comparison = compare(a, b);
        if (result.comparison.identical) return;
        static_cast<Excess&>(result) = measureExcess(a, b, limits);
        if (tolerance.flip || tolerance.structure) outside = firstOutOfRange(a, b, limits);
    });
    if (result.comparison.identical) {
        result.same = true;
        result.reason = "equal values";
        return result;
    }
    judgePlainly(limits, tolerance, result);
    judgePerceptually(expected, got, tolerance, everything, outside, result);
    return result;
}

}  // namespace glibra::image
