#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "bench/core/device.h"
#include "bench/reference/coverage.h"
#include "bench/reference/pixel_filter.h"
#include "bench/subjects/subjects.h"
#include "embedded/bench_shaders.h"

namespace glibra::bench {
namespace {

constexpr int kSpokes = 17;
constexpr double kSquareWidth = .83, kSquareHeight = .61;  // pixels
constexpr double kOffset = .377;                           // squares

constexpr std::string_view kStarVertex = R"(layout(location = 0) in vec2 aPosition;
void main() { gl_Position = vec4(aPosition * 2. - 1., 0., 1.); }
)";
constexpr std::string_view kStarFragment = R"(out vec4 fColor;
void main() { fColor = vec4(1.); }
)";
// After stripes.glsl.
constexpr std::string_view kHardStep = "void main() { fColor = vec4(step(.5, fract(phase()))); }\n";
constexpr std::string_view kSmoothStep = R"(void main() {
    float p = phase(), width = length(vec2(dFdx(p), dFdy(p)));
    float fromMiddle = abs(fract(p - .25) - .5);
    fColor = vec4(1. - smoothstep(.25 - width / 2., .25 + width / 2., fromMiddle));
}
)";
constexpr std::string_view kAlongGradient = R"(void main() {
    float p = phase(), width = length(vec2(dFdx(p), dFdy(p)));
    fColor = vec4(.5 + (once(p + width / 2.) - once(p - width / 2.)) / width);
}
)";
constexpr std::string_view kOverSquare = R"(void main() {
    float p = phase(), a = abs(dFdx(p)), b = abs(dFdy(p)), s = (a + b) / 2., d = (a - b) / 2.;
    fColor = vec4(.5 + (twice(p + s) - twice(p + d) - twice(p - d) + twice(p - s)) / (a * b));
}
)";

/// Corners in 0..1; (0, 0) is at the lower left.
std::vector<glm::vec2> star() {
    std::vector<glm::vec2> corners;
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
        const double angle = (spoke + .13) * 2 * std::numbers::pi / kSpokes;
        for (const auto& [turn, radius] : {std::pair(0., .05), {-.08, .47}, {.08, .47}})
            corners.emplace_back(.5 + radius * std::cos(angle + turn), .5 + radius * std::sin(angle + turn));
    }
    return corners;
}

std::vector<double> starCoverage(int side) {
    const std::vector<glm::vec2> corners = star();
    std::vector<FlatTriangle> triangles(kSpokes);
    for (std::size_t i = 0; i < corners.size(); ++i)
        triangles[i / 3][i % 3] = {static_cast<double>(corners[i].x) * side,
                                   (1. - static_cast<double>(corners[i].y)) * side};
    return coverage(triangles, side, side);
}

/// The mean over from..to of a wave that is 1 in even cells of length 1 and -1 in odd ones.
double meanOfWave(double from, double to) {
    const auto integral = [](double t) {
        const double inPeriod = t - 2 * std::floor(t / 2);
        return inPeriod < 1 ? inPeriod : 2 - inPeriod;
    };
    return (integral(to) - integral(from)) / (to - from);
}

std::vector<double> checkerMeans(int side) {
    const auto along = [](int pixel, double size) {
        return meanOfWave(pixel / size + kOffset, (pixel + 1) / size + kOffset);
    };
    std::vector<double> means;
    for (int row = side - 1; row >= 0; --row)
        for (int column = 0; column < side; ++column)
            means.push_back(.5 - .5 * along(column, kSquareWidth) * along(row, kSquareHeight));
    return means;
}

/// A black and white pattern that is hard to sample.
struct Pattern {
    std::string_view name, title;
    /// Exact integrals over the pixels of a side x side picture, rows from the top; null if there is no
    /// closed form.
    std::vector<double> (*exact)(int side) = nullptr;
    /// Ways of drawing it; the first draws the pattern itself, sampled at points.
    std::vector<std::pair<std::string_view, Shader>> ways;
    std::shared_ptr<const Vertices> triangles{};  ///< null: the programs cover the whole target

    /// One grey value per sample: the picture of side x side pixels on a canvas of any multiple.
    [[nodiscard]] std::vector<float> drawn(const Canvas& canvas, int side, std::size_t way = 0) const {
        canvas.clear();
        const Shader& shader = ways[way].second.set("uSide", 1. * side);
        triangles ? triangles->draw(shader) : shader.draw();
        return canvas.pixels(1);
    }
};

/// A pattern, and its reference for each filter: the exact integral if it has one, otherwise very many
/// samples.
struct MeasuredPattern {
    Bench& bench;
    const Pattern& pattern;
    int side;
    std::array<std::vector<double>, 5> references{};

    /// Adds a point for each density to a curve.
    void addSampled(Figure& figure, const std::string& curve, std::size_t way, std::size_t filter,
                    std::span<const int> factors, int samples) const {
        for (const int factor : factors) {
            const Canvas canvas(bench, side * factor, side * factor, gpu::TexelFormat::r32f, samples);
            std::vector<double> reduced;
            const Timing time = bench.time([&] {
                reduced =
                    reduce(pattern.drawn(canvas, side, way), side, side, factor, kPixelFilters.at(filter));
            });
            const double perPixel = factor * factor * canvas.samples();
            Curve& to = curveNamed(figure, curve);
            // A driver may have more samples than requested, but not this number.
            if (!to.points.empty() && to.points.back().setting >= perPixel) continue;
            to.points.push_back(
                {perPixel,
                 samples > 1 ? fmt::format("MSAA {}", canvas.samples()) : fmt::format("{0} x {0}", factor),
                 kByte * rootMeanSquare(reduced, references.at(filter)), time, canvas.bytes()});
        }
    }
};

