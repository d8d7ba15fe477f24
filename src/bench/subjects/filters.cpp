#include <fmt/format.h>

#include <array>
#include <functional>
#include <string>

#include "bench/core/fit.h"
#include "bench/draw/filter_passes.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

constexpr double kBytes = 255;  ///< errors are in steps of a byte

/// A way to filter: its passes for a setting, and the format of the texels between them.
struct FilterMethod {
    std::string name;
    std::function<std::vector<std::string>(int setting)> fragments;
    gpu::TexelFormat between = gpu::TexelFormat::rgba32f;
};

struct Format {
    gpu::TexelFormat format;
    std::string_view name;
};
constexpr std::array<Format, 4> kFormats{{{gpu::TexelFormat::rgba32f, "float"},
                                          {gpu::TexelFormat::rgba16f, "half float"},
                                          {gpu::TexelFormat::rgba16, "16 bit"},
                                          {gpu::TexelFormat::rgba8, "8 bit"}}};

struct MeasuredFilter {
    Point point;
    double shift = 0;  ///< mean of the signed differences, in 255ths
};

double meanDifference(const Plane& a, const Plane& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) sum += a.values[i] - b.values[i];
    return sum / static_cast<double>(a.values.size());
}

Result<MeasuredFilter> measureFilter(Bench& bench, const gpu::Capabilities& capabilities,
                                     const Plane& picture, const FilterMethod& method, int setting,
                                     const Plane& wanted) {
    const Result<FilterChain> chain =
        FilterChain::create(capabilities, picture, method.fragments(setting), method.between);
    if (!chain) return chain.diagnostics;
    const Timing time = bench.time([&] {
        chain->draw();
        glFinish();
    });
    const Result<Plane> drawn = chain->result(capabilities);
    if (!drawn) return drawn.diagnostics;
    return MeasuredFilter{.point = {.setting = static_cast<double>(setting),
                                    .label = {},
                                    .error = rootMeanSquare(*drawn, wanted) * kBytes,
                                    .time = time,
                                    .memory = chain->bytesBetween()},
                          .shift = meanDifference(*drawn, wanted) * kBytes};
}

std::vector<FilterMethod> blurMethods() {
    const auto separable = [](int radius) {
        const std::vector<double> weights = gaussianWeights(radius);
        return std::vector<std::string>{blurAlong(weights, false), blurAlong(weights, true)};
    };
    const auto paired = [](int radius) {
        const std::vector<double> weights = gaussianWeights(radius);
        return std::vector<std::string>{pairedBlurAlong(weights, false), pairedBlurAlong(weights, true)};
    };
    std::vector<FilterMethod> methods{
        {"direct", [](int radius) { return std::vector<std::string>{directBlur(gaussianWeights(radius))}; }}};
    for (const Format& each : kFormats)
        methods.push_back({fmt::format("separable, {} between", each.name), separable, each.format});
    methods.push_back({"separable in pairs, float between", paired, gpu::TexelFormat::rgba32f});
    methods.push_back({"separable in pairs, 8 bit between", paired, gpu::TexelFormat::rgba8});
    return methods;
}

Result<Figure> blurFigure(Bench& bench, const gpu::Capabilities& capabilities) {
    Figure figure{.name = "blur",
                  .title = "Gaussian blur: direct and separable, by the texels between the passes",
                  .settingName = "radius, pixels",
                  .errorName = "root mean square",
                  .errorUnit = "1/255",
                  .reference = "the sum over the square of pixels in double on the CPU",
                  .alternatives = Alternatives::setting};
    const Plane picture = testPicture(bench.isQuick() ? 64 : 256);
    const std::vector<int> radii =
        bench.isQuick() ? std::vector<int>{1, 2, 4, 8} : std::vector<int>{1, 2, 4, 8, 16};
    std::vector<Plane> wanted;
    wanted.reserve(radii.size());
    for (const int radius : radii) wanted.push_back(blurred(picture, gaussianWeights(radius)));
    for (const FilterMethod& method : blurMethods()) {
        Curve curve{.name = method.name};
        for (std::size_t i = 0; i < radii.size(); ++i) {
            Result<MeasuredFilter> measured =
                measureFilter(bench, capabilities, picture, method, radii[i], wanted[i]);
            if (!measured) return std::move(measured.diagnostics);
            measured->point.label = fmt::format("radius {}", radii[i]);
            curve.points.push_back(std::move(measured->point));
        }
        figure.curves.push_back(std::move(curve));
    }
    const auto& last = [&](std::size_t curve) -> const Point& { return figure.curves[curve].points.back(); };
    figure.findings.push_back(fmt::format(
        "radius {}: separable takes {:.2f} of the time of direct, in pairs {:.2f}", radii.back(),
        last(1).time->median / last(0).time->median, last(5).time->median / last(0).time->median));
    for (std::size_t i = 1; i < figure.curves.size(); ++i)
        figure.findings.push_back(fmt::format("{}: {} of a byte's step at radius {}", figure.curves[i].name,
                                              numberText(last(i).error), radii.back()));
    return figure;
}

