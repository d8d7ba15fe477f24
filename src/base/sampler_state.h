#pragma once
// How a texture is read, as values without GL. `scene` fills them, `gpu` makes samplers of them.

#include <array>
#include <cstdint>

#include "base/comparison.h"

namespace glibra::base {

/// The first word is the filter within a level, the second one that between levels.
enum class Filter : std::uint8_t {
    nearest,
    linear,
    nearestMipmapNearest,
    linearMipmapNearest,
    nearestMipmapLinear,
    linearMipmapLinear,
};

/// What is read outside of 0..1.
enum class Wrap : std::uint8_t { repeat, clampToEdge, mirroredRepeat, clampToBorder };

constexpr bool repeats(Wrap wrap) {
    return wrap == Wrap::repeat || wrap == Wrap::mirroredRepeat;
}

/// The depth that counts as farthest where depths are compared that way: comparisons with it hold.
constexpr double farthestDepth(Comparison comparison) {
    return comparison == Comparison::greater || comparison == Comparison::gequal ? 0 : 1;
}

struct SamplerState {
    Filter filter = Filter::linear;  ///< for enlarging, the filter within a level
    std::array<Wrap, 3> wrap{};      ///< along s, t and p
    double anisotropy = 1;           ///< 1: off; the driver's limit holds
    std::array<double, 4> border{};  ///< what clampToBorder reads
    /// Of depth, for samplers that compare: 1 where (reference compared with texel) holds.
    Comparison compare = Comparison::lequal;

    [[nodiscard]] bool readsMipmaps() const { return filter >= Filter::nearestMipmapNearest; }
    friend bool operator==(const SamplerState&, const SamplerState&) = default;
};

}  // namespace glibra::base
