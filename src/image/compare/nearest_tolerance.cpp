#include "image/compare/nearest_tolerance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "image/compare/alike.h"

namespace glibra::image {
namespace {

/// The widest limits that are proposed: they pass small things, and no shape.
constexpr double kMostLargest = 16, kMostFraction = .01, kMostBias = 3, kMostPerceptual = .05;
constexpr int kMostCluster = 64, kMostLine = 128;
/// A float picture may differ near zero, too, where a share of the value allows nothing.
constexpr double kAbsoluteParts = 100;

bool areFloats(const Image& a, const Image& b) {
    return a.type == Component::f32 && b.type == Component::f32;
}

/// The least number of so many decimal places that is not below the value.
double roundedUp(double value, int places) {
    const double scale = std::pow(10, places);
    const double rounded = std::ceil(value * scale) / scale;
    return rounded >= value ? rounded : (std::ceil(value * scale) + 1) / scale;
}

/// The shortest fraction by which judge() allows exactly so many of the pixels.
double fractionFor(std::uint64_t allowed, double pixels) {
    constexpr int kMostPlaces = 12;
    double fraction = 0;
    for (int places = 1; places <= kMostPlaces; ++places) {
        fraction = roundedUp(static_cast<double>(allowed) / pixels, places);
        if (std::floor(fraction * pixels + 1e-9) <= static_cast<double>(allowed)) break;
    }
    return fraction;
}

/// A tolerance that passes, and how much wider it is.
struct Candidate {
    Tolerance tolerance;
    double cost = std::numeric_limits<double>::infinity();  ///< logarithm of the product of all multiples
    std::string tooMuch;                                    ///< why it is too wide to be proposed; or empty
    bool isLast = false;  ///< no pixel differs by more than its limit, so that no wider one is needed
};

class Search {
  public:
    Search(const Image& expected, const Image& got, const Tolerance& stated)
        : expected_(expected),
          got_(got),
          stated_(stated),
          isFloat_(areFloats(expected, got)),
          pixels_(static_cast<double>(expected.width) * expected.height) {}

    /// The candidates with each limit of single differences, the narrowest first.
    [[nodiscard]] std::vector<Candidate> candidates() const {
        std::vector<Candidate> all{withLimit(stated_)};
        if (isFloat_) {
            for (const double relative :
                 {1e-6, 2e-6, 5e-6, 1e-5, 2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2, 2e-2}) {
                Tolerance wider = stated_;
                wider.relative = relative;
                wider.absolute = std::max(stated_.absolute, relative / kAbsoluteParts);
                if (relative > stated_.relative && !all.back().isLast) all.push_back(withLimit(wider));
            }
            return all;
        }
        for (double limit = std::floor(stated_.largest) + 1; limit <= kMostLargest && !all.back().isLast;
             ++limit) {
            Tolerance wider = stated_;
            wider.largest = limit;
            all.push_back(withLimit(wider));
        }
        return all;
    }

