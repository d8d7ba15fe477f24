#pragma once
// Whether two pictures are the same as far as anybody cares: a ladder of measures that stops as soon as it
// knows. Bytes, then plain differences, then their means over blocks, then the perceptual measures.

#include <cstdint>
#include <optional>
#include <string>

#include "image/compare.h"
#include "image/image.h"

namespace glibra::image {

/// What may differ. The defaults pass what drivers and processors differ in and nothing that a person sees.
struct Tolerance {
    double largest = 3;  ///< 255ths of the range that any component may differ by; float pictures: see below
    double fraction = 0.0002;  ///< of the pixels may differ by more (an edge that falls to the other side)
    double bias = 0.5;  ///< 255ths that the mean of the signed differences over any block of pixels may be
    std::optional<double> flip;       ///< mean FLIP (0..1) that passes instead of `largest` and `fraction`
    std::optional<double> structure;  ///< structural difference (0..1) that passes instead of them
    double relative = 1e-4;           ///< float pictures: |a - b| <= absolute + relative max(|a|, |b|)
    double absolute = 1e-6;
};

/// The rung of the ladder that decided.
enum class Rung { size, bytes, differences, bias, structure, flip };

struct Judgement {
    bool same = false;
    Rung decidedBy = Rung::bytes;
    std::string reason;                     ///< one sentence with the figure that decided and its limit
    Comparison comparison;                  ///< filled unless the sizes or the bytes decided
    std::uint64_t beyond = 0;               ///< pixels that differ by more than `largest`
    double bias = 0;                        ///< largest mean of a block, 255ths
    std::optional<double> flip, structure;  ///< where they were needed or asked for
};

/// `everything` computes all figures even when an early one decides (for reports of failures).
Judgement judge(const Image& expected, const Image& got, const Tolerance& tolerance, bool everything = false);

}  // namespace glibra::image
