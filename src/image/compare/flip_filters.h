#pragma once
// The filters of FLIP as one-dimensional weights, and their application to tiles.

#include <cstddef>
#include <span>
#include <vector>

namespace glibra::image {

/// Weights 0..radius of a filter that is symmetric (w[-k] = w[k]) or antisymmetric (w[-k] = -w[k]).
using HalfFilter = std::vector<float>;

/// All filters for one viewing distance. Two-dimensional filters are products of these (the blue-yellow
/// filter is the sum of two such products).
struct FlipFilters {
    explicit FlipFilters(double pixelsPerDegree);

    HalfFilter achromatic, redGreen, blueYellow1, blueYellow2;  ///< contrast sensitivity, symmetric
    HalfFilter gauss, edge, point;  ///< feature detection; edge (first derivative) is antisymmetric
    std::size_t radius = 0;         ///< radius of the widest filter
};

/// The filters of one pass over its input: symmetric ones, then at most one antisymmetric one. All have equal
/// length.
struct FilterOutput {
    std::span<const float> weights;
    float* to;
};

/// out[x] = sum over k of weights[|k|] in[x + k step], for x in 0..count-1 (a multiple of 8). `step` is 1
/// along a row, and the length of a row down a column.
void filterSymmetric(const float* in, std::ptrdiff_t step, std::size_t count, FilterOutput out);
void filterSymmetric(const float* in, std::ptrdiff_t step, std::size_t count, FilterOutput first,
                     FilterOutput second);
/// The last weight sign(k) weights[|k|].
void filterBoth(const float* in, std::ptrdiff_t step, std::size_t count, FilterOutput symmetric,
                FilterOutput antisymmetric);
void filterBoth(const float* in, std::ptrdiff_t step, std::size_t count, FilterOutput first,
                FilterOutput second, FilterOutput third, FilterOutput antisymmetric);

}  // namespace glibra::image
