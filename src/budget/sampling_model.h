#pragma once
// The errors that a number of samples per pixel and the texels of a noise texture cause.

#include <array>
#include <functional>
#include <span>

#include "scene/scene.h"

namespace glibra::budget {

/// Returns how many pixels an edge may lie away from where the samples show it, for a regular pattern of that
/// many samples: half the distance of its rows, 1 / (2 sqrt n).
double edgeError(int samples);

/// Returns the smallest power of two whose edgeError is at most maxError (pixels), but no more than `most`.
int leastSamples(double maxError, int most);

/// The sizes among which noise textures are chosen: whole numbers of texels per cell of the finest octave.
std::span<const int> noiseSizes(int dimensions);

/// The size and the texels of a noise texture.
struct NoiseFormat {
    int size = 64;
    scene::NoiseTexels texels = scene::NoiseTexels::bytes;
    friend bool operator==(const NoiseFormat&, const NoiseFormat&) = default;
};

/// Returns the distance, in periods of the texture, that 999 of 1000 contours of the four octaves' sum do not
/// exceed with linear filtering: the error of the value divided by the root mean square of the gradient, 2.57
/// and 2.17 per period. The first part is the interpolation between texels, which falls with size^2 once the
/// finest octave (32 cells per period) is resolved; the second is the rounding of the texels. dimensions is 2
/// or 3, the size at least 32. Floats would round less than 16 bits do, but at all these sizes the rounding
/// of 16 bits is 70 times smaller than the interpolation error.
double noiseError(int dimensions, NoiseFormat format);

/// Two sizes that are quickly made; the difference between their pictures shows how a program uses noise.
inline constexpr std::array kNoiseProbeSizes{48, 64};

/// Returns how many periods contours move on average from a texture of the first of kNoiseProbeSizes to one
/// of the second, both with 16 bits: the mean change of the value divided by the mean gradient, measured.
double meanNoiseStep(int dimensions);

/// Returns the smallest of noiseSizes, with bytes or else with 16 bits, for which errorOf is at most
/// maxError; if there is none, the largest size with 16 bits. 16 bits cost little compared with the next
/// size, which may have up to eight times as many texels.
NoiseFormat leastNoise(int dimensions, double maxError, const std::function<double(NoiseFormat)>& errorOf);

}  // namespace glibra::budget
