#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>

#include "bench/core/fit.h"
#include "bench/draw/byte_filter.h"
#include "bench/draw/noise_shaders.h"
#include "bench/draw/noise_volume.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

constexpr int kNoiseSide = 256;
constexpr const char* kNoiseReference = "the noise function itself, in double";

/// A slanted plane through one period.
constexpr NoisePlane slanted() {
    return {.corner = {.013, .027, .37}, .across = {.95, .02, .11}, .up = {.03, .93, .29}};
}

double sumOf(const Octaves& octaves) {
    return std::accumulate(octaves.begin(), octaves.end(), 0.);
}

std::vector<int> sidesOf(const Bench& bench) {
    return bench.isQuick() ? std::vector{16, 32, 64} : std::vector{16, 32, 64, 128, 256};
}

/// Exact texels by size, computed once; the largest take 268 MB.
class ExactTexels {
  public:
    const std::vector<float>& of(int side) {
        std::vector<float>& texels = bySide_[side];
        if (texels.empty()) texels = exactTexels(side);
        return texels;
    }

  private:
    std::map<int, std::vector<float>> bySide_;
};

struct Sample {
    glm::dvec3 place{0};
    Octaves exact{};
};

std::vector<Sample> samplesOf(int count) {
    std::vector<Sample> samples;
    samples.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) samples.push_back({spread(i), exactNoise(spread(i))});
    return samples;
}

std::string texelsLabel(int side) {
    return fmt::format("{0} x {0} x {0}", side);
}

/// Findings about the sum of the octaves. `look` is the median time of the look-ups in the largest texture.
void addSumFindings(Figure& sum, const Bench& bench, const std::vector<Sample>& samples, double look) {
    for (const Curve& curve : sum.curves) {
        sum.findings.push_back(orderSentence(curve, "texels"));
        sum.findings.push_back(fmt::format("{}: {}/255 at {}", curve.name,
                                           numberText(curve.points.back().error), curve.points.back().label));
    }
    double kept = 0;
    const Timing direct = bench.time([&] {
        for (const Sample& each : samples) kept += sumOf(exactNoise(each.place));
    });
    sum.findings.push_back(
        fmt::format("the function itself takes {:.1f} times as long as a look-up in the largest texture",
                    std::isnan(kept) ? kept : direct.median / look));
    const Curve &cut = curveNamed(sum, name(NoiseFormat::byteFloor)),
                &rounded = curveNamed(sum, name(NoiseFormat::byteNearest));
    sum.findings.push_back(
        fmt::format("rounding bytes instead of cutting them off leaves {:.0f} % of the error at {}",
                    100 * rounded.points.back().error / cut.points.back().error, cut.points.back().label));
}

void addOctaveFindings(Figure& octaves) {
    for (int i = 0; i < noise::kOctaves; ++i) {
        const Curve& curve = octaves.curves[static_cast<std::size_t>(i)];
        const double from = 2 * noise::cellsOf(i);
        if (!std::isnan(fittedOrder(curve, from)))
            octaves.findings.push_back(orderSentence(curve, "texels", from));
    }
    for (const Point& point : octaves.curves.front().points)
        octaves.findings.push_back(fmt::format("{:g} texels per cell leave {} of the octave wrong",
                                               point.setting / noise::cellsOf(0), numberText(point.error)));
}

/// Interpolates on the CPU, for the sum and for each octave.
std::vector<Figure> onCpu(const Bench& bench, ExactTexels& exact) {
    Figure sum{.name = "texels",
               .title = "Noise texture: sum of four octaves, interpolated in double (time: 4096 places)",
               .settingName = "texels per side",
               .errorName = "root mean square error",
               .errorUnit = "1/255",
               .reference = kNoiseReference};
    Figure octaves{.name = "octaves",
                   .title = "Noise texture of floats: each octave, interpolated in double",
                   .settingName = "texels per side",
                   .errorName = "root mean square error, of the octave's own root mean square",
                   .errorUnit = "",
                   .reference = kNoiseReference,
                   .alternatives = Alternatives::curve};
    const std::vector<Sample> samples = samplesOf(4096);
    Octaves strength{};
    for (const Sample& each : samples)
        for (std::size_t i = 0; i < strength.size(); ++i) strength[i] += std::pow(each.exact[i] - .5, 2);
    double look = 0;
    for (const int side : sidesOf(bench))
        for (const NoiseFormat format : kNoiseFormats) {
            const NoiseVolume volume(side, format, exact.of(side));
            double error = 0;
            Octaves errors{};
            for (const Sample& each : samples) {
                const Octaves found = volume.at(each.place);
                error += std::pow(sumOf(found) - sumOf(each.exact), 2);
                for (std::size_t i = 0; i < errors.size(); ++i)
                    errors[i] += std::pow(found[i] - each.exact[i], 2);
            }
            Point point{.setting = static_cast<double>(side),
                        .label = texelsLabel(side),
                        .error = kByte * std::sqrt(error / static_cast<double>(samples.size()))};
            double kept = 0;
            point.time = bench.time([&] {
                for (const Sample& each : samples) kept += sumOf(volume.at(each.place));
            });
            if (std::isnan(kept)) point.error = kept;
            point.memory = volume.bytes();
            look = point.time->median;
            curveNamed(sum, name(format)).points.push_back(point);
            if (format != NoiseFormat::single) continue;
            for (int i = 0; i < noise::kOctaves; ++i) {
                const auto octave = static_cast<std::size_t>(i);
                point.error = std::sqrt(errors[octave] / strength[octave]);
                curveNamed(octaves, fmt::format("{} cells per period", noise::cellsOf(i)))
                    .points.push_back(point);
            }
        }
    addSumFindings(sum, bench, samples, look);
    addOctaveFindings(octaves);
    return {std::move(sum), std::move(octaves)};
}

