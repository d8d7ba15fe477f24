#pragma once
// glman's noise (language, 9): a periodic gradient noise in four octaves, and the texels of the textures
// Noise2 and Noise3, which sample it.
//
// Octaves 0..3 have 4, 8, 16 and 32 cells per period and are the components r, g, b and a of the texture. A
// value is 1/2 plus the noise. It is exactly 1/2 at lattice points and stays well inside 0..1 (table 9.1).

#include <cstdint>
#include <span>

#include "noise/weights.h"

namespace glibra::noise {

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

}  // namespace glibra::noise
