#pragma once
// How far samples a pixel and texels of a noise texture move what they show.

#include <array>
#include <functional>
#include <span>

#include "scene/scene.h"

namespace glibra::budget {

/// Pixels by which an edge may lie beside the place that the samples of its pixels tell, for a regular
/// pattern of that many samples: half the distance of its rows, 1 / (2 sqrt n).
double edgeError(int samples);

/// The smallest power of two whose edgeError is no larger than maxError (pixels), but no more than `most`.
int leastSamples(double maxError, int most);

/// Sizes among which noise textures are chosen: whole numbers of texels a cell of the finest octave.
std::span<const int> noiseSizes(int dimensions);

/// Size and texels of a noise texture.
struct NoiseFormat {
    int size = 64;
    scene::NoiseTexels texels = scene::NoiseTexels::bytes;
    friend bool operator==(const NoiseFormat&, const NoiseFormat&) = default;
};

/// Distance in periods of the texture by which 999 of 1000 contours of the four octaves' sum are at most
/// beside their place in such a texture, filtered linearly: the error of the value divided by the root mean
/// square of the gradient, 2.57 and 2.17 a period. The first part is interpolation between texels, which
/// falls with size^2 once the finest octave (32 cells a period) is resolved; the second is the texels'
/// rounding. dimensions is 2 or 3, the size at least 32. Floats would round less than 16 bits, but with any
/// size here that is 70 times less than interpolation errs.
double noiseError(int dimensions, NoiseFormat format);

/// Two sizes that tell by their difference how a program uses noise; both are quickly made.
inline constexpr std::array kNoiseProbeSizes{48, 64};

/// Periods by which contours are moved on the average from a texture of the first of kNoiseProbeSizes to one
/// of the second, both with 16 bits: the mean change of the value divided by the mean gradient, measured.
double meanNoiseStep(int dimensions);

/// The smallest of noiseSizes, with bytes or else 16 bits, for which errorOf is at most maxError; the largest
/// with 16 bits if that is true of none. 16 bits cost little beside the eight times as many texels of the
/// next size.
NoiseFormat leastNoise(int dimensions, double maxError, const std::function<double(NoiseFormat)>& errorOf);

}  // namespace glibra::budget
