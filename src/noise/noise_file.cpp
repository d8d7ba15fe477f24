#include "noise/noise_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "base/text.h"
#include "geometry/mix.h"
#include "image/file.h"
#include "image/image.h"
#include "image/write.h"

namespace glibra::noise {
namespace {

/// A random number, uniform in -1..1. `kind` is 0 for heights, 1 and 2 for gradients along x and y.
double randomOf(const GraphOptions& options, int octave, int point, int kind) {
    const auto hash =
        geometry::mix(geometry::mix(static_cast<std::uint32_t>(point) + 0x9e3779b9U * (options.seed + 1)) +
                      static_cast<std::uint32_t>(8 * octave + kind));
    return static_cast<double>(hash >> 8) / 8388608.0 - 1;
}

/// Weights of height, gradient and curvature at the two ends of a cell.
struct CellWeights {
    std::array<double, 2> height, gradient, curvature;
};
CellWeights weightsOf(Smoothness smoothness, double t) {
    const double t2 = t * t;
    const double t3 = t2 * t;
    if (smoothness == Smoothness::cubic)
        return {{1 - 3 * t2 + 2 * t3, 3 * t2 - 2 * t3}, {t - 2 * t2 + t3, t3 - t2}, {0, 0}};
    const double t4 = t3 * t;
    const double t5 = t4 * t;
    const double rise = 10 * t3 - 15 * t4 + 6 * t5;
    return {{1 - rise, rise},
            {t - 6 * t3 + 8 * t4 - 3 * t5, -4 * t3 + 7 * t4 - 3 * t5},
            {(t2 - 3 * t3 + 3 * t4 - t5) / 2, (t3 - 2 * t4 + t5) / 2}};
}

/// The lattice of one octave.
class Octave {
  public:
    Octave(const GraphOptions& options, int octave)
        : options_(options), octave_(octave), cells_(options.cells << octave) {}

    [[nodiscard]] double at(double x, double y) const {
        const double column = std::floor(x);
        const double row = std::floor(y);
        const CellWeights u = weightsOf(options_.smoothness, x - column);
        const CellWeights v = weightsOf(options_.smoothness, y - row);
        const bool isPlane = options_.dimensions == 2;
        double sum = 0;
        for (std::size_t b = 0; b < (isPlane ? 2U : 1U); ++b)
            for (std::size_t a = 0; a < 2; ++a) {
                const int i = wrapped(column + static_cast<double>(a));
                const int j = isPlane ? wrapped(row + static_cast<double>(b)) : 0;
                const double across = isPlane ? v.height[b] : 1;
                sum += across * (height(i, j) * u.height[a] + slope(i, j, 0) * u.gradient[a] +
                                 curvature(i, j) * u.curvature[a]);
                if (isPlane) sum += slope(i, j, 1) * u.height[a] * v.gradient[b];
            }
        return sum;
    }

    [[nodiscard]] GraphPoint atPoint(int index) const {
        const int i = index % cells_;
        const int j = index / cells_;
        const bool isCurved = options_.smoothness == Smoothness::quintic;
        return {height(i, j), slope(i, j, 0), isCurved ? curvature(i, j) : 0};
    }

  private:
    [[nodiscard]] int wrapped(double index) const {
        return static_cast<int>(index - std::floor(index / cells_) * cells_);
    }
    [[nodiscard]] int point(int i, int j) const { return i + cells_ * j; }

    [[nodiscard]] double height(int i, int j) const {
        if (octave_ == 0)
            if (const auto set = options_.heights.find(point(i, j)); set != options_.heights.end())
                return set->second;
        return options_.lattice == Lattice::gradient ? 0 : randomOf(options_, octave_, point(i, j), 0);
    }
    [[nodiscard]] double slope(int i, int j, int axis) const {
        if (octave_ == 0 && axis == 0)
            if (const auto set = options_.gradients.find(point(i, j)); set != options_.gradients.end())
                return set->second;
        if (options_.lattice != Lattice::value) return randomOf(options_, octave_, point(i, j), 1 + axis);
        if (options_.slopes == Slopes::zero) return 0;
        const int before = wrapped((axis == 0 ? i : j) - 1.0);
        const int after = wrapped((axis == 0 ? i : j) + 1.0);
        return axis == 0 ? (height(after, j) - height(before, j)) / 2
                         : (height(i, after) - height(i, before)) / 2;
    }

