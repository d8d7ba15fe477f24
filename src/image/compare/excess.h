#pragma once
// Where two pictures differ by more than they may, and by how much they differ on the average of a block.

#include <cstdint>

#include "image/image.h"

namespace glibra::image {

struct ExcessLimits {
    double largest = 0;         ///< 255ths of the range
    bool relativeOnly = false;  ///< float pictures: a value may differ by absolute + relative max(|a|, |b|)
    double relative = 0, absolute = 0;
    std::uint64_t allowed = 0;  ///< pixels that may differ by more; beyond it clusters are not looked for
    int block = 16;             ///< side of the blocks in pixels, at most 64
};

struct Excess {
    std::uint64_t beyond = 0;   ///< pixels of which a component differs by more than the limit
    std::uint64_t cluster = 0;  ///< size of the largest group of them that touch, also at corners
    int clusterX = 0, clusterY = 0;
    std::uint64_t line = 0;      ///< most of them in one row or column
    int lineX = -1, lineY = -1;  ///< that column, or that row; the other is -1
    double bias = 0;  ///< largest mean of a block's signed differences, each limited to +-largest; 255ths
    int biasX = 0, biasY = 0;
};

/// Of two pictures of one size, component count and type. NaN against a number is beyond any limit and counts
/// as `largest` in the means. With `relativeOnly` there are no means: bias is 0.
Excess measureExcess(const Image& a, const Image& b, const ExcessLimits& limits);

}  // namespace glibra::image
