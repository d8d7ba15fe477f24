#pragma once
// What a pattern is made of when colours and light are free: tones, in several scales.

#include <cstddef>
#include <vector>

#include "classroom/cut_objects.h"

namespace glibra::classroom {

/// One number per pixel, row by row.
using Plane = std::vector<float>;

inline constexpr std::size_t kToneScales = 9;  ///< each coarser than the one before by the square root of two

/// The tone is the principal component of the colours after their mean around each pixel is taken away,
/// divided by its deviation there: neither hues nor shading matter.
struct ToneScales {
    int side = 0;
    Plane inside;               ///< 1 for pixels of the objects, 0 for others
    std::vector<Plane> levels;  ///< tones, smoothed over the objects alone; empty if these have one colour
    std::vector<Plane> known;   ///< the share of each smoothed tone that comes from the objects, 0 to 1
};
ToneScales toneScalesOf(const Scale& objects);

/// The deviation of the Gaussian of a scale, in pixels; between two scales, too.
float toneDeviation(float scale);

}  // namespace glibra::classroom
