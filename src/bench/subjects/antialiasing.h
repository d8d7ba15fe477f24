#pragma once
// Black and white patterns that are hard to sample, and how many samples per pixel become one value.

#include <array>
#include <functional>
#include <memory>

#include "bench/core/device.h"

namespace glibra::bench {

/// Corners in pixels; (0, 0) is the upper left corner of the picture.
using FlatTriangle = std::array<glm::dvec2, 3>;
/// The share of each pixel, 0..1, that the triangles cover. They do not overlap. Each triangle is clipped in
/// double by the square of the pixel (I. Sutherland and G. Hodgman, Reentrant Polygon Clipping, 1974). Rows
/// from the top.
std::vector<double> coverage(std::span<const FlatTriangle> triangles, int width, int height);

/// How samples are weighted, by their distance from the centre of the pixel.
struct PixelFilter {
    std::string_view name;
    double radius;               ///< half the filter's width, in pixels
    double (*inside)(double x);  ///< the weight at 0 <= x <= radius along one axis, not normalised
    [[nodiscard]] double weight(double x) const;
};
/// box: 1 pixel wide. tent: 2 pixels wide. Gaussian: exp(-2 x^2), cut off at 1.5. Mitchell: B = C = 1/3,
/// radius 2 (D. Mitchell and A. Netravali, Reconstruction Filters in Computer Graphics, 1988). Lanczos 2:
/// sinc windowed by sinc(x / 2), radius 2.
std::span<const PixelFilter, 5> pixelFilters();

/// width x height pixels of a grey picture with factor x factor samples per pixel on a regular grid. A weight
/// is the product of the weights along both axes; weights are scaled to add up to 1. Samples outside the
/// picture are left out.
std::vector<double> reduce(std::span<const float> samples, int width, int height, int factor,
                           const PixelFilter& filter = pixelFilters()[0]);
/// The root mean square of the differences of two pictures of equal size, whose white is 1, in 255ths.
double errorInBytes(std::span<const double> picture, std::span<const double> reference);

struct Pattern {
    std::string_view name, title;
    /// Exact integrals over the pixels of a side x side picture, rows from the top; null if there is no
    /// closed form.
    std::vector<double> (*exact)(int side) = nullptr;
    /// Ways of drawing it; the first draws the pattern itself, sampled at points.
    std::vector<std::pair<std::string_view, Shader>> ways;
    std::shared_ptr<const Vertices> triangles{};  ///< null: the programs cover the whole target

    /// One grey value per sample: the picture of side x side pixels on a canvas of any multiple.
    [[nodiscard]] std::vector<float> drawn(const Canvas& canvas, int side, std::size_t way = 0) const;
};

/// A star of 17 narrow triangles (exact: clipped areas), an axis-parallel checkerboard of .83 x .61 pixels
/// per square (exact: product of two integrals), a checkerboard on a plane in perspective, and slanted
/// stripes of 24 to 1.3 pixels per period. The stripes are drawn with a step, a smooth step as wide as a
/// pixel, and the integrals over that width and over the square of the pixel.
std::vector<Pattern> patterns(Bench& bench);

std::vector<Figure> measureAntialiasing(Bench& bench);

}  // namespace glibra::bench
