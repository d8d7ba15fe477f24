#pragma once
// What a tolerance would have to be so that a picture that failed passes, for whoever decides whether it may.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "image/compare/judge.h"
#include "image/image.h"

namespace glibra::image {

/// Limits by whose count of pixels one sees how large differences are: 255ths, or `relative` of float
/// pictures.
struct DifferenceSteps {
    std::vector<double> limits;
    std::vector<std::uint64_t> pixels;  ///< that differ by more; never more than those of the limit before
};
/// For two pictures of one size; empty for others.
DifferenceSteps differenceSteps(const Image& expected, const Image& got);

struct NearestTolerance {
    /// It passes the pictures, and with any one of its raised limits a step lower it does not: one pixel, one
    /// 255th of `largest`, the last digit of the others.
    std::optional<Tolerance> tolerance;
    /// Why there is none that would still see a fault of the scene, as "31 % of the pixels differ by more
    /// than 16 of 255".
    std::string whyNone;
};

/// The tolerance that passes a picture which `judged` failed by `stated`. Of those that do, it is the one
/// whose limits are the least multiples of the stated ones. None allows more than 16 of 255 (0.02 of float
/// values), more than 1 % of the pixels, groups of 64, lines of 128 and a bias of 3, unless it is stated.
/// Where `stated` has perceptual limits, they are raised, to at most 0.05.
NearestTolerance nearestTolerance(const Image& expected, const Image& got, const Tolerance& stated,
                                  const Judgement& judged);

}  // namespace glibra::image