/// The root mean square of the error of the sum over a picture, in 255ths.
Result<double> noiseSumError(const NoisePicture& picture, const NoisePlane& plane) {
    Result<std::vector<float>> pixels = picture.pixels();
    if (!pixels) return std::move(pixels.diagnostics);
    double sum = 0;
    const int side = picture.side();
    const float* found = pixels->data();
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column, found += noise::kOctaves) {
            const double all = std::accumulate(found, found + noise::kOctaves, 0.);
            sum += std::pow(all - sumOf(exactNoise(picture.place(plane, column, row))), 2);
        }
    return kByte * std::sqrt(sum / (side * side));
}

Result<Point> drawn(const Bench& bench, const NoisePicture& picture, const NoiseVolume* volume,
                    const gpu::Texture* texture) {
    const Timing timing = bench.time([&] { picture.draw(slanted(), texture); });
    Result<double> error = noiseSumError(picture, slanted());
    if (!error) return std::move(error.diagnostics);
    Point point{.setting = volume ? static_cast<double>(volume->side()) : 1,
                .label = volume ? texelsLabel(volume->side()) : "no texture",
                .error = *error,
                .time = timing};
    if (volume) point.memory = volume->bytes();
    return point;
}

/// The driver's filter on the bytes of scenes, for each size.
Result<std::vector<Point>> filteredBytes(const Bench& bench, const gpu::Capabilities& capabilities) {
    Result<NoisePicture> picture = NoisePicture::create(capabilities, NoiseShader::driverFilter, kNoiseSide);
    if (!picture) return std::move(picture.diagnostics);
    std::vector<Point> points;
    for (const int side : sidesOf(bench)) {
        const NoiseVolume volume(side, NoiseFormat::byteFloor, {});
        Result<gpu::Texture> texture = volume.upload(capabilities);
        if (!texture) return std::move(texture.diagnostics);
        Result<Point> point = drawn(bench, *picture, &volume, &*texture);
        if (!point) return std::move(point.diagnostics);
        points.push_back(std::move(*point));
    }
    return points;
}

void compareDrawn(Figure& figure) {
    const auto last = [&](std::string_view curve) -> const Point& {
        return curveNamed(figure, curve).points.back();
    };
    const Point& driver = last("driver's filter, float");
    const Point& shader = last("shader's filter, float");
    const Point& function = last("function in the shader");
    figure.findings.push_back(fmt::format(
        "{}: filtering in the shader takes {:.2f} times as long as the driver's filter, the function itself "
        "{:.2f} times",
        driver.label, shader.time->median / driver.time->median,
        function.time->median / driver.time->median));
    figure.findings.push_back(fmt::format("the function in the shader is within {}/255 of the one in double",
                                          numberText(function.error)));
    const Point& bytes = last("driver's filter, 8 bit, cut off");
    for (const Curve& curve : figure.curves) {
        if (curve.name != "driver's filter in bytes, 8 bit, cut off") continue;
        const Point& fast = curve.points.back();
        figure.findings.push_back(
            fmt::format("{}: filtering bytes with byte arithmetic takes {:.2f} times the time of float "
                        "arithmetic, with {} "
                        "instead of {}/255",
                        fast.label, fast.time->median / bytes.time->median, numberText(fast.error),
                        numberText(bytes.error)));
    }
}

