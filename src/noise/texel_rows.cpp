#include "noise/texel_rows.h"

#include <algorithm>
#include <bit>

#include "system/processors.h"

namespace glibra::noise {
namespace {

constexpr float kOneHalf = static_cast<float>(kUnitsPerValue / 2);

constexpr int byteShift(int octave) {
    return std::endian::native == std::endian::little ? 8 * octave : 24 - 8 * octave;
}

/// Masks the distance of a unit count to the next byte: 0 if a byte boundary is less than a unit away.
inline std::uint32_t distance(std::uint32_t units) {
    constexpr std::uint32_t kFraction = (1U << kFractionBits) - 1;
    return (units + 1) & (kFraction - 1);
}

}  // namespace

GLIBRA_FOR_EACH_PROCESSOR("default", "avx2", "avx512f")
bool combineOctaves(const std::array<OctaveRow, 4>& octaves, std::size_t begin, std::size_t count,
                    TexelBlock& block) {
    const auto unitsAt = [begin](const OctaveRow& row, const RowWeights& w, std::size_t i) {
        const float value = ((row.levels[0] + begin)[i] * w.n0 + (row.levels[1] + begin)[i] * w.n1) +
                            ((row.slopes[0] + begin)[i] * w.g0 + (row.slopes[1] + begin)[i] * w.g1);
        return static_cast<std::uint32_t>(static_cast<std::int32_t>(kOneHalf + value));
    };
    const auto byteAt = [](std::uint32_t units, int octave) {
        return units >> kFractionBits << byteShift(octave);
    };
    const OctaveRow r0 = octaves[0], r1 = octaves[1], r2 = octaves[2], r3 = octaves[3];
    std::uint32_t least = ~0U;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t u0 = unitsAt(r0, r0.weights, i), u1 = unitsAt(r1, r1.weights, i),
                            u2 = unitsAt(r2, r2.weights, i), u3 = unitsAt(r3, r3.weights, i);
        block.texels[i] = byteAt(u0, 0) | byteAt(u1, 1) | byteAt(u2, 2) | byteAt(u3, 3);
        const std::uint32_t nearest =
            std::min(std::min(distance(u0), distance(u1)), std::min(distance(u2), distance(u3)));
        block.doubts[i] = nearest;
        least = std::min(least, nearest);
    }
    return least == 0;
}

GLIBRA_FOR_EACH_PROCESSOR("default", "avx2", "avx512f")
void mergeRows(const OctaveRow& row, std::size_t count, float* sum) {
    const auto [n0, n1, g0, g1] = row.weights;
    const float *near = row.levels[0], *far = row.levels[1], *nearSlope = row.slopes[0],
                *farSlope = row.slopes[1];
    for (std::size_t i = 0; i < count; ++i)
        sum[i] = (near[i] * n0 + far[i] * n1) + (nearSlope[i] * g0 + farSlope[i] * g1);
}

GLIBRA_FOR_EACH_PROCESSOR("default", "avx2", "avx512f")
void mergeLevels(const OctaveRow& row, std::size_t count, float* sum) {
    const float n0 = row.weights.n0, n1 = row.weights.n1;
    const float *near = row.levels[0], *far = row.levels[1];
    for (std::size_t i = 0; i < count; ++i) sum[i] = near[i] * n0 + far[i] * n1;
}

}  // namespace glibra::noise
