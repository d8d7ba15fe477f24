#include "image/compare/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "base/text.h"
#include "image/bytes.h"
#include "image/compare/alike.h"
#include "image/compare/flip.h"

namespace glibra::image {
namespace {

struct ExcessLimits {
    double largest = 0;         ///< 255ths of the range
    bool relativeOnly = false;  ///< float pictures: a value may differ by absolute + relative max(|a|, |b|)
    double relative = 0, absolute = 0;
    std::uint64_t allowed = 0;  ///< pixels that may differ by more; if more do, clusters are not searched
    int block = 16;             ///< side of the blocks in pixels, at most 64
};

/// Signed differences and limits of integers are in steps of their type, those of floats in units of 1.
template <class Value>
using Step = std::conditional_t<std::is_same_v<Value, std::uint8_t>, std::int16_t,
                                std::conditional_t<std::is_integral_v<Value>, std::int32_t, double>>;

template <class Value>
constexpr double kFull =
    std::is_integral_v<Value> ? static_cast<double>(std::numeric_limits<Value>::max()) : 1;

template <class Value>
Step<Value> limitOf(const ExcessLimits& limits) {
    const double limit = std::clamp(limits.largest, 0., 255.) / 255 * kFull<Value>;
    // A limit such as 3/255 of 65535 must not become 770.99...
    return static_cast<Step<Value>>(std::is_integral_v<Value> ? std::floor(limit + 1e-9) : limit);
}

/// Adds the differences of a row, each limited to +-limit, to `sums`; true if any exceeds the limit.
template <class Value>
bool addRow(const std::byte* a, const std::byte* b, std::size_t count, Step<Value> limit, Step<Value>* sums) {
    int beyond = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto d = static_cast<Step<Value>>(valueAt<Value>(a, i) - valueAt<Value>(b, i));
        const Step<Value> low = d < limit ? d : limit;
        const Step<Value> limited = low > -limit ? low : static_cast<Step<Value>>(-limit);
        beyond |= limited != d ? 1 : 0;
        sums[i] = static_cast<Step<Value>>(sums[i] + limited);
    }
    return beyond != 0;
}

/// The same for floats: equal infinities and NaN against NaN are no difference; NaN against a number is a
/// difference of `limit`.
template <>
bool addRow<float>(const std::byte* a, const std::byte* b, std::size_t count, double limit, double* sums) {
    bool beyond = false;
    for (std::size_t i = 0; i < count; ++i) {
        const auto p = static_cast<double>(valueAt<float>(a, i)),
                   q = static_cast<double>(valueAt<float>(b, i));
        if (p == q || (std::isnan(p) && std::isnan(q))) continue;
        const double d = p - q;
        beyond |= !(std::abs(d) <= limit);
        sums[i] += std::isnan(d) ? limit : std::clamp(d, -limit, limit);
    }
    return beyond;
}

/// True if the values differ by more than allowed.
template <class Value>
bool isBeyond(Value a, Value b, Step<Value> limit, const ExcessLimits& limits) {
    if constexpr (std::is_integral_v<Value>) {
        return std::abs(static_cast<std::int32_t>(a) - static_cast<std::int32_t>(b)) > limit;
    } else {
        if (a == b || (std::isnan(a) && std::isnan(b))) return false;
        const auto p = static_cast<double>(a), q = static_cast<double>(b);
        if (!std::isfinite(p) || !std::isfinite(q)) return true;
        const double allowed = limits.relativeOnly
                                   ? limits.absolute + limits.relative * std::max(std::abs(p), std::abs(q))
                                   : limit;
        return std::abs(p - q) > allowed;
    }
}

/// Turns sums over a row of blocks into means and keeps the largest.
class BlockMeans {
  public:
    BlockMeans(int block, int width, int height, std::size_t components)
        : block_(block),
          columns_(std::max(width / block, 1)),
          rows_(std::max(height / block, 1)),
          width_(width),
          height_(height),
          components_(components) {}

    /// True if a row of blocks ends with this row of pixels.
    [[nodiscard]] bool endsWith(int y) const {
        return y + 1 == height_ || ((y + 1) % block_ == 0 && (y + 1) / block_ < rows_);
    }

    /// `sums` are the sums of the columns of a row of blocks that ends with row y of pixels; they are reset.
    template <class Sum>
    void add(std::vector<Sum>& sums, int y, double unit, Excess& excess) const {
        const int row = std::min(y / block_, rows_ - 1), top = row * block_;
        for (int column = 0; column < columns_; ++column) {
            const int left = column * block_, right = column + 1 == columns_ ? width_ : left + block_;
            const double count = static_cast<double>(right - left) * (y + 1 - top);
            for (std::size_t c = 0; c < components_; ++c) {
                double sum = 0;
                for (int x = left; x < right; ++x)
                    sum += static_cast<double>(sums[static_cast<std::size_t>(x) * components_ + c]);
                const double mean = std::abs(sum) / count * unit;
                if (mean <= excess.bias) continue;
                excess.bias = mean;
                excess.biasX = left;
                excess.biasY = top;
            }
        }
        std::fill(sums.begin(), sums.end(), Sum{});
    }

