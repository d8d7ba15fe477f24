#pragma once
// glman's noise and the texels of its textures, and the pieces that they are made of.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <utility>
#include <vector>

namespace glibra::noise {

// Memory for texels without initial values. Setting megabytes to zero takes longer than computing the texels
// that overwrite them.

template <class T>
struct Unset : std::allocator<T> {
    template <class Other>
    struct rebind {  // NOLINT(readability-identifier-naming): the standard's name
        using other = Unset<Other>;
    };
    template <class Other>
    void construct(Other* at) noexcept {
        ::new (static_cast<void*>(at)) Other;
    }
    template <class Other, class... From>
    void construct(Other* at, From&&... from) {
        ::new (static_cast<void*>(at)) Other(std::forward<From>(from)...);
    }
};

/// A vector whose constructor and resize leave new bytes unset.
using TexelBytes = std::vector<std::uint8_t, Unset<std::uint8_t>>;
using TexelShorts = std::vector<std::uint16_t, Unset<std::uint16_t>>;

// glman's noise (language, 9): a periodic gradient noise in four octaves, and the texels of the textures
// Noise2 and Noise3, which sample it.
//
// Octaves 0..3 have 4, 8, 16 and 32 cells per period and are the components r, g, b and a of the texture. A
// value is 1/2 plus the noise. It is exactly 1/2 at lattice points and stays well inside 0..1 (table 9.1).

inline constexpr int kOctaves = 4;
inline constexpr int kLargestSize2 = 4096;
inline constexpr int kLargestSize3 = 400;

/// Cells per period of an octave: 4, 8, 16, 32. `octave` is 0..3.
constexpr int cellsOf(int octave) {
    return 4 << octave;
}

/// The noise function at lattice coordinates (a cell has length 1), with period cellsOf(octave) along every
/// axis. `octave` is 0..3. Coordinates that are not finite give 1/2.
double noise3(double x, double y, double z, int octave);
double noise2(double x, double y, int octave);

/// Writes the texels of the 3D texture of size n: n*n*n RGBA bytes, x fastest, then y, then z. Texel (i, j,
/// k) is the function at (i, j, k) * cells / n, as floor(255 * value). Writes nothing and returns false
/// unless n is in 1..kLargestSize3 and `texels` has exactly this size. `threads` is the number of threads to
/// use (0: one per processor); the bytes do not depend on it.
bool writeNoise3(int n, std::span<std::uint8_t> texels, int threads = 0);

/// The same for the 2D texture: n*n RGBA bytes, x fastest, n in 1..kLargestSize2.
bool writeNoise2(int n, std::span<std::uint8_t> texels, int threads = 0);

/// Returns the same texels; empty if n is out of range.
TexelBytes noise3Texels(int n, int threads = 0);
TexelBytes noise2Texels(int n, int threads = 0);

/// Returns the same texels in 16 bits: (value - 1/510) * 65535, rounded to the nearest integer, or to its
/// neighbour if both are about equally near. Truncation to bytes takes away 1/510 on average; subtracting it
/// here keeps contours in pictures at the same places with both formats.
TexelShorts noise3Shorts(int n, int threads = 0);
TexelShorts noise2Shorts(int n, int threads = 0);

// The inner loops of the noise textures, in floats, for many texels at once. The result is within half a unit
// of 1/4096 byte of the exact value. A texel that this error could change is marked, and the
// caller computes its bytes exactly.

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

}  // namespace glibra::noise
