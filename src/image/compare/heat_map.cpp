#include "image/compare/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "image/bytes.h"
#include "image/compare/alike.h"
#include "image/convert.h"

namespace glibra::image {
namespace {

// Coefficients of 1, t, ..., t^6 for red, green, blue.
constexpr double kMagma[7][3] = {
    {-0.002136485053939582, -0.000749655052795221, -0.005386127855323933},
    {0.2516605407371642, 0.6775232436837668, 2.494026599312351},
    {8.353717279216625, -3.577719514958484, 0.3144679030132573},
    {-27.66873308576866, 14.26473078096533, -13.64921318813922},
    {52.17613981234068, -27.94360607168351, 12.94416944238394},
    {-50.76852536473588, 29.04658282127291, 4.23415299384598},
    {18.65570506591883, -11.48977351997711, -5.601961508734096},
};

using HeatColor = std::array<std::byte, 3>;

/// 256 colours, so that a pixel costs one look-up.
const std::array<HeatColor, 256>& heatColors() {
    static const std::array<HeatColor, 256> colors = [] {
        std::array<HeatColor, 256> all{};
        for (std::size_t i = 0; i < all.size(); ++i) {
            double rgb[3];
            magma(static_cast<double>(i) / 255, rgb[0], rgb[1], rgb[2]);
            for (std::size_t c = 0; c < 3; ++c) all[i][c] = static_cast<std::byte>(std::lround(rgb[c] * 255));
        }
        all[0] = {};  // black means no difference, and only that
        return all;
    }();
    return colors;
}

Image emptyMap(int width, int height) {
    Image map{width, height, 3, Component::u8, {}};
    map.data.resize(map.rowBytes() * static_cast<std::size_t>(height));
    return map;
}

/// `value` is in 0..1; values above 0 are never black.
void paint(Image& map, std::size_t pixel, double value) {
    const auto index = value > 0 ? std::max<long>(1, std::lround(std::min(value, 1.) * 255)) : 0;
    std::memcpy(map.data.data() + 3 * pixel, heatColors()[static_cast<std::size_t>(index)].data(), 3);
}

}  // namespace

void magma(double value, double& red, double& green, double& blue) {
    const double t = value < 1 ? std::max(value, 0.) : 1;  // 1 for NaN
    const auto polynomial = [t](std::size_t c) {
        double sum = 0;
        for (std::size_t i = std::size(kMagma); i-- > 0;) sum = sum * t + kMagma[i][c];
        return std::clamp(sum, 0., 1.);
    };
    red = polynomial(0);
    green = polynomial(1);
    blue = polynomial(2);
}

Image differenceHeatMap(const Image& expected, const Image& got) {
    if (!areComparable(expected, got)) return {};
    return withAlike(expected, got, [](const Image& first, const Image& second) {
        const Image a = withType(first, Component::f32), b = withType(second, Component::f32);
        Image map = emptyMap(a.width, a.height);
        const auto components = static_cast<std::size_t>(a.components);
        for (std::size_t pixel = 0; pixel < map.data.size() / 3; ++pixel) {
            double largest = 0;
            for (std::size_t i = pixel * components; i < (pixel + 1) * components; ++i)
                largest = std::max(largest,
                                   apart(valueAt<float>(a.data.data(), i), valueAt<float>(b.data.data(), i)));
            paint(map, pixel, std::log2(1 + 255 * largest) / 8);
        }
        return map;
    });
}

Image flipHeatMap(const FlipResult& result) {
    Image map = emptyMap(result.width, result.height);
    for (std::size_t i = 0; i < result.errors.size(); ++i)
        paint(map, i, static_cast<double>(result.errors[i]));
    return map;
}

}  // namespace glibra::image