std::string boxCurve(std::string_view way) {
    return fmt::format("{}{}supersampling, box", way, way.empty() ? "" : ", ");
}

void compareMultisampling(Figure& figure, const std::string& box) {
    const Curve& multi = figure.curves.front();
    const Point &most = multi.points.back(), &one = multi.points.front();
    figure.note("{} leaves {:.0f} % of the error of one sample in {:.2f} times its time", most.label,
                100 * most.error / one.error, most.time->median / one.time->median);
    for (const Point& same : curveNamed(figure, box).points)
        if (same.setting == most.setting)
            figure.note("{} has {:.2f} times the error of {} ({}) in {:.2f} times its time", most.label,
                        most.error / same.error, box, same.label, most.time->median / same.time->median);
}

void compareWays(Figure& figure, const Pattern& pattern) {
    const std::string_view plain = pattern.ways.front().first;
    const std::vector<Point> steps = curveNamed(figure, boxCurve(plain)).points;
    for (std::size_t i = 1; i < pattern.ways.size(); ++i) {
        const std::string_view way = pattern.ways[i].first;
        const double one = curveNamed(figure, boxCurve(way)).points.front().error;
        const auto enough = std::ranges::find_if(steps, [&](const Point& each) { return each.error <= one; });
        if (enough != steps.end())
            figure.note("one sample of the {} is as good as {} samples of the {}", way, enough->setting,
                        plain);
        else
            figure.note("one sample of the {} is better than {} samples of the {}", way, steps.back().setting,
                        plain);
    }
}

Figure patternFigure(Bench& bench, const Pattern& pattern) {
    constexpr int kDense = 32;
    const std::vector<int> factors = bench.pick(std::vector{1, 2, 4}, std::vector{1, 2, 3, 4, 6, 8});
    MeasuredPattern measured{bench, pattern, bench.pick(64, 128)};
    const int side = measured.side;
    Figure figure{.name = std::string(pattern.name),
                  .title = fmt::format("{}, {} x {} pixels", pattern.title, side, side),
                  .settingName = "samples per pixel",
                  .errorName = "root mean square error",
                  .errorUnit = "1/255",
                  .reference = pattern.exact
                                   ? "box: the exact integral over each pixel, in double; other filters: the "
                                     "same filter over 32 x 32 samples"
                                   : "the same filter over 32 x 32 samples of the pattern itself"};
    const std::vector<float> many =
        pattern.drawn(Canvas(bench, side * kDense, side * kDense, gpu::TexelFormat::r32f), side);
    for (std::size_t i = 0; i < kPixelFilters.size(); ++i)
        measured.references.at(i) = reduce(many, side, side, kDense, kPixelFilters.at(i));
    if (pattern.exact) {
        std::vector<double> exact = pattern.exact(side);
        figure.note("32 x 32 samples are within {} / 255 of the exact integral",
                    numberText(kByte * rootMeanSquare(measured.references[0], exact)));
        measured.references[0] = std::move(exact);
    }
    for (const int samples : {1, 2, 4, 8, 16})
        if (samples <= bench.capabilities().maxSamples)
            measured.addSampled(figure, "multisampling (MSAA), box", 0, 0, std::array{1}, samples);
    const std::string_view plain = pattern.ways.front().first;
    for (std::size_t i = 0; i < kPixelFilters.size(); ++i) {
        const std::string name =
            fmt::format("{}{}supersampling, {}", plain, plain.empty() ? "" : ", ", kPixelFilters.at(i).name);
        measured.addSampled(figure, name, 0, i, factors, 1);
        figure.findings.push_back(orderSentence(figure.curves.back(), "samples"));
    }
    for (std::size_t i = 1; i < pattern.ways.size(); ++i)
        measured.addSampled(figure, boxCurve(pattern.ways[i].first), i, 0, factors, 1);
    compareMultisampling(figure, boxCurve(plain));
    compareWays(figure, pattern);
    return figure;
}

std::vector<Pattern> patterns(Bench& bench) {
    const auto stripes = [&](std::string_view main) {
        return Shader(bench, fmt::format("{}{}", bench_shaders::stripes_glsl(), main));
    };
    const std::vector<glm::vec2> corners = star();
    const std::vector<Vertices::Values> positions{{{&corners.front().x, 2 * corners.size()}, 2}};
    return {{"edges",
             "A star of 17 narrow triangles",
             starCoverage,
             {{"", Shader(bench, kStarVertex, kStarFragment)}},
             std::make_shared<const Vertices>(positions)},
            {"checkerboard",
             "A checkerboard of .83 x .61 pixels per square",
             checkerMeans,
             {{"", Shader(bench, bench_shaders::checker_frag())}}},
            {"checkerboard-plane",
             "A checkerboard on a plane in perspective",
             nullptr,
             {{"", Shader(bench, bench_shaders::checker_plane_frag())}}},
            {"stripes",
             "Stripes of 24 to 1.3 pixels per period",
             nullptr,
             {{"step", stripes(kHardStep)},
              {"smooth step", stripes(kSmoothStep)},
              {"integral along the gradient", stripes(kAlongGradient)},
              {"integral over the pixel", stripes(kOverSquare)}}}};
}

}  // namespace

std::vector<Figure> measureAntialiasing(Bench& bench) {
    std::vector<Figure> figures;
    for (const Pattern& pattern : patterns(bench)) figures.push_back(patternFigure(bench, pattern));
    return figures;
}

}  // namespace glibra::bench