Result<Figure> onDevice(Bench& bench, const gpu::Context& context, ExactTexels& exact) {
    const gpu::Capabilities& capabilities = context.capabilities();
    Figure figure{
        .name = "drawn",
        .title = fmt::format("Noise in a picture of {0} x {0} pixels, sum of four octaves", kNoiseSide),
        .settingName = "texels per side",
        .errorName = "root mean square error",
        .errorUnit = "1/255",
        .reference = kNoiseReference};
    Result<NoisePicture> byDriver = NoisePicture::create(capabilities, NoiseShader::driverFilter, kNoiseSide);
    Result<NoisePicture> byShader = NoisePicture::create(capabilities, NoiseShader::shaderFilter, kNoiseSide);
    Result<NoisePicture> byFunction = NoisePicture::create(capabilities, NoiseShader::function, kNoiseSide);
    for (Result<NoisePicture>* each : {&byDriver, &byShader, &byFunction})
        if (!*each) return std::move(each->diagnostics);
    for (const int side : sidesOf(bench))
        for (const NoiseFormat format : kNoiseFormats) {
            const NoiseVolume volume(side, format, exact.of(side));
            Result<gpu::Texture> texture = volume.upload(capabilities);
            if (!texture) return std::move(texture.diagnostics);
            Result<Point> point = drawn(bench, *byDriver, &volume, &*texture);
            if (!point) return std::move(point.diagnostics);
            curveNamed(figure, fmt::format("driver's filter, {}", name(format))).points.push_back(*point);
            if (format != NoiseFormat::single) continue;
            point = drawn(bench, *byShader, &volume, &*texture);
            if (!point) return std::move(point.diagnostics);
            curveNamed(figure, "shader's filter, float").points.push_back(*point);
        }
    Result<Point> function = drawn(bench, *byFunction, nullptr, nullptr);
    if (!function) return std::move(function.diagnostics);
    curveNamed(figure, "function in the shader").points.push_back(*function);
    if (std::optional<std::vector<Point>> bytes = withByteFilter<filteredBytes>(bench, context))
        curveNamed(figure, "driver's filter in bytes, 8 bit, cut off").points = std::move(*bytes);
    compareDrawn(figure);
    return figure;
}

/// The largest error of any octave within half a texel of x = `middle`, in 255ths.
Result<double> strip(const NoisePicture& picture, const gpu::Texture& texture, gpu::Wrap wrap,
                     double middle) {
    const double half = .5 / texture.size().width;
    const NoisePlane plane{
        .corner = {middle - half, .1, .2}, .across = {2 * half, 0, 0}, .up = {0, .77, .61}};
    picture.draw(plane, &texture, wrap);
    Result<std::vector<float>> pixels = picture.pixels();
    if (!pixels) return std::move(pixels.diagnostics);
    double largest = 0;
    const float* found = pixels->data();
    for (int row = 0; row < picture.side(); ++row)
        for (int column = 0; column < picture.side(); ++column)
            for (const double wanted : exactNoise(picture.place(plane, column, row)))
                largest = std::max(largest, std::abs(*found++ - wanted));
    return kByte * largest;
}

Result<Figure> seam(const Bench& bench, const gpu::Capabilities& capabilities, ExactTexels& exact) {
    Figure figure{.name = "seam",
                  .title = "Noise texture of floats: within half a texel of the period's border",
                  .settingName = "texels per side",
                  .errorName = "largest error of an octave",
                  .errorUnit = "1/255",
                  .reference = kNoiseReference};
    Result<NoisePicture> picture =
        NoisePicture::create(capabilities, NoiseShader::driverFilter, kNoiseSide / 4);
    if (!picture) return std::move(picture.diagnostics);
    struct Wrapping {
        std::string_view name;
        gpu::Wrap wrap;
        double middle;
    };
    // The last texel of a row is n - 1; the border is between it and the first texel of the next period.
    for (const int side : sidesOf(bench)) {
        const NoiseVolume volume(side, NoiseFormat::single, exact.of(side));
        Result<gpu::Texture> texture = volume.upload(capabilities);
        if (!texture) return std::move(texture.diagnostics);
        const double border = 1 - .5 / side;
        for (const Wrapping& way : {Wrapping{"repeated", gpu::Wrap::repeat, border},
                                    Wrapping{"clamped to the edge", gpu::Wrap::clampToEdge, border},
                                    Wrapping{"mirrored", gpu::Wrap::mirroredRepeat, border},
                                    Wrapping{"repeated, in the middle", gpu::Wrap::repeat, .5 - .5 / side}}) {
            Result<double> error = strip(*picture, *texture, way.wrap, way.middle);
            if (!error) return std::move(error.diagnostics);
            curveNamed(figure, way.name)
                .points.push_back({.setting = static_cast<double>(side),
                                   .label = texelsLabel(side),
                                   .error = *error,
                                   .memory = volume.bytes()});
        }
    }
    const double inside = figure.curves[3].points.back().error;
    for (std::size_t i = 0; i < 3; ++i)
        figure.findings.push_back(fmt::format("{}: the border's error is {:.2f} times that of the middle",
                                              figure.curves[i].name,
                                              figure.curves[i].points.back().error / inside));
    return figure;
}

}  // namespace

Result<std::vector<Figure>> measureNoise(Bench& bench) {
    Result<gpu::Context*> context = bench.context();
    if (!context) return std::move(context.diagnostics);
    ExactTexels exact;
    std::vector<Figure> figures = onCpu(bench, exact);
    Result<Figure> device = onDevice(bench, **context, exact);
    if (!device) return std::move(device.diagnostics);
    figures.push_back(std::move(*device));
    Result<Figure> border = seam(bench, (*context)->capabilities(), exact);
    if (!border) return std::move(border.diagnostics);
    figures.push_back(std::move(*border));
    return figures;
}

}  // namespace glibra::bench
