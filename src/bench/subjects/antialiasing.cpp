#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "bench/core/fit.h"
#include "bench/draw/offscreen.h"
#include "bench/draw/patterns.h"
#include "bench/reference/pixel_filter.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

constexpr int kPatternFactor = 32;
constexpr std::array kFactors{1, 2, 3, 4, 6, 8};
constexpr std::array kSamples{1, 2, 4, 8, 16};
constexpr auto kSampleFormat = gpu::TexelFormat::r32f;

/// One grey value per sample, rows from the top.
using Samples = std::vector<float>;

/// Draws one pattern at any density; there is one target per density.
class PatternPicture {
  public:
    PatternPicture(const gpu::Capabilities& capabilities, const Pattern& pattern, int side)
        : capabilities_(&capabilities), pattern_(&pattern), side_(side) {}

    [[nodiscard]] int side() const { return side_; }

    /// The target of factor x factor pixels per final pixel with that many samples each.
    Result<gpu::Target> target(int factor, int samples) const {
        return gpu::Target::window(*capabilities_, side_ * factor, side_ * factor, kSampleFormat, samples);
    }
    Result<Samples> draw(const gpu::Target& target, const PatternProgram& program) const {
        target.bind();
        target.clearColor(0, {});
        pattern_->draw(program, side_);
        return readFloats(*capabilities_, target, 1);
    }

  private:
    const gpu::Capabilities* capabilities_;
    const Pattern* pattern_;
    int side_;
};

/// References by filter: the exact integral of the pattern if it has one, otherwise very many samples.
using References = std::map<PixelFilter, std::vector<double>>;

struct Setup {
    const Bench& bench;
    const PatternPicture& picture;
    const References& references;
};

Result<Point> measureSamples(const Setup& setup, const PatternProgram& program, int factor, int samples,
                             PixelFilter filter) {
    const int side = setup.picture.side();
    Result<gpu::Target> target = setup.picture.target(factor, samples);
    if (!target) return std::move(target.diagnostics);
    Diagnostics problems;
    std::vector<double> reduced;
    const Timing timing = setup.bench.time([&] {
        Result<Samples> drawn = setup.picture.draw(*target, program);
        if (drawn)
            reduced = reduce(*drawn, side, side, factor, filter);
        else
            problems = std::move(drawn.diagnostics);
    });
    if (!problems.empty()) return problems;
    const int perPixel = factor * factor * target->samples();
    return Point{
        .setting = static_cast<double>(perPixel),
        .label = samples > 1 ? fmt::format("MSAA {}", target->samples()) : fmt::format("{0} x {0}", factor),
        .error = errorInBytes(reduced, setup.references.at(filter)),
        .time = timing,
        .memory = static_cast<double>(gpu::bytesPerTexel(kSampleFormat)) * perPixel * side * side};
}

Result<Curve> supersampled(const Setup& setup, const PatternProgram& program, PixelFilter filter) {
    std::string curveName = fmt::format("supersampling, {}", name(filter));
    if (!program.name.empty()) curveName = fmt::format("{}, {}", program.name, curveName);
    Curve curve{.name = std::move(curveName)};
    for (const int factor : kFactors) {
        if (setup.bench.isQuick() && factor != 1 && factor != 2 && factor != 4) continue;
        Result<Point> point = measureSamples(setup, program, factor, 1, filter);
        if (!point) return std::move(point.diagnostics);
        curve.points.push_back(std::move(*point));
    }
    return curve;
}

Result<Curve> multisampled(const Setup& setup, const PatternProgram& program, int mostSamples) {
    Curve curve{.name = "multisampling (MSAA), box"};
    for (const int samples : kSamples) {
        if (samples > mostSamples) break;
        Result<Point> point = measureSamples(setup, program, 1, samples, PixelFilter::box);
        if (!point) return std::move(point.diagnostics);
        // A driver may have more samples than requested, but not this number.
        if (curve.points.empty() || curve.points.back().setting < point->setting)
            curve.points.push_back(std::move(*point));
    }
    return curve;
}

const Point* pointAt(const Figure& figure, std::string_view curve, double setting) {
    for (const Curve& each : figure.curves)
        if (each.name == curve)
            for (const Point& point : each.points)
                if (point.setting == setting) return &point;
    return nullptr;
}

