#pragma once
// A picture, and its blur and Sobel gradient in double: what filters in shaders are compared with.

#include <cstdint>
#include <vector>

namespace glibra::bench {

/// One value a pixel, rows from the bottom to the top.
struct Plane {
    int width = 0, height = 0;
    std::vector<double> values;

    /// The nearest pixel inside.
    [[nodiscard]] double at(int x, int y) const;
};

/// Edges, ramps, thin lines and grain, each pixel a multiple of 1/255 in 0..1.
Plane testPicture(int side);
/// The picture as 255ths, for a texture.
std::vector<std::uint8_t> bytesOf(const Plane& plane);

/// Weights of a Gaussian at 0..radius pixels, of standard deviation radius / 2, which add up to 1 over
/// -radius..radius. radius >= 1.
std::vector<double> gaussianWeights(int radius);

/// Each pixel the weighted sum of the square of (2 radius + 1)^2 pixels about it. Pixels beyond the picture
/// are those of its rim.
Plane blurred(const Plane& plane, const std::vector<double>& weights);

/// Length of the gradient by the 3 x 3 kernels of Sobel, of sums 4 on either side: 0 to 4 sqrt(2) for values
/// of 0..1.
Plane sobel(const Plane& plane);

/// Root mean square of the differences; the planes have one size.
double rootMeanSquare(const Plane& a, const Plane& b);

}  // namespace glibra::bench