  private:
    int block_, columns_, rows_, width_, height_;
    std::size_t components_;
};

/// The pixels beyond the limit; needs memory only if there is one.
class BeyondMap {
  public:
    BeyondMap(int width, int height)
        : width_(static_cast<std::size_t>(width)), height_(static_cast<std::size_t>(height)) {}

    void add(std::size_t x, int y) {
        if (pixels_.empty()) {
            pixels_.resize(width_ * height_);
            firstRow_ = static_cast<std::size_t>(y);
        }
        lastRow_ = static_cast<std::size_t>(y);
        pixels_[lastRow_ * width_ + x] = true;
    }

    /// The row or column with the most pixels.
    void findLine(Excess& excess) const {
        if (pixels_.empty()) return;
        std::vector<std::uint64_t> inColumn(width_);
        for (std::size_t y = firstRow_; y <= lastRow_; ++y) {
            std::uint64_t inRow = 0;
            for (std::size_t x = 0; x < width_; ++x) {
                if (!pixels_[y * width_ + x]) continue;
                ++inRow;
                ++inColumn[x];
            }
            if (inRow <= excess.line) continue;
            excess.line = inRow;
            excess.lineY = static_cast<int>(y);
        }
        const auto most = std::max_element(inColumn.begin(), inColumn.end());
        if (*most <= excess.line) return;
        excess.line = *most;
        excess.lineX = static_cast<int>(most - inColumn.begin());
        excess.lineY = -1;
    }

    /// The largest group of touching pixels, by flood fill; empties the map.
    void findCluster(Excess& excess) {
        if (pixels_.empty()) return;
        for (std::size_t first = firstRow_ * width_; first < (lastRow_ + 1) * width_; ++first) {
            const std::uint64_t size = take(first);
            if (size <= excess.cluster) continue;
            excess.cluster = size;
            excess.clusterX = static_cast<int>(first % width_);
            excess.clusterY = static_cast<int>(first / width_);
        }
    }

  private:
    /// The size of the group that a pixel belongs to; removes the group from the map.
    std::uint64_t take(std::size_t first) {
        if (!pixels_[first]) return 0;
        std::uint64_t size = 0;
        open_.assign(1, first);
        pixels_[first] = false;
        while (!open_.empty()) {
            const std::size_t x = open_.back() % width_, y = open_.back() / width_;
            open_.pop_back();
            ++size;
            for (std::size_t row = y == 0 ? 0 : y - 1; row <= std::min(y + 1, height_ - 1); ++row)
                for (std::size_t column = x == 0 ? 0 : x - 1; column <= std::min(x + 1, width_ - 1);
                     ++column) {
                    const std::size_t near = row * width_ + column;
                    if (!pixels_[near]) continue;
                    pixels_[near] = false;
                    open_.push_back(near);
                }
        }
        return size;
    }

