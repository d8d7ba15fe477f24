#pragma once
// Where two pictures differ by more than the limit, and the mean difference of blocks.

#include <cstdint>

#include "image/image.h"

namespace glibra::image {

struct ExcessLimits {
    double largest = 0;         ///< 255ths of the range
    bool relativeOnly = false;  ///< float pictures: a value may differ by absolute + relative max(|a|, |b|)
    double relative = 0, absolute = 0;
    std::uint64_t allowed = 0;  ///< pixels that may differ by more; if more do, clusters are not searched
    int block = 16;             ///< side of the blocks in pixels, at most 64
};

struct Excess {
    std::uint64_t beyond = 0;        ///< pixels with a component that differs by more than the limit
    std::uint64_t cluster = 0;       ///< size of the largest group of such pixels that touch, also at corners
    int clusterX = 0, clusterY = 0;  ///< its first pixel
    std::uint64_t line = 0;          ///< most of such pixels in one row or column
    int lineX = -1, lineY = -1;      ///< that column, or that row; the other is -1
    double bias =
        0;  ///< largest mean of the signed differences of a block, each limited to +-largest; 255ths
    int biasX = 0, biasY = 0;  ///< top left pixel of that block
};

/// For two pictures of equal size, component count and type. NaN against a number exceeds any limit and
/// counts as `largest` in the means. With `relativeOnly` there are no means: bias is 0.
Excess measureExcess(const Image& a, const Image& b, const ExcessLimits& limits);

}  // namespace glibra::image
