#pragma once
// Decides whether two pictures are the same within a tolerance, by measures of growing cost: bytes, then
// plain differences, then their means over blocks, then the perceptual measures. It stops at the first
// measure that decides.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "image/compare/compare.h"
#include "image/image.h"

namespace glibra::image {

/// Where two pictures differ by more than the limit, and the mean difference of blocks.
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

/// The differences that pass. The defaults pass the differences between drivers and between processors, which
/// nobody sees: measured on 112 pictures of 66 scenes, Mesa 22.3 against itself without AVX and without SSE
/// 4.1, with vectors of 128 bits, through OSMesa, and against Mesa 25.0 and 26.1. Pictures that are not equal
/// differ by at most 3 nearly everywhere; by more in at most 0.015 % of the pixels, in groups and lines of at
/// most 6; no block is lighter or darker by more than 0.11. Only a fractal and a picture of thresholds need
/// more, because rounding grows without bound there.
struct Tolerance {
    double largest = 3;  ///< 255ths of the range by which any component may differ; float pictures: see below
    double fraction = 0.0003;  ///< share of the pixels that may differ by more (edges)
    int cluster = 8;  ///< pixels that differ by more and touch, also at corners; a larger group is a shape
    int line = 16;    ///< pixels that differ by more in one row or column; more is a row that has moved
    double bias = 1;  ///< 255ths that the mean of the signed differences over any block of pixels may be:
                      ///< a value just between two steps may fall to either. Float pictures have no such test
    /// Mean FLIP (0..1) that passes where the five above fail. It sees 0..1 only: it does not decide if
    /// values outside of that range differ by more than the plain limit.
    std::optional<double> flip{};
    std::optional<double>
        structure{};         ///< structural difference (0..1) likewise; both must pass if both are set
    double relative = 1e-4;  ///< two float pictures, in place of `largest`: |a - b| <= absolute + relative
    double absolute = 1e-6;  ///< max(|a|, |b|), infinities equal themselves, NaN equals NaN
};

/// Passes equal values only.
Tolerance exactTolerance();

/// Side of the blocks of `bias` in pixels. Blocks at the right and lower edge include the remainder, up to
/// 31.
inline constexpr int kBiasBlock = 16;

/// The measure that decided. After a failure, the one that failed (the last one if several could have made it
/// pass). After a success, the one that let it pass, which is never `bias`.
enum class Rung { size, bytes, differences, bias, structure, flip };

/// "size", "bytes", ...
const char* name(Rung rung);

/// Places are relative to the top left. Of what exceeds the limit, clusters and lines are counted only if it
/// is not too much; the bias is that of Tolerance::bias.
struct Judgement : Excess {
    bool same = false;
    Rung decidedBy = Rung::bytes;
    std::string reason;                     ///< one sentence with the deciding figure and its limit
    Comparison comparison;                  ///< empty if the sizes or the bytes decided
    std::optional<double> flip, structure;  ///< if needed or requested
};

/// Whether Tolerance::largest, up to which differences count, has taken part in the bias of a block: not at
/// all, with some pixels, or with nearly all, so that the bias is at that limit and says "at least".
enum class Limited { no, partly, wholly };
Limited limitedBias(const Judgement& judged, const Tolerance& tolerance);
/// The bias in words: "0.8 of 255", "0.8 of 255 (differences above 3 count as 3)", "at least 3 of 255".
std::string biasText(const Judgement& judged, const Tolerance& tolerance);

/// Compares a picture with the expected one. Equal bytes are the same even if they are NaN; the reason then
/// mentions it. A value that is finite in one picture and not in the other, or another infinity, never
/// passes, whatever the tolerance. Alpha counts like any component. `bias` limits differences to +-`largest`,
/// so that single pixels beyond, which `fraction` allows, do not decide it. `everything` computes all figures
/// even if an early one decides (for reports of failures).
Judgement judge(const Image& expected, const Image& got, const Tolerance& tolerance, bool everything = false);

/// True if a picture that differs from the expected one as far as can be, in every value, is within the
/// tolerance: then it compares nothing.
bool passesAll(const Image& expected, const Tolerance& tolerance);

// What a tolerance would have to be so that a picture that failed passes, for whoever decides whether it may.

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