    [[nodiscard]] double curvature(int i, int j) const {
        const auto set = octave_ == 0 ? options_.curvatures.find(point(i, j)) : options_.curvatures.end();
        return set != options_.curvatures.end() ? set->second : 0;
    }

    const GraphOptions& options_;
    int octave_;
    int cells_;
};

}  // namespace

double graphNoise(const GraphOptions& options, double x, double y) {
    double sum = 0;
    double scale = 1;
    for (int octave = 0; octave < std::clamp(options.octaves, 1, kMostGraphOctaves); ++octave, scale /= 2) {
        const double noise = scale * Octave(options, octave).at(x / scale, y / scale);
        sum += options.turbulence ? std::abs(noise) : noise;
    }
    return sum;
}

GraphPoint graphPoint(const GraphOptions& options, int point) {
    return Octave(options, 0).atPoint(point);
}

double graphRange(const GraphOptions& options) {
    const double octaves = 2 - std::ldexp(1.0, 1 - std::clamp(options.octaves, 1, kMostGraphOctaves));
    const bool hasGradients = options.lattice != Lattice::value || options.slopes == Slopes::catmullRom;
    const double gradient = options.smoothness == Smoothness::cubic ? 1 / 4. : 5 / 16.;
    const double heights = options.lattice == Lattice::gradient ? 0 : 1;
    return octaves * (heights + (hasGradients ? gradient * options.dimensions : 0));
}

// Draws noise as graphs, coloured pictures and textures.

namespace {

std::uint8_t asByte(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255));
}

/// Maps the range of the noise to 0..1.
double shown(const GraphOptions& options, double noise) {
    const double part = noise / graphRange(options);
    return options.turbulence ? part : (part + 1) / 2;
}

/// The vertical position of a value in the graph: pixels from the top.
double rowOf(const GraphOptions& options, double noise, int height) {
    return (1 - shown(options, noise)) * height;
}

/// Converts OKLab to linear sRGB to sRGB, clamped to 0..1 (Ottosson, A perceptual color space for image
/// processing, 2020).
std::array<double, 3> screenColor(double lightness, double a, double b) {
    const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    const std::array<double, 3> linear{4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                                       -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                                       -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
    std::array<double, 3> color{};
    std::ranges::transform(linear, color.begin(),
                           [](double each) { return image::srgbOfLinear(std::clamp(each, 0.0, 1.0)); });
    return color;
}

/// From blue over green to yellow, with a chroma that fits into sRGB.
std::array<double, 3> uniformColor(double t) {
    const double lightness = .2 + .75 * t;
    const double hue = (275 - 170 * t) * std::numbers::pi / 180;
    const double chroma = .035 + .09 * std::sin(std::numbers::pi * std::min(1.0, .2 + .75 * t));
    return screenColor(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
}

}  // namespace

std::array<double, 3> colorOf(ColorScale scale, double t) {
    t = std::isfinite(t) ? std::clamp(t, 0.0, 1.0) : 0;
    switch (scale) {
        case ColorScale::grey:
            return {t, t, t};
        case ColorScale::rainbow: {
            // Hue 240 (blue) to 0 (red).
            const double h = 4 * (1 - t);
            return {std::clamp(std::abs(h - 3) - 1, 0.0, 1.0), std::clamp(2 - std::abs(h - 2), 0.0, 1.0),
                    std::clamp(2 - std::abs(h - 4), 0.0, 1.0)};
        }
        case ColorScale::heated:
            return {std::clamp(3 * t, 0.0, 1.0), std::clamp(3 * t - 1, 0.0, 1.0),
                    std::clamp(3 * t - 2, 0.0, 1.0)};
        case ColorScale::sky:
            return {t, t, 1};
        case ColorScale::fire:
            return {1, t, 0};
        case ColorScale::uniform:
            break;
    }
    return uniformColor(t);
}

std::string graphSvg(const GraphOptions& options, int width, int height) {
    const double zero = rowOf(options, 0, height);
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n"
        "<path d=\"M0 {2:.2f}H{0}\" stroke=\"#999\"/>\n<path fill=\"none\" stroke=\"#1f4e9c\" "
        "stroke-width=\"2\" d=\"",
        width, height, zero);
    const int steps = 4 * width;
    for (int i = 0; i <= steps; ++i)
        svg += fmt::format(
            "{}{:.2f} {:.2f}", i == 0 ? 'M' : 'L', static_cast<double>(i) * width / steps,
            rowOf(options, graphNoise(options, static_cast<double>(i) * options.cells / steps), height));
    svg += "\"/>\n";
    for (int i = 0; i <= options.cells; ++i)
        svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"4\" fill=\"#c33\"/>\n",
                           static_cast<double>(i) * width / options.cells,
                           rowOf(options, graphNoise(options, i), height));
    return svg + "</svg>\n";
}