Result<Figure> repeatedFigure(Bench& bench, const gpu::Capabilities& capabilities) {
    Figure figure{.name = "repeated",
                  .title = "Repeated blur of radius 2: the error from the texels between the passes",
                  .settingName = "blurs",
                  .errorName = "root mean square",
                  .errorUnit = "1/255",
                  .reference = "as many sums over the square of pixels in double on the CPU",
                  .alternatives = Alternatives::setting};
    const Plane picture = testPicture(bench.isQuick() ? 64 : 256);
    const int most = bench.isQuick() ? 8 : 32;
    const std::vector<double> weights = gaussianWeights(2);
    std::vector<Plane> wanted;
    Plane plane = picture;
    for (int count = 1, next = 1; count <= most; ++count) {
        plane = blurred(plane, weights);
        if (count != next) continue;
        wanted.push_back(plane);
        next *= 2;
    }
    for (const Format& format : kFormats) {
        const FilterMethod method{std::string(format.name),
                                  [&](int count) {
                                      std::vector<std::string> passes;
                                      for (int i = 0; i < count; ++i) {
                                          passes.push_back(blurAlong(weights, false));
                                          passes.push_back(blurAlong(weights, true));
                                      }
                                      return passes;
                                  },
                                  format.format};
        Curve curve{.name = fmt::format("{} between", format.name)};
        std::size_t at = 0;
        double shift = 0;
        for (int count = 1; count <= most; count *= 2) {
            Result<MeasuredFilter> measured =
                measureFilter(bench, capabilities, picture, method, count, wanted[at++]);
            if (!measured) return std::move(measured.diagnostics);
            measured->point.label = fmt::format("{} blurs", count);
            shift = measured->shift;
            curve.points.push_back(std::move(measured->point));
        }
        figure.findings.push_back(fmt::format(
            "{}: {} of a byte's step after 1 blur, {} after {}, of the mean {:+.2g}", curve.name,
            numberText(curve.points.front().error), numberText(curve.points.back().error), most, shift));
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

Result<Figure> sobelFigure(Bench& bench, const gpu::Capabilities& capabilities) {
    Figure figure{.name = "sobel",
                  .title = "Sobel gradient: direct and separable, by the texels between the passes",
                  .settingName = "side of the picture, pixels",
                  .errorName = "root mean square of the gradient's length",
                  .errorUnit = "1/255",
                  .reference = "the 3 x 3 kernels in double on the CPU",
                  .alternatives = Alternatives::setting};
    std::vector<FilterMethod> methods{
        {"direct", [](int) { return std::vector<std::string>{directSobel()}; }}};
    for (const Format& each : kFormats) {
        // Normalised texels hold 0..1. The smoothed column is in 0..4, its difference in -1..1.
        const bool isFloat = gpu::isFloat(each.format);
        const double scale = isFloat ? 1 : 1. / 5, bias = isFloat ? 0 : 1. / 5;
        methods.push_back(
            {fmt::format("separable, {} between", each.name),
             [=](int) { return std::vector<std::string>{sobelColumns(scale, bias), sobelRows(scale, bias)}; },
             each.format});
    }
    const std::vector<int> sides =
        bench.isQuick() ? std::vector<int>{64, 128} : std::vector<int>{128, 256, 512, 1024};
    for (const FilterMethod& method : methods) {
        Curve curve{.name = method.name};
        for (const int side : sides) {
            const Plane picture = testPicture(side);
            Result<MeasuredFilter> measured =
                measureFilter(bench, capabilities, picture, method, side, sobel(picture));
            if (!measured) return std::move(measured.diagnostics);
            measured->point.label = fmt::format("{0} x {0}", side);
            curve.points.push_back(std::move(measured->point));
        }
        figure.curves.push_back(std::move(curve));
    }
    const Point& direct = figure.curves.front().points.back();
    for (std::size_t i = 1; i < figure.curves.size(); ++i) {
        const Point& each = figure.curves[i].points.back();
        figure.findings.push_back(fmt::format(
            "{}: {:.2f} of the time of direct, {} of a byte's step instead of {}", figure.curves[i].name,
            each.time->median / direct.time->median, numberText(each.error), numberText(direct.error)));
    }
    return figure;
}

}  // namespace

Result<std::vector<Figure>> measureFilters(Bench& bench) {
    const Result<gpu::Context*> context = bench.context();
    if (!context) return context.diagnostics;
    return measureEach({blurFigure, repeatedFigure, sobelFigure}, bench, (*context)->capabilities());
}

}  // namespace glibra::bench
