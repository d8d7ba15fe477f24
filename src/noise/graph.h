#pragma once
// Noise for teaching graphs and pictures: lattice noise in one and two dimensions whose parts can all be set.
// The noise of scenes is in noise.h.

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::noise {

/// The random quantities at lattice points. `value`: heights, with gradients by Slopes; `gradient`:
/// gradients, with all heights 0; `both`: heights and gradients.
enum class Lattice { value, gradient, both };
/// Hermite interpolation between lattice points: cubic, or quintic with curvature 0 at the points (Perlin,
/// Improving Noise, 2002).
enum class Smoothness { cubic, quintic };
/// Gradients of value noise: flat points, or the Catmull-Rom slope (half the difference of the neighbours).
enum class Slopes { zero, catmullRom };

struct GraphOptions {
    int dimensions = 1;  ///< 1 or 2
    int cells = 8;       ///< of the first octave in a period, 2..256
    std::uint32_t seed = 0;
    Lattice lattice = Lattice::value;
    Smoothness smoothness = Smoothness::quintic;
    Slopes slopes = Slopes::zero;
    int octaves = 1;          ///< 1..8; each has half the height and twice the frequency of the one before
    bool turbulence = false;  ///< the sum of absolute values
    std::map<int, double> heights{};    ///< of points of the first octave, instead of random ones in -1..1
    std::map<int, double> gradients{};  ///< likewise, along x, height a cell
    /// Second derivatives along x at points of the first octave, height a cell squared; others have 0. Only
    /// quintics have them: a cubic is determined by heights and gradients.
    std::map<int, double> curvatures{};
    friend bool operator==(const GraphOptions&, const GraphOptions&) = default;
};

inline constexpr int kMostGraphOctaves = 8;
inline constexpr int kMostGraphCells = 256;

/// The noise at x (and y) in cells of the first octave, periodic with `cells`. Point i of a 2D lattice is
/// (i mod cells, i / cells).
double graphNoise(const GraphOptions& options, double x, double y = 0);
/// The first octave at one of its points, along x; gradient and curvature as they enter the curve.
struct GraphPoint {
    double height = 0, gradient = 0, curvature = 0;
};
GraphPoint graphPoint(const GraphOptions& options, int point);

/// What graphs and pictures show: -range..range, of turbulence 0..range. The most that heights and gradients
/// in -1..1 can give, all octaves together: gradients 1 and -1 at the ends of a cell lift its middle by 1/4
/// in a cubic, by 5/16 in a quintic; in two dimensions both axes add that.
double graphRange(const GraphOptions& options);

enum class ColorScale { grey, rainbow, heated, uniform };
/// Red, green, blue in 0..1 for t in 0..1. `heated`: black, red, yellow, white, like a body that is heated.
/// `uniform`: the lightness in OKLab (Ottosson, 2020) rises evenly.
std::array<double, 3> colorOf(ColorScale scale, double t);

/// The graph over one period, as an SVG file of that size with axes,
/// points and the curve.
std::string graphSvg(const GraphOptions& options, int width, int height);
/// The same as RGB bytes, top row first, the curve drawn with smooth edges.
std::vector<std::uint8_t> graphPixels(const GraphOptions& options, int width, int height);
/// 2D noise over one period, coloured, RGB bytes, top row first; the range is the whole scale.
std::vector<std::uint8_t> noisePixels(const GraphOptions& options, ColorScale scale, int width, int height);
/// A raw float texture (language, 8.3) of one or two dimensions: the noise in red, green and blue, alpha 1.
std::vector<std::byte> noiseTexture(const GraphOptions& options, int width, int height);

}  // namespace glibra::noise