  private:
    /// The tolerance with its other limits raised to what the pictures need.
    [[nodiscard]] Candidate withLimit(Tolerance tolerance) const {
        const double mostFraction = std::max(kMostFraction, stated_.fraction);
        const Excess found =
            excessBeyond(expected_, got_, tolerance,
                         static_cast<std::uint64_t>(std::floor(mostFraction * pixels_ + 1e-9)));
        const std::string limit =
            isFloat_ ? fmt::format("{:g} + {:g} of the value", tolerance.absolute, tolerance.relative)
                     : fmt::format("{:g} of 255", tolerance.largest);
        const auto beyond = static_cast<double>(found.beyond);
        if (beyond > std::floor(stated_.fraction * pixels_ + 1e-9))
            tolerance.fraction = fractionFor(found.beyond, pixels_);
        tolerance.cluster = std::max(tolerance.cluster, clamped(found.cluster));
        tolerance.line = std::max(tolerance.line, clamped(found.line));
        if (found.bias > tolerance.bias) tolerance.bias = roundedUp(found.bias, 2);
        Candidate candidate{tolerance, 0, {}, found.beyond == 0};
        if (beyond > mostFraction * pixels_)
            candidate.tooMuch =
                fmt::format("{:.3g} % of the pixels differ by more than {}", 100 * beyond / pixels_, limit);
        else if (tolerance.cluster > std::max(kMostCluster, stated_.cluster))
            candidate.tooMuch =
                fmt::format("{} pixels that touch differ by more than {}", found.cluster, limit);
        else if (tolerance.line > std::max(kMostLine, stated_.line))
            candidate.tooMuch =
                fmt::format("{} pixels of one row or column differ by more than {}", found.line, limit);
        else if (tolerance.bias > std::max(kMostBias, stated_.bias))
            candidate.tooMuch = fmt::format("a block is lighter or darker by {} on average",
                                            biasText(wholeOf(found), tolerance));
        const Tolerance usual;
        const auto add = [&](double is, double was, double normal) {
            candidate.cost += std::log(std::max(is, normal) / std::max(was, normal));
        };
        if (isFloat_)
            add(tolerance.relative, stated_.relative, usual.relative);
        else
            add(tolerance.largest, stated_.largest, usual.largest);
        add(tolerance.fraction, stated_.fraction, usual.fraction);
        add(tolerance.cluster, stated_.cluster, usual.cluster);
        add(tolerance.line, stated_.line, usual.line);
        add(tolerance.bias, stated_.bias, usual.bias);
        return candidate;
    }
    static Judgement wholeOf(const Excess& found) {
        Judgement judged;
        static_cast<Excess&>(judged) = found;
        return judged;
    }
    static int clamped(std::uint64_t count) {
        return static_cast<int>(std::min<std::uint64_t>(count, std::numeric_limits<int>::max()));
    }

    const Image& expected_;
    const Image& got_;
    const Tolerance& stated_;
    bool isFloat_;
    double pixels_;
};

/// The stated perceptual limits, raised so that they pass.
std::optional<Tolerance> raisedPerceptual(const Tolerance& stated, const Judgement& judged) {
    constexpr int kPlaces = 4;
    Tolerance raised = stated;
    for (const auto& [limit, value] :
         {std::pair(&raised.flip, &judged.flip), {&raised.structure, &judged.structure}}) {
        if (!*limit) continue;
        if (!*value) return std::nullopt;
        if (**value > **limit) *limit = roundedUp(**value, kPlaces);
        if (**limit > kMostPerceptual) return std::nullopt;
    }
    return raised;
}

}  // namespace

DifferenceSteps differenceSteps(const Image& expected, const Image& got) {
    DifferenceSteps steps;
    if (!areComparable(expected, got)) return steps;
    const bool isFloat = areFloats(expected, got);
    steps.limits =
        isFloat ? std::vector{1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1} : std::vector{0., 1., 2., 4., 8., 16.};
    for (const double limit : steps.limits) {
        Tolerance tolerance;
        tolerance.largest = tolerance.relative = limit;
        tolerance.absolute = limit / kAbsoluteParts;
        steps.pixels.push_back(excessBeyond(expected, got, tolerance, 0).beyond);
    }
    return steps;
}

NearestTolerance nearestTolerance(const Image& expected, const Image& got, const Tolerance& stated,
                                  const Judgement& judged) {
    NearestTolerance nearest;
    if (!areComparable(expected, got)) {
        nearest.whyNone = "the sizes differ";
        return nearest;
    }
    if (std::isinf(judged.comparison.largest)) {
        nearest.whyNone = "a value is NaN or infinite in only one of the pictures";
        return nearest;
    }
    const auto passes = [&](const Tolerance& tolerance) { return judge(expected, got, tolerance).same; };
    if (stated.flip || stated.structure)
        if (const std::optional<Tolerance> raised = raisedPerceptual(stated, judged);
            raised && passes(*raised)) {
            nearest.tolerance = raised;
            return nearest;
        }
    Candidate best;
    for (Candidate& each : Search(expected, got, stated).candidates()) {
        if (each.tooMuch.empty() && each.cost < best.cost)
            best = std::move(each);
        else if (!each.tooMuch.empty())
            nearest.whyNone = std::move(each.tooMuch);  // that of the widest limit stays
    }
    if (!std::isfinite(best.cost)) return nearest;
    nearest.whyNone.clear();
    if (passes(best.tolerance)) nearest.tolerance = best.tolerance;
    return nearest;
}

}  // namespace glibra::image
