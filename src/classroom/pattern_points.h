#pragma once
// The parts of a pattern, wherever they are, and the tones that they are found in.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "classroom/cut_objects.h"

namespace glibra::classroom {

// What a pattern is made of when colours and light are free: tones, in several scales.

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

// The parts of a pattern, wherever they are: blobs of any size with what is around them, to be found again in
// another picture in another place, size, direction and colour.

inline constexpr int kRings = 5;    ///< around a blob, at 1 to kRings times its radius
inline constexpr int kAngles = 16;  ///< on each ring

/// A blob: a place that is brighter, or darker, than what is around it, and its surroundings in polar
/// samples.
struct PatternPoint {
    float x = 0, y = 0;  ///< in pixels
    float radius = 0;    ///< deviation of the Gaussian that fits it, in pixels
    /// Tones around it, of the blob's own sign, ring by ring; each ring stands there twice, so that it can be
    /// read from any angle on. 0 where there is no object, and `known` says so.
    std::array<float, std::size_t{kRings} * kAngles * 2> tones{}, known{};
};

/// The blobs of a picture, the strongest first. They are maxima of differences of Gaussians over place and
/// size (D. Lowe: "Distinctive Image Features from Scale-Invariant Keypoints", IJCV 2004).
std::vector<PatternPoint> findPatternPoints(const ToneScales& tones);

/// How well the points of one picture are found in the other.
struct FoundAgain {
    double correlation = 0;  ///< 0 to 1; unrelated patterns have about 0.75
    double octaves = 0;      ///< how much larger they are there: 1 is twice
};

/// Each point is compared with all points of the other picture, turned by any angle, and the other way round
/// (D. Simakov et al.: "Summarizing Visual Data Using Bidirectional Similarity", CVPR 2008). The means are
/// those of the largest correlations.
FoundAgain foundAgain(std::span<const PatternPoint> a, std::span<const PatternPoint> b);

/// How alike the points of one picture are to each other: the mean correlation of each with the three that
/// are most like it, 0 to 1.
double repetition(std::span<const PatternPoint> points);

}  // namespace glibra::classroom
