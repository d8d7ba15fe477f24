#pragma once
// The parts of a pattern, wherever they are: blobs of any size with what is around them, to be found again in
// another picture in another place, size, direction and colour.

#include <array>
#include <vector>

#include "classroom/cut_objects.h"

namespace glibra::classroom {

inline constexpr int kRings = 6;    ///< around a blob, at 1 to kRings times its radius
inline constexpr int kAngles = 16;  ///< on each ring

/// A blob: a place that is brighter, or darker, than what is around it, and its surroundings in polar samples.
struct PatternPoint {
    float x = 0, y = 0;      ///< in pixels of the scale
    float radius = 0;        ///< deviation of the Gaussian that fits it, in pixels
    float strength = 0;
    /// Tones around it, of the blob's own sign, ring by ring; each ring stands there twice, so that it can be
    /// read from any angle on. 0 where there is no object, and `known` says so.
    std::array<float, std::size_t{kRings} * kAngles * 2> tones{}, known{};
};

/// What is found in one picture.
struct PatternPoints {
    std::vector<PatternPoint> points;  ///< the strongest first
    double covered = 0;                ///< the share of the objects that lies within the blobs' surroundings
    double contrast = 0;               ///< deviation of the pattern by that of all colours: 0 for smooth shading
};

/// Blobs are maxima of differences of Gaussians over place and size (D. Lowe: "Distinctive Image Features from
/// Scale-Invariant Keypoints", IJCV 2004). The tone is the principal component of the colours after their mean
/// around each pixel is taken away, divided by its deviation there: neither hues nor shading matter.
PatternPoints findPatternPoints(const Scale& objects);

/// How well the points of one picture are found in the other and the other way round (D. Simakov et al.:
/// "Summarizing Visual Data Using Bidirectional Similarity", CVPR 2008): the mean of the largest correlations of
/// the surroundings, turned by any angle, from 0 to 1.
double foundAgain(const PatternPoints& a, const PatternPoints& b);

}  // namespace glibra::classroom
