#pragma once
// How far samples a pixel and texels of a noise texture move what they show.

#include <span>

namespace glibra::budget {

/// Pixels by which an edge may lie beside the place that the samples of its pixels tell, for a regular
/// pattern of that many samples: half the distance of its rows, 1 / (2 sqrt n).
double edgeError(int samples);

/// The smallest power of two whose edgeError is no larger than maxError (pixels), but no more than `most`.
int leastSamples(double maxError, int most);

/// Sizes among which noise textures are chosen: each holds every texel of the one before.
std::span<const int> noiseSizes(int dimensions);

/// Distance in periods of the texture by which 95 of 100 contours of the four octaves' sum are beside their
/// place in a texture of that size, filtered linearly: the error of the value divided by the root mean square
/// of the gradient, 2.56 and 2.17 a period. The first part is interpolation between texels, which falls with
/// size^2 once the finest octave (32 cells a period) is resolved; the second is the texels' rounding to
/// bytes. dimensions is 2 or 3, size at least 32.
double noiseError(int dimensions, int size);

/// The smallest of noiseSizes with noiseError * pixelsPerPeriod <= maxError; the largest if none has it.
int leastNoiseSize(int dimensions, double pixelsPerPeriod, double maxError);

}  // namespace glibra::budget