std::vector<std::uint8_t> graphPixels(const GraphOptions& options, int width, int height) {
    constexpr double kHalfLine = 1;
    constexpr double kPoint = 4;
    std::vector<std::uint8_t> pixels(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                                     255);
    const auto row = [&](double x) {
        return rowOf(options, graphNoise(options, x * options.cells / width), height);
    };
    const double zero = rowOf(options, 0, height);
    const auto blend = [&](std::size_t at, const std::array<double, 3>& color, double part) {
        for (std::size_t c = 0; c < 3; ++c)
            pixels[at + c] = asByte((1 - part) * pixels[at + c] / 255.0 + part * color[c]);
    };
    for (int x = 0; x < width; ++x) {
        const double here = row(x + .5);
        // The distance to a line is the vertical distance times the cosine of the angle of its slope.
        const double slope = row(x + 1.0) - row(x);
        const double steep = 1 / std::sqrt(1 + slope * slope);
        const double nearest = std::round((x + .5) * options.cells / width);
        const double pointX = nearest * width / options.cells;
        const double pointY = rowOf(options, graphNoise(options, nearest), height);
        for (int y = 0; y < height; ++y) {
            const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                        static_cast<std::size_t>(x));
            blend(at, {.6, .6, .6}, std::clamp(1 - std::abs(y + .5 - zero), 0.0, 1.0));
            blend(at, {.12, .31, .61},
                  std::clamp(kHalfLine + .5 - std::abs(y + .5 - here) * steep, 0.0, 1.0));
            blend(at, {.8, .2, .2},
                  std::clamp(kPoint + .5 - std::hypot(x + .5 - pointX, y + .5 - pointY), 0.0, 1.0));
        }
    }
    return pixels;
}

std::vector<std::uint8_t> noisePixels(const GraphOptions& options, ColorScale scale, int width, int height) {
    std::vector<std::uint8_t> pixels;
    pixels.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x)
            for (const double each :
                 colorOf(scale, shown(options, graphNoise(options, (x + .5) * options.cells / width,
                                                          (y + .5) * options.cells / height))))
                pixels.push_back(asByte(each));
    return pixels;
}

std::vector<std::byte> noiseTexture(const GraphOptions& options, int width, int height) {
    std::vector<std::byte> bytes;
    const auto add = [&](std::uint32_t word) {
        for (unsigned shift = 0; shift < 32; shift += 8)
            bytes.push_back(static_cast<std::byte>(word >> shift & 0xFFU));
    };
    add(static_cast<std::uint32_t>(width));
    const int rows = options.dimensions == 2 ? height : 1;
    if (options.dimensions == 2) add(static_cast<std::uint32_t>(height));
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < width; ++x) {
            const double noise = graphNoise(options, static_cast<double>(x) * options.cells / width,
                                            static_cast<double>(y) * options.cells / rows);
            const auto word = std::bit_cast<std::uint32_t>(static_cast<float>(noise));
            for (int c = 0; c < 3; ++c) add(word);
            add(std::bit_cast<std::uint32_t>(1.F));
        }
    return bytes;
}