void compareMultisampling(Figure& figure) {
    const Curve& curve = figure.curves.front();
    const Point& most = curve.points.back();
    const Point& one = curve.points.front();
    figure.findings.push_back(
        fmt::format("{} leaves {:.0f} % of the error of one sample in {:.2f} times its time", most.label,
                    100 * most.error / one.error, most.time->median / one.time->median));
    for (const Curve& each : figure.curves) {
        if (&each == &curve) continue;
        const Point* same = pointAt(figure, each.name, most.setting);
        if (!same || !each.name.ends_with("box")) continue;
        figure.findings.push_back(fmt::format(
            "{} has {:.2f} times the error of {} ({}) in {:.2f} times its time", most.label,
            most.error / same->error, each.name, same->label, most.time->median / same->time->median));
        break;
    }
}

void compareWays(Figure& figure, const Pattern& pattern) {
    for (const PatternProgram& way : pattern.programs) {
        if (&way == &pattern.programs.front()) continue;
        const Point* one = pointAt(figure, fmt::format("{}, supersampling, box", way.name), 1);
        const Curve* steps = nullptr;
        for (const Curve& each : figure.curves)
            if (each.name == fmt::format("{}, supersampling, box", pattern.programs.front().name))
                steps = &each;
        if (!one || !steps) continue;
        double needed = 0;
        for (const Point& point : steps->points)
            if (needed == 0 && point.error <= one->error) needed = point.setting;
        figure.findings.push_back(
            needed > 0 ? fmt::format("one sample of the {} is as good as {} samples of the {}", way.name,
                                     needed, pattern.programs.front().name)
                       : fmt::format("one sample of the {} is better than {} samples of the {}", way.name,
                                     steps->points.back().setting, pattern.programs.front().name));
    }
}

Result<Figure> measurePattern(const Bench& bench, const gpu::Capabilities& capabilities,
                              const Pattern& pattern) {
    const int side = bench.isQuick() ? 64 : 128;
    Figure figure{.name = std::string(pattern.name),
                  .title = fmt::format("{}, {} x {} pixels", pattern.title, side, side),
                  .settingName = "samples per pixel",
                  .errorName = "root mean square error",
                  .errorUnit = "1/255",
                  .reference = pattern.exact
                                   ? "box: the exact integral over each pixel, in double; other filters: the "
                                     "same filter over 32 x 32 samples"
                                   : "the same filter over 32 x 32 samples of the pattern itself"};
    const PatternPicture picture(capabilities, pattern, side);
    Result<gpu::Target> dense = picture.target(kPatternFactor, 1);
    if (!dense) return std::move(dense.diagnostics);
    Result<Samples> many = picture.draw(*dense, pattern.programs.front());
    if (!many) return std::move(many.diagnostics);
    References references;
    for (const PixelFilter filter : kPixelFilters)
        references[filter] = reduce(*many, side, side, kPatternFactor, filter);
    if (pattern.exact) {
        std::vector<double> exact = pattern.exact(side);
        figure.findings.push_back(fmt::format("32 x 32 samples are within {} / 255 of the exact integral",
                                              numberText(errorInBytes(references[PixelFilter::box], exact))));
        references[PixelFilter::box] = std::move(exact);
    }

    const Setup setup{bench, picture, references};
    Result<Curve> multi = multisampled(setup, pattern.programs.front(), capabilities.maxSamples);
    if (!multi) return std::move(multi.diagnostics);
    figure.curves.push_back(std::move(*multi));
    for (const PixelFilter filter : kPixelFilters) {
        Result<Curve> curve = supersampled(setup, pattern.programs.front(), filter);
        if (!curve) return std::move(curve.diagnostics);
        figure.findings.push_back(orderSentence(*curve, "samples"));
        figure.curves.push_back(std::move(*curve));
    }
    for (std::size_t i = 1; i < pattern.programs.size(); ++i) {
        Result<Curve> curve = supersampled(setup, pattern.programs[i], PixelFilter::box);
        if (!curve) return std::move(curve.diagnostics);
        figure.curves.push_back(std::move(*curve));
    }
    compareMultisampling(figure);
    compareWays(figure, pattern);
    return figure;
}

}  // namespace

Result<std::vector<Figure>> measureAntialiasing(Bench& bench) {
    Result<gpu::Context*> context = bench.context();
    if (!context) return std::move(context.diagnostics);
    const gpu::Capabilities& capabilities = (*context)->capabilities();
    Result<std::vector<Pattern>> all = patterns(capabilities);
    if (!all) return std::move(all.diagnostics);
    std::vector<Figure> figures;
    for (const Pattern& pattern : *all) {
        Result<Figure> figure = measurePattern(bench, capabilities, pattern);
        if (!figure) return std::move(figure.diagnostics);
        figures.push_back(std::move(*figure));
    }
    return figures;
}

}  // namespace glibra::bench
