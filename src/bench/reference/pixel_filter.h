#pragma once
// Reduces many samples per pixel to one value per pixel.

#include <span>
#include <string_view>
#include <vector>

namespace glibra::bench {

/// box: 1 pixel wide. tent: 2 pixels wide. gaussian: exp(-2 x^2), cut off at 1.5. mitchell: B = C = 1/3,
/// radius 2 (D. Mitchell and A. Netravali, Reconstruction Filters in Computer Graphics, 1988). lanczos2: sinc
/// windowed by sinc(x / 2), radius 2.
enum class PixelFilter { box, tent, gaussian, mitchell, lanczos2 };

inline constexpr PixelFilter kPixelFilters[] = {PixelFilter::box, PixelFilter::tent, PixelFilter::gaussian,
                                                PixelFilter::mitchell, PixelFilter::lanczos2};

std::string_view name(PixelFilter filter);
/// Half the filter's width, in pixels.
double radiusOf(PixelFilter filter);
/// The weight at a distance of x pixels from the centre of the pixel along one axis, not normalised.
double weightOf(PixelFilter filter, double x);

/// width x height pixels of a grey picture with factor x factor samples per pixel on a regular grid. A weight
/// is the product of the weights along both axes; weights are scaled to add up to 1. Samples outside the
/// picture are left out.
std::vector<double> reduce(std::span<const float> samples, int width, int height, int factor,
                           PixelFilter filter);

/// The root mean square of the differences of two pictures of equal size, whose white is 1, in 255ths.
double errorInBytes(const std::vector<double>& picture, const std::vector<double>& reference);

}  // namespace glibra::bench