namespace {

template <std::size_t N, class Enumerator>
const char* wordOf(const std::array<const char*, N>& words, Enumerator value) {
    return words.at(static_cast<std::size_t>(value));
}

/// " --height 3=0.5" for each point.
std::string pointArguments(const char* name, const std::map<int, double>& points) {
    std::string text;
    for (const auto& [point, value] : points) text += fmt::format(" {} {}={}", name, point, value);
    return text;
}

bool usesSlopes(const GraphOptions& options) {
    return options.lattice == Lattice::value;
}

bool usesColors(const NoiseFile& noise, const std::filesystem::path& file) {
    return noise.options.dimensions == 2 && endingOf(file) != ".tex";
}

}  // namespace

std::string endingOf(const std::filesystem::path& file) {
    return base::lower(file.extension().generic_string());
}

Diagnostics writeNoise(const NoiseFile& noise, const std::filesystem::path& file) {
    const std::string ending = endingOf(file);
    if (ending == ".tex")
        return image::writeFileAtomically(file, noiseTexture(noise.options, noise.width, noise.height));
    if (ending == ".svg") {
        const std::string svg = graphSvg(noise.options, noise.width, noise.height);
        return image::writeFileAtomically(file, std::as_bytes(std::span(svg)));
    }
    const std::vector<std::uint8_t> pixels =
        noise.options.dimensions == 1 ? graphPixels(noise.options, noise.width, noise.height)
                                      : noisePixels(noise.options, noise.colors, noise.width, noise.height);
    image::Image picture{noise.width, noise.height, 3, image::Component::u8, {}};
    const auto bytes = std::as_bytes(std::span(pixels));
    picture.data.assign(bytes.begin(), bytes.end());
    return image::writeImage(picture, file);
}

std::string uselessOption(const NoiseFile& noise, const std::filesystem::path& file) {
    const GraphOptions& options = noise.options;
    if (!options.curvatures.empty() && options.smoothness == Smoothness::cubic)
        return "--curvature: heights and gradients determine a cubic; take --smooth quintic";
    if (options.slopes != Slopes::zero && !usesSlopes(options))
        return "--gradients: only --lattice value takes gradients from the heights";
    if (noise.colors != ColorScale::grey && !usesColors(noise, file))
        return "--colors: only a picture of two dimensions has colors";
    const int points = options.dimensions == 1 ? options.cells : options.cells * options.cells;
    for (const auto& [name, values] :
         {std::pair("--height", &options.heights), std::pair("--gradient", &options.gradients),
          std::pair("--curvature", &options.curvatures)})
        if (!values->empty() && values->rbegin()->first >= points)
            return fmt::format("{} {}={:g}: the points are 0 to {}", name, values->rbegin()->first,
                               values->rbegin()->second, points - 1);
    return {};
}

std::string noiseCommand(const NoiseFile& noise, const std::string& file) {
    const GraphOptions& options = noise.options;
    const GraphOptions usual;
    std::string text = fmt::format("glibra noise {}", options.dimensions);
    if (options.lattice != usual.lattice)
        text += fmt::format(" --lattice {}", wordOf(kLatticeWords, options.lattice));
    if (options.smoothness != usual.smoothness)
        text += fmt::format(" --smooth {}", wordOf(kSmoothnessWords, options.smoothness));
    if (options.slopes != usual.slopes && usesSlopes(options))
        text += fmt::format(" --gradients {}", wordOf(kSlopesWords, options.slopes));
    if (noise.colors != ColorScale::grey && usesColors(noise, file))
        text += fmt::format(" --colors {}", wordOf(kColorWords, noise.colors));
    if (options.octaves != usual.octaves) text += fmt::format(" --octaves {}", options.octaves);
    if (options.cells != usual.cells) text += fmt::format(" --points {}", options.cells);
    if (options.seed != usual.seed) text += fmt::format(" --seed {}", options.seed);
    if (options.turbulence) text += " --turbulence";
    text += pointArguments("--height", options.heights);
    text += pointArguments("--gradient", options.gradients);
    if (options.smoothness == Smoothness::quintic) text += pointArguments("--curvature", options.curvatures);
    return text +
           fmt::format(" --size {}x{} -o {}", noise.width, noise.height, base::shellWord(file, "/._-+"));
}

}  // namespace glibra::noise
