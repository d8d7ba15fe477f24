#include "bench/subjects/antialiasing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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
constexpr std::string_view kPatternHead = R"(in vec2 vPlace;
uniform float uSide;
out vec4 fColor;
)";
constexpr std::string_view kChecker = R"(void main() {
    ivec2 square = ivec2(floor(vPlace * uSide / vec2(.83, .61) + .377));
    fColor = vec4(float((square.x + square.y) & 1));
}
)";
constexpr std::string_view kCheckerPlane = R"(void main() {
    float distance = 1. / (1.1 - vPlace.y);
    vec2 place = vec2((vPlace.x - .4) * distance, distance) * uSide / 12.;
    ivec2 square = ivec2(floor(place + .377));
    fColor = vec4(float((square.x + square.y) & 1));
}
)";
// Periods decrease from 24 to 1.3 pixels along the direction of 20 degrees. With q(t) = -1/2 for fract(t) <
// 1/2 and 1/2 above, `once` is the integral of q and `twice` that of `once`; both are periodic.
constexpr std::string_view kStripes = R"(float once(float t) { return .5 * abs(fract(t) - .5) - .125; }
float twice(float t) {
    float u = fract(t), v = u - .5;
    return u < .5 ? .125 * u - .25 * u * u : .25 * v * v - .125 * v;
}
float phase() {
    const vec2 direction = vec2(.93969, .34202);
    float size = direction.x + direction.y;
    float t = dot(vPlace, direction) / size;
    return uSide * size * (t / 24. + .5 * (1. / 1.3 - 1. / 24.) * t * t);
}
)";
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

using Polygon = std::vector<glm::dvec2>;

/// The part on one side of a line along an axis: coordinate >= border, or <= border if `isUpper`.
Polygon cut(const Polygon& polygon, int axis, double border, bool isUpper) {
    Polygon kept;
    const auto depth = [&](const glm::dvec2& point) {
        return isUpper ? border - point[axis] : point[axis] - border;
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double a = depth(from), b = depth(to);
        if (a >= 0) kept.push_back(from);
        if ((a > 0 && b < 0) || (a < 0 && b > 0)) kept.push_back(from + (to - from) * (a / (a - b)));
    }
    return kept;
}

double area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return std::abs(twice) / 2;
}

int limitedPixel(double value, int most) {
    return static_cast<int>(std::clamp(value, 0., static_cast<double>(most)));
}

double sinc(double x) {
    const double angle = std::numbers::pi * x;
    return std::abs(angle) < 1e-9 ? 1 : std::sin(angle) / angle;
}

double mitchell(double x) {
    if (x < 1) return (7 * x * x * x - 12 * x * x + 16. / 3) / 6;
    return ((-7. / 3) * x * x * x + 12 * x * x - 20 * x + 32. / 3) / 6;
}

constexpr std::array<PixelFilter, 5> kFilters{
    {{"box", .5, [](double) { return 1.; }},
     {"tent", 1, [](double x) { return 1 - x; }},
     {"Gaussian", 1.5, [](double x) { return std::exp(-2 * x * x); }},
     {"Mitchell", 2, mitchell},
     {"Lanczos 2", 2, [](double x) { return sinc(x) * sinc(x / 2); }}}};

/// The samples along one axis that contribute to one pixel.
struct Taps {
    std::size_t first = 0;
    std::vector<double> weights;
};

std::vector<Taps> tapsOf(int pixels, int factor, const PixelFilter& filter) {
    std::vector<Taps> all;
    for (int pixel = 0; pixel < pixels; ++pixel) {
        const double centre = pixel + .5;
        const int first = std::max(0, static_cast<int>(std::floor((centre - filter.radius) * factor)));
        const int end =
            std::min(pixels * factor, static_cast<int>(std::ceil((centre + filter.radius) * factor)));
        Taps& taps = all.emplace_back(Taps{static_cast<std::size_t>(first), {}});
        double sum = 0;
        for (int i = first; i < end; ++i) {
            taps.weights.push_back(filter.weight((i + .5) / factor - centre));
            sum += taps.weights.back();
        }
        for (double& each : taps.weights) each /= sum;
    }
    return all;
}

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
                reduced = reduce(pattern.drawn(canvas, side, way), side, side, factor, kFilters.at(filter));
            });
            const double perPixel = factor * factor * canvas.samples();
            Curve& to = curveNamed(figure, curve);
            // A driver may have more samples than requested, but not this number.
            if (!to.points.empty() && to.points.back().setting >= perPixel) continue;
            to.points.push_back(
                {perPixel,
                 samples > 1 ? fmt::format("MSAA {}", canvas.samples()) : fmt::format("{0} x {0}", factor),
                 errorInBytes(reduced, references.at(filter)), time, canvas.bytes()});
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
    for (std::size_t i = 0; i < kFilters.size(); ++i)
        measured.references.at(i) = reduce(many, side, side, kDense, kFilters.at(i));
    if (pattern.exact) {
        std::vector<double> exact = pattern.exact(side);
        figure.note("32 x 32 samples are within {} / 255 of the exact integral",
                    numberText(errorInBytes(measured.references[0], exact)));
        measured.references[0] = std::move(exact);
    }
    for (const int samples : {1, 2, 4, 8, 16})
        if (samples <= bench.capabilities().maxSamples)
            measured.addSampled(figure, "multisampling (MSAA), box", 0, 0, std::array{1}, samples);
    const std::string_view plain = pattern.ways.front().first;
    for (std::size_t i = 0; i < kFilters.size(); ++i) {
        const std::string name =
            fmt::format("{}{}supersampling, {}", plain, plain.empty() ? "" : ", ", kFilters.at(i).name);
        measured.addSampled(figure, name, 0, i, factors, 1);
        figure.findings.push_back(orderSentence(figure.curves.back(), "samples"));
    }
    for (std::size_t i = 1; i < pattern.ways.size(); ++i)
        measured.addSampled(figure, boxCurve(pattern.ways[i].first), i, 0, factors, 1);
    compareMultisampling(figure, boxCurve(plain));
    compareWays(figure, pattern);
    return figure;
}

}  // namespace

