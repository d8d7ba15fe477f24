#pragma once
// The inner loops of the noise textures, in floats, for many texels at once. The result is within half a unit
// of 1/4096 byte of the exact value. A texel that this error could change is marked, and the
// caller computes its bytes exactly.

#include <array>
#include <cstddef>
#include <cstdint>

namespace glibra::noise {

/// Values are counted in units: one byte is 2^12 units.
inline constexpr int kFractionBits = 12;
inline constexpr double kUnitsPerValue = 255. * (1 << kFractionBits);

/// Four weights as floats, for the values and slopes at the near and the far end of a cell.
struct RowWeights {
    float n0 = 0, n1 = 0, g0 = 0, g1 = 0;
};

/// One octave of a row of texels: n0 * levels[0][i] + n1 * levels[1][i] + g0 * slopes[0][i] + g1 *
/// slopes[1][i].
struct OctaveRow {
    std::array<const float*, 2> levels{};
    std::array<const float*, 2> slopes{};
    RowWeights weights;
};

/// The number of texels that are computed together.
inline constexpr std::size_t kBlock = 64;

struct TexelBlock {
    std::array<std::uint32_t, kBlock> texels;  ///< red, green, blue, alpha in memory order
    std::array<std::uint32_t, kBlock> doubts;  ///< 0: a byte of the texel must be computed exactly
};

/// Computes texels begin .. begin + count - 1 of a row from its four octaves; `count` is in 1..kBlock. True
/// if one or more are in doubt.
bool combineOctaves(const std::array<OctaveRow, 4>& octaves, std::size_t begin, std::size_t count,
                    TexelBlock& block);

/// sum[i] = n0 * levels[0][i] + n1 * levels[1][i] + g0 * slopes[0][i] + g1 * slopes[1][i], for i below
/// `count`.
void mergeRows(const OctaveRow& row, std::size_t count, float* sum);

/// sum[i] = n0 * levels[0][i] + n1 * levels[1][i].
void mergeLevels(const OctaveRow& row, std::size_t count, float* sum);

}  // namespace glibra::noise
