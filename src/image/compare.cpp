#include "image/compare.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "image/convert.h"

namespace glibra::image {
namespace {

/// Steps between two values: integers for integer types, so that sums of squares are exact.
template <class Value>
auto distance(Value a, Value b) {
    if constexpr (std::is_integral_v<Value>) {
        return static_cast<std::uint64_t>(a > b ? a - b : b - a);
    } else {
        if (a == b || (std::isnan(a) && std::isnan(b))) return 0.;
        if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<double>::infinity();
        return std::abs(static_cast<double>(a) - static_cast<double>(b));
    }
}

template <class Value>
void compareRows(const Image& a, const Image& b, Comparison& result) {
    using Distance = decltype(distance(Value{}, Value{}));
    const auto components = static_cast<std::size_t>(a.components);
    const std::size_t pixelBytes = components * sizeof(Value);
    Distance largest = 0, squares = 0;
    for (int y = 0; y < a.height; ++y) {
        const std::byte* rowA = a.row(y).data();
        const std::byte* rowB = b.row(y).data();
        if (std::memcmp(rowA, rowB, a.rowBytes()) == 0) continue;
        for (int x = 0; x < a.width; ++x, rowA += pixelBytes, rowB += pixelBytes) {
            bool differs = false;
            for (std::size_t c = 0; c < components; ++c) {
                Value valueA, valueB;
                std::memcpy(&valueA, rowA + c * sizeof(Value), sizeof(Value));
                std::memcpy(&valueB, rowB + c * sizeof(Value), sizeof(Value));
                const Distance d = distance(valueA, valueB);
                if (d == 0) continue;
                differs = true;
                squares += d * d;
                if (d <= largest) continue;
                largest = d;
                result.x = x;
                result.y = y;
                result.component = static_cast<int>(c);
            }
            result.differingPixels += differs ? 1U : 0U;
        }
    }
    const double full =
        std::is_integral_v<Value> ? static_cast<double>(std::numeric_limits<Value>::max()) : 1;
    const double count = static_cast<double>(a.data.size()) / sizeof(Value);
    result.largest = static_cast<double>(largest) / full;
    result.rootMeanSquare = std::sqrt(static_cast<double>(squares) / count) / full;
    result.identical = result.differingPixels == 0;
}

}  // namespace

Comparison compare(const Image& a, const Image& b) {
    Comparison result;
    if (a.width != b.width || a.height != b.height || !isConsistent(a) || !isConsistent(b)) {
        result.sameSize = a.width == b.width && a.height == b.height;
        result.identical = result.sameSize && a.data == b.data;
        return result;
    }
    if (a.components != b.components) return compare(withComponents(a, 4), withComponents(b, 4));
    if (a.type != b.type) {
        const Component wider = std::max(a.type, b.type);
        return compare(withType(a, wider), withType(b, wider));
    }
    if (a.data == b.data) return result;
    switch (a.type) {
        case Component::u8:
            compareRows<std::uint8_t>(a, b, result);
            break;
        case Component::u16:
            compareRows<std::uint16_t>(a, b, result);
            break;
        case Component::f32:
            compareRows<float>(a, b, result);
            break;
    }
    return result;
}

}  // namespace glibra::image