    std::size_t width_, height_, firstRow_ = 0, lastRow_ = 0;
    std::vector<bool> pixels_;
    std::vector<std::size_t> open_;
};

template <class Value>
Excess measure(const Image& a, const Image& b, const ExcessLimits& limits) {
    Excess excess;
    const auto components = static_cast<std::size_t>(a.components);
    const auto width = static_cast<std::size_t>(a.width);
    const Step<Value> limit = limitOf<Value>(limits);
    const double unit = 255 / kFull<Value>;
    const BlockMeans means(limits.block, a.width, a.height, components);
    std::vector<Step<Value>> sums(width * components);
    BeyondMap map(a.width, a.height);
    bool anySum = false;
    for (int y = 0; y < a.height; ++y) {
        const std::byte* rowA = a.row(y).data();
        const std::byte* rowB = b.row(y).data();
        if (std::memcmp(rowA, rowB, a.rowBytes()) != 0) {
            anySum = true;
            if (addRow<Value>(rowA, rowB, width * components, limit, sums.data()) || limits.relativeOnly)
                for (std::size_t x = 0; x < width; ++x) {
                    bool beyond = false;
                    for (std::size_t c = x * components; c < (x + 1) * components; ++c)
                        beyond |= isBeyond(valueAt<Value>(rowA, c), valueAt<Value>(rowB, c), limit, limits);
                    if (!beyond) continue;
                    ++excess.beyond;
                    if (excess.beyond <= limits.allowed) map.add(x, y);
                }
        }
        if (!anySum || limits.relativeOnly || !means.endsWith(y)) continue;
        means.add(sums, y, unit, excess);
        anySum = false;
    }
    if (excess.beyond <= limits.allowed) {
        map.findLine(excess);
        map.findCluster(excess);
    }
    return excess;
}

/// For two pictures of equal size, component count and type. NaN against a number exceeds any limit and
/// counts as `largest` in the means. With `relativeOnly` there are no means: bias is 0.
Excess measureExcess(const Image& a, const Image& b, const ExcessLimits& limits) {
    return withZeroOf(a.type, [&](auto zero) { return measure<decltype(zero)>(a, b, limits); });
}

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
        result.reason =
            fmt::format("a value is NaN or infinite, and not the same in both pictures, at {}, {}",
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
    const auto isInRange = [](float value) { return value >= 0 && value <= 1; };
    for (int y = 0; y < a.height; ++y) {
        const std::byte* rowA = a.row(y).data();
        const std::byte* rowB = b.row(y).data();
        if (std::memcmp(rowA, rowB, a.rowBytes()) == 0) continue;
        for (std::size_t i = 0; i < static_cast<std::size_t>(a.width) * components; ++i) {
            const auto p = valueAt<float>(rowA, i), q = valueAt<float>(rowB, i);
            if (!(isInRange(p) && isInRange(q)) && isBeyond(p, q, limits.largest / 255, limits))
                return OutOfRange{static_cast<int>(i / components), y};
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
    if (!areComparable(expected, got)) {
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

bool passesAll(const Image& expected, const Tolerance& tolerance) {
    if (expected.type == Component::f32 && tolerance.relative >= 1) return true;  // black passes for each
    double most = 0;
    for (std::size_t i = 0; expected.type == Component::f32 && i < expected.data.size() / sizeof(float); ++i)
        if (const auto value = valueAt<float>(expected.data.data(), i); std::isfinite(value))
            most = std::max(most, std::abs(static_cast<double>(value)));
    Image other = expected;
    const auto turn = [&]<class Value>(Value middle, Value least, Value largest) {
        for (std::size_t at = 0; at + sizeof(Value) <= other.data.size(); at += sizeof(Value)) {
            const Value turned = valueAt<Value>(other.data.data() + at, 0) < middle ? largest : least;
            std::memcpy(other.data.data() + at, &turned, sizeof turned);
        }
    };
    constexpr double kFar = 10;
    const auto far = static_cast<float>(std::min<double>(kFar * most + 1, std::numeric_limits<float>::max()));
    if (expected.type == Component::u8) turn(std::uint8_t{128}, std::uint8_t{0}, std::uint8_t{255});
    if (expected.type == Component::u16) turn(std::uint16_t{32768}, std::uint16_t{0}, std::uint16_t{65535});
    if (expected.type == Component::f32) turn(0.F, -far, far);
    return judge(expected, other, tolerance).same;
}

/// The pixels that differ by more than `largest`, or `relative` and `absolute`, of the tolerance, and the
/// bias of blocks. Clusters and lines are searched if there are at most `searched` such pixels. The pictures
/// have one size.
static Excess excessBeyond(const Image& expected, const Image& got, const Tolerance& tolerance,
                           std::uint64_t searched) {
    ExcessLimits limits = limitsFor(expected, got, tolerance);
    limits.allowed = searched;
    return withAlike(expected, got,
                     [&](const Image& a, const Image& b) { return measureExcess(a, b, limits); });
}

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
struct RaisedTolerance {
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
    [[nodiscard]] std::vector<RaisedTolerance> candidates() const {
        std::vector<RaisedTolerance> all{withLimit(stated_)};
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
    [[nodiscard]] RaisedTolerance withLimit(Tolerance tolerance) const {
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
        RaisedTolerance candidate{tolerance, 0, {}, found.beyond == 0};
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

/// As RaisedTolerance::cost. A limit of 0 counts as the least step.
double perceptualCost(const Tolerance& stated, const Tolerance& raised) {
    const auto cost = [](const std::optional<double>& was, const std::optional<double>& is) {
        constexpr double kStep = 1e-4;
        return was ? std::log(std::max(*is, kStep) / std::max(*was, kStep)) : 0;
    };
    return cost(stated.flip, raised.flip) + cost(stated.structure, raised.structure);
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
        nearest.whyNone = "a value is NaN or infinite, and not the same in both pictures";
        return nearest;
    }
    const auto passes = [&](const Tolerance& tolerance) { return judge(expected, got, tolerance).same; };
    RaisedTolerance best;
    std::optional<Tolerance> raised;
    if (stated.flip || stated.structure) raised = raisedPerceptual(stated, judged);
    if (raised && !passes(*raised)) raised.reset();
    if (raised) {
        best.tolerance = *raised;
        best.cost = perceptualCost(stated, *raised);
    }
    for (RaisedTolerance& each : Search(expected, got, stated).candidates()) {
        if (each.tooMuch.empty() && each.cost < best.cost)
            best = std::move(each);
        else if (!each.tooMuch.empty())
            nearest.whyNone = std::move(each.tooMuch);  // that of the widest limit stays
    }
    if (!std::isfinite(best.cost)) return nearest;
    nearest.whyNone.clear();
    nearest.tolerance = passes(best.tolerance) ? best.tolerance : raised;
    return nearest;
}

}  // namespace glibra::image
