#pragma once
// A picture, its blur and its Sobel gradient in double: the reference for filters in shaders.

#include <cstdint>
#include <vector>

namespace glibra::bench {

/// One value per pixel, rows from bottom to top.
struct Plane {
    int width = 0, height = 0;
    std::vector<double> values;

    /// The value of the nearest pixel inside the picture.
    [[nodiscard]] double at(int x, int y) const;
};

/// Edges, ramps, thin lines and grain. Each pixel is a multiple of 1/255 in 0..1.
Plane testPicture(int side);
/// The picture in 255ths, for a texture.
std::vector<std::uint8_t> bytesOf(const Plane& plane);

/// The weights of a Gaussian at 0..radius pixels, with standard deviation radius / 2. They add up to 1 over
/// -radius..radius. radius >= 1.
std::vector<double> gaussianWeights(int radius);

/// Each pixel becomes the weighted sum of the (2 radius + 1)^2 pixels around it. Pixels beyond the picture
/// equal those at its rim.
Plane blurred(const Plane& plane, const std::vector<double>& weights);

/// The length of the gradient by the 3 x 3 Sobel kernels, whose weights add up to 4 on either side: 0 to 4
/// sqrt(2) for values in 0..1.
Plane sobel(const Plane& plane);

/// The root mean square of the differences of two planes of equal size.
double rootMeanSquare(const Plane& a, const Plane& b);

}  // namespace glibra::bench
