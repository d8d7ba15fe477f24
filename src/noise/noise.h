#pragma once
// glman's noise (language reference, section 9): a periodic gradient noise in four octaves and the texels of
// the textures Noise2 and Noise3 that sample it.
//
// Octave c = 0..3 has 4, 8, 16, 32 cells a period and is component r, g, b, a of the texture. A value is 1/2
// plus the noise, exactly 1/2 at lattice points, and stays well inside 0..1 (table 9.1).

#include <cstdint>
#include <span>

#include "noise/texel_bytes.h"

namespace glibra::noise {

inline constexpr int kOctaves = 4;
inline constexpr int kLargestSize2 = 4096;
inline constexpr int kLargestSize3 = 400;

/// Cells a period of an octave: 4, 8, 16, 32. `octave` is 0..3.
constexpr int cellsOf(int octave) {
    return 4 << octave;
}

/// The function at lattice coordinates (one cell is 1 long), periodic with cellsOf(octave) along every axis.
/// `octave` is 0..3; coordinates that are not finite give 1/2.
double noise3(double x, double y, double z, int octave);
double noise2(double x, double y, int octave);

/// Writes the texels of the 3D texture of size n: n*n*n RGBA bytes, x fastest, then y, then z. Texel (i, j,
/// k) is the function at (i, j, k) * cells / n, as floor(255 * value). False, and nothing is written, unless
/// n is 1..kLargestSize3 and `texels` has exactly these bytes. `threads` is the number of threads to use (0:
/// as many as the machine has); the bytes do not depend on it.
bool writeNoise3(int n, std::span<std::uint8_t> texels, int threads = 0);

/// The same for the 2D texture: n*n RGBA bytes, x fastest, n 1..kLargestSize2.
bool writeNoise2(int n, std::span<std::uint8_t> texels, int threads = 0);

/// The same into memory of their own; empty where n is impossible.
TexelBytes noise3Texels(int n, int threads = 0);
TexelBytes noise2Texels(int n, int threads = 0);

/// The same texels in 16 bits: (value - 1/510) * 65535 to the nearest, or the neighbour of it where both are
/// about as near. 1/510 is what cutting to bytes takes away on the average, so that pictures keep the places
/// of their contours with either.
TexelShorts noise3Shorts(int n, int threads = 0);
TexelShorts noise2Shorts(int n, int threads = 0);

}  // namespace glibra::noise
