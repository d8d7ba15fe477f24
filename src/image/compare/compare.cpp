#include "image/compare/compare.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "image/bytes.h"
#include "image/compare/alike.h"
#include "image/convert.h"

namespace glibra::image {
namespace {

/// The number of values of a row that can be summed before the sum of their squares could overflow.
constexpr std::size_t kSumChunk = 4096;

/// Steps between two values; integers for integer types, so that sums of squares are exact.
template <class Value>
auto distance(Value a, Value b) {
    if constexpr (std::is_same_v<Value, std::uint8_t>) {
        return static_cast<std::uint32_t>(a > b ? a - b : b - a);
    } else if constexpr (std::is_integral_v<Value>) {
        return static_cast<std::uint64_t>(a > b ? a - b : b - a);
    } else {
        return apart(a, b);
    }
}

/// Largest distance and sum of squares of `count` values; the compiler vectorises the loops.
template <class Value, class Distance>
void addDistances(const std::byte* a, const std::byte* b, std::size_t count, Distance& largest,
                  Distance& squares) {
    for (std::size_t i = 0; i < count; ++i) {
        const Distance d = distance(valueAt<Value>(a, i), valueAt<Value>(b, i));
        largest = d > largest ? d : largest;
        squares += d * d;
    }
}

std::uint64_t countDiffering4(const std::byte* a, const std::byte* b, std::size_t pixels) {
    std::uint32_t count = 0;  // a row has fewer pixels
    for (std::size_t i = 0; i < pixels; ++i)
        count += valueAt<std::uint32_t>(a, i) != valueAt<std::uint32_t>(b, i) ? 1U : 0U;
    return count;
}

template <class Value>
std::uint64_t countDiffering(const std::byte* a, const std::byte* b, std::size_t pixels,
                             std::size_t components) {
    if constexpr (sizeof(Value) == 1)
        if (components == 4) return countDiffering4(a, b, pixels);
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        bool differs = false;
        for (std::size_t c = 0; c < components; ++c)
            differs |=
                distance(valueAt<Value>(a, i * components + c), valueAt<Value>(b, i * components + c)) != 0;
        count += differs ? 1U : 0U;
    }
    return count;
}

template <class Value>
Comparison compareAlike(const Image& a, const Image& b) {
    using Distance = decltype(distance(Value{}, Value{}));
    using Sum = std::conditional_t<std::is_integral_v<Value>, std::uint64_t, double>;
    Comparison result;
    const auto components = static_cast<std::size_t>(a.components);
    const std::size_t rowValues = a.rowBytes() / sizeof(Value);
    Distance largest = 0;
    Sum squares = 0;
    for (int y = 0; y < a.height; ++y) {
        const std::byte* rowA = a.row(y).data();
        const std::byte* rowB = b.row(y).data();
        if (std::memcmp(rowA, rowB, a.rowBytes()) == 0) continue;
        Distance ofRow = 0;
        for (std::size_t at = 0; at < rowValues; at += kSumChunk) {
            Distance ofChunk = 0;
            addDistances<Value>(rowA + at * sizeof(Value), rowB + at * sizeof(Value),
                                std::min(kSumChunk, rowValues - at), ofRow, ofChunk);
            squares += ofChunk;
        }
        if (ofRow == 0) continue;
        result.differingPixels +=
            countDiffering<Value>(rowA, rowB, static_cast<std::size_t>(a.width), components);
        if (ofRow <= largest) continue;
        largest = ofRow;
        std::size_t place = 0;
        while (distance(valueAt<Value>(rowA, place), valueAt<Value>(rowB, place)) != largest) ++place;
        result.x = static_cast<int>(place / components);
        result.y = y;
        result.component = static_cast<int>(place % components);
    }
    const double full =
        std::is_integral_v<Value> ? static_cast<double>(std::numeric_limits<Value>::max()) : 1;
    const double count = static_cast<double>(a.data.size()) / sizeof(Value);
    result.largest = static_cast<double>(largest) / full;
    result.rootMeanSquare = std::sqrt(static_cast<double>(squares) / count) / full;
    result.identical = result.differingPixels == 0;
    return result;
}

std::uint64_t countNonFiniteOfBoth(const Image& a, const Image& b) {
    if (a.type != Component::f32) return 0;
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < a.data.size() / sizeof(float); ++i)
        if (!std::isfinite(valueAt<float>(a.data.data(), i)) ||
            !std::isfinite(valueAt<float>(b.data.data(), i)))
            ++count;
    return count;
}

}  // namespace

Comparison compare(const Image& first, const Image& second) {
    Comparison result;
    if (!areComparable(first, second)) {
        result.sameSize = first.width == second.width && first.height == second.height;
        result.identical = result.sameSize && first.data == second.data;
        return result;
    }
    return withAlike(first, second, [](const Image& a, const Image& b) {
        Comparison found = withZeroOf(a.type, [&](auto zero) { return compareAlike<decltype(zero)>(a, b); });
        found.nonFinite = countNonFiniteOfBoth(a, b);
        return found;
    });
}

}  // namespace glibra::image
