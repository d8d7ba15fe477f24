#pragma once
// Pictures as numbers: what each pixel shall be, and how far a picture is from that.

#include <algorithm>
#include <cmath>
#include <vector>

namespace glibra::bench {

inline constexpr double kByte = 255;  ///< errors of pictures are in steps of a byte

/// value(x, y) at the centre of each pixel, rows from the top. Places run from (0, 0) at the lower left
/// corner of the picture to (1, 1) at the upper right one.
template <class Value>
auto overPixels(int width, int height, const Value& value) {
    std::vector<decltype(value(0., 0.))> values;
    values.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            values.push_back(value((column + .5) / width, 1 - (row + .5) / height));
    return values;
}

/// The root of the mean square of the differences. Where either is NaN, nothing is compared.
template <class A, class B>
double rootMeanSquare(const A& values, const B& wanted) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double difference = static_cast<double>(values[i]) - static_cast<double>(wanted[i]);
        if (std::isnan(difference)) continue;
        sum += difference * difference;
        ++count;
    }
    return count > 0 ? std::sqrt(sum / count) : 0;
}

template <class A, class B>
double largestDifference(const A& values, const B& wanted) {
    double largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        largest =
            std::max(largest, std::abs(static_cast<double>(values[i]) - static_cast<double>(wanted[i])));
    return largest;
}

}  // namespace glibra::bench
