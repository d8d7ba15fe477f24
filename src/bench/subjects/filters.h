#pragma once
// A picture, its blur and its Sobel gradient in double, and filters as chains of passes on the device.

#include "bench/core/device.h"

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
/// The weights of a Gaussian at 0..radius pixels, with standard deviation radius / 2. They add up to 1 over
/// -radius..radius. radius >= 1.
std::vector<double> gaussianWeights(int radius);
/// Each pixel becomes the weighted sum of the (2 radius + 1)^2 pixels around it. Pixels beyond the picture
/// equal those at its rim.
Plane blurred(const Plane& plane, const std::vector<double>& weights);
/// The length of the gradient by the 3 x 3 Sobel kernels, whose weights add up to 4 on either side: 0 to 4
/// sqrt(2) for values in 0..1.
Plane sobel(const Plane& plane);

/// Fragment shaders of consecutive passes: they read uPicture and write fColor.
using Passes = std::vector<std::string>;
Passes directBlur(const std::vector<double>& weights);
Passes separableBlur(const std::vector<double>& weights);
/// The same with half as many reads: the linear filter weights two neighbours by a place between them.
Passes pairedBlur(const std::vector<double>& weights);
Passes directSobel();
/// First pass: red is the column smoothed by 1 2 1, green its difference, times `scale` plus `bias`. Second
/// pass: the length of the gradient.
Passes separableSobel(double scale, double bias);

/// The first pass reads the picture, the last writes floats, the others write a texture of format `between`.
class FilterChain {
  public:
    /// At least one pass. The picture is uploaded as bytes.
    FilterChain(Bench& bench, const Plane& picture, const Passes& passes, gpu::TexelFormat between);
    /// Runs all passes; does not wait.
    void draw() const;
    /// The red component of the last pass.
    [[nodiscard]] Plane result() const;
    /// Bytes of the textures between the passes.
    [[nodiscard]] double bytesBetween() const;

  private:
    struct Pass {
        Shader shader;
        Texels into;
        gpu::Target target;
    };
    const gpu::Capabilities& capabilities_;
    Texels picture_;
    std::vector<Pass> passes_;
};

std::vector<Figure> measureFilters(Bench& bench);

}  // namespace glibra::bench