std::vector<double> coverage(std::span<const FlatTriangle> triangles, int width, int height) {
    std::vector<double> shares(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.);
    for (const FlatTriangle& triangle : triangles) {
        const auto [left, right] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
        const auto [top, bottom] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
        const Polygon whole(triangle.begin(), triangle.end());
        for (int y = limitedPixel(top, height); y < limitedPixel(std::ceil(bottom), height); ++y) {
            const Polygon row = cut(cut(whole, 1, y, false), 1, y + 1, true);
            for (int x = limitedPixel(left, width); x < limitedPixel(std::ceil(right), width); ++x)
                shares[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x)] += area(cut(cut(row, 0, x, false), 0, x + 1, true));
        }
    }
    return shares;
}

double PixelFilter::weight(double x) const {
    x = std::abs(x);
    return x > radius ? 0 : inside(x);
}

std::span<const PixelFilter, 5> pixelFilters() {
    return kFilters;
}

std::vector<double> reduce(std::span<const float> samples, int width, int height, int factor,
                           const PixelFilter& filter) {
    const std::vector<Taps> across = tapsOf(width, factor, filter), down = tapsOf(height, factor, filter);
    const std::size_t columns = across.size(), sampleColumns = columns * static_cast<std::size_t>(factor);
    std::vector<double> narrow(samples.size() / sampleColumns * columns);
    for (std::size_t i = 0; i < narrow.size(); ++i) {
        const Taps& taps = across[i % columns];
        const float* from = samples.data() + i / columns * sampleColumns + taps.first;
        for (std::size_t k = 0; k < taps.weights.size(); ++k) narrow[i] += taps.weights[k] * from[k];
    }
    std::vector<double> pixels(down.size() * columns, 0.);
    for (std::size_t row = 0; row < down.size(); ++row)
        for (std::size_t i = 0; i < down[row].weights.size(); ++i)
            for (std::size_t column = 0; column < columns; ++column)
                pixels[row * columns + column] +=
                    down[row].weights[i] * narrow[(down[row].first + i) * columns + column];
    return pixels;
}

double errorInBytes(std::span<const double> picture, std::span<const double> reference) {
    double sum = 0;
    for (std::size_t i = 0; i < picture.size(); ++i)
        sum += (picture[i] - reference[i]) * (picture[i] - reference[i]);
    return kByte * std::sqrt(sum / static_cast<double>(picture.size()));
}

std::vector<float> Pattern::drawn(const Canvas& canvas, int side, std::size_t way) const {
    canvas.clear();
    const Shader& shader = ways[way].second.set("uSide", 1. * side);
    triangles ? triangles->draw(shader) : shader.draw();
    return canvas.pixels(1);
}

std::vector<Pattern> patterns(Bench& bench) {
    const auto shader = [&](std::string_view functions, std::string_view main = {}) {
        return Shader(bench, fmt::format("{}{}{}", kPatternHead, functions, main));
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
             {{"", shader(kChecker)}}},
            {"checkerboard-plane",
             "A checkerboard on a plane in perspective",
             nullptr,
             {{"", shader(kCheckerPlane)}}},
            {"stripes",
             "Stripes of 24 to 1.3 pixels per period",
             nullptr,
             {{"step", shader(kStripes, kHardStep)},
              {"smooth step", shader(kStripes, kSmoothStep)},
              {"integral along the gradient", shader(kStripes, kAlongGradient)},
              {"integral over the pixel", shader(kStripes, kOverSquare)}}}};
}

std::vector<Figure> measureAntialiasing(Bench& bench) {
    std::vector<Figure> figures;
    for (const Pattern& pattern : patterns(bench)) figures.push_back(patternFigure(bench, pattern));
    return figures;
}

}  // namespace glibra::bench
