#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "bench/core/device.h"
#include "bench/core/run.h"
#include "bench/reference/filtering.h"
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

namespace {

constexpr int kCardFactor = 16;
constexpr const char* kCardReference =
    "16 x 16 bilinear samples per pixel of the texture itself, in double on the CPU";

/// The mapping of the picture to the texture: a plane in perspective, or one seen from the front.
struct CardView {
    bool isPlane = true;
    double texels = 1;  ///< plane: texels per unit of its width and depth; front: texels across the picture
    glm::dvec2 start{.3, .7};  ///< texels
};

/// The texels at a place of the picture, 0..1 from the lower left. shaders/card.frag computes the same in
/// float.
glm::dvec2 texelsAt(const CardView& view, const glm::dvec2& place) {
    if (!view.isPlane) return view.start + view.texels * place;
    const double depth = 1 / (1.1 - place.y);
    return view.start + view.texels * glm::dvec2((place.x - .5) * depth, depth);
}

/// A way of reading a texture, and the largest number of texels that one pixel reads.
struct Filter {
    std::string_view curve;
    std::string label;
    base::Filter filter = base::Filter::linear;
    double reads = 4;
    double anisotropy = 1;
    int factor = 1;  ///< supersampling: factor x factor samples per pixel
};

std::vector<Filter> filters(double mostAnisotropy) {
    using enum base::Filter;
    std::vector<Filter> all{{"nearest", "nearest", nearest, 1},
                            {"linear", "linear", linear, 4},
                            {"mipmaps, nearest", "nearest", nearestMipmapNearest, 1},
                            {"mipmaps, bilinear", "bilinear", linearMipmapNearest, 4},
                            {"mipmaps, trilinear", "trilinear", linearMipmapLinear, 8}};
    for (int most = 2; most <= mostAnisotropy; most *= 2)
        all.push_back(
            {"anisotropic", fmt::format("at most {}:1", most), linearMipmapLinear, 8. * most, 1. * most});
    for (const int factor : {2, 4, 8}) {
        const std::string label = fmt::format("{0} x {0}", factor);
        all.push_back({"supersampling, linear", label, linear, 4. * factor * factor, 1, factor});
        all.push_back(
            {"supersampling, trilinear", label, linearMipmapLinear, 8. * factor * factor, 1, factor});
    }
    return all;
}

/// Calls visit(level, texels) for the card and all smaller levels.
template <class Visit>
void forEachLevel(const Visit& visit) {
    Bytes texels = testCard();
    visit(0, texels);
    int level = 0;
    for (int side = kCardSide; side > 1; side /= 2) visit(++level, texels = halved(texels, side));
}

/// Draws views of the card.
class CardPicture {
  public:
    CardPicture(Bench& bench, int side)
        : bench_(bench),
          shader_(bench, bench_shaders::card_frag()),
          card_(need(gpu::Texture::create(
              bench.capabilities(),
              {.size = {kCardSide, kCardSide, 1},
               .levels = gpu::mostLevels(gpu::TextureShape::texture2D, {kCardSide, kCardSide, 1})}))),
          side_(side) {
        forEachLevel([&](int level, const Bytes& grey) {
            Bytes rgba;
            for (const std::uint8_t each : grey) rgba.insert(rgba.end(), {each, each, each, 255});
            check(card_.texture().upload(level, texelsOf(std::span<const std::uint8_t>(rgba), 4)));
        });
    }
    [[nodiscard]] int side() const { return side_; }

    struct Drawn {
        std::vector<double> pixels;  ///< grey, 0..1, rows from the top
        Timing time;
        double bytes;  ///< of the texels that the filter may read, including smaller levels, and the pixels
    };
    Drawn draw(const CardView& view, const Filter& filter) {
        const gpu::SamplerState state{.filter = filter.filter, .anisotropy = filter.anisotropy, .border = {}};
        const Canvas canvas(bench_, side_ * filter.factor, side_ * filter.factor, gpu::TexelFormat::r32f);
        Drawn drawn;
        drawn.time = bench_.time([&] {
            card_.sampledBy(state).bind(0);
            shader_.set("uCard", 0).set("uView", glm::vec4(view.start, view.texels, view.isPlane ? 1 : 0));
            canvas.bind();
            shader_.draw();
            drawn.pixels = reduce(canvas.pixels(1), side_, side_, filter.factor);
        });
        drawn.bytes = card_.bytes() * (state.readsMipmaps() ? 4. / 3 : 1) + canvas.bytes();
        return drawn;
    }
    Point measure(const CardView& view, const Filter& filter, const std::vector<double>& wanted) {
        const Drawn drawn = draw(view, filter);
        return {filter.reads, filter.label, kByte * rootMeanSquare(drawn.pixels, wanted), drawn.time,
                drawn.bytes};
    }

    /// Replaces the smaller levels by the driver's (glGenerateMipmap) and returns the largest difference of a
    /// texel from `halved`, in 255ths.
    int differenceOfDriversLevels() {
        card_.texture().generateMipmaps();
        int largest = 0;
        forEachLevel([&](int level, const Bytes& texels) {
            const std::vector<std::byte> rgba = need(card_.texture().read(level, 4, gpu::TexelType::u8));
            for (std::size_t i = 0; i < texels.size(); ++i)
                largest = std::max(largest, std::abs(std::to_integer<int>(rgba[i * 4]) - texels[i]));
        });
        return largest;
    }

  private:
    Bench& bench_;
    Shader shader_;
    Texels card_;
    int side_;
};

/// The reference for a view: means of factor x factor samples per pixel.
std::vector<double> cardReference(const CardView& view, int side, int factor = kCardFactor) {
    const Bytes card = testCard();
    return overPixels(side, side, [&](double x, double y) {
        double sum = 0;
        for (int j = 0; j < factor; ++j)
            for (int i = 0; i < factor; ++i) {
                const glm::dvec2 sample((i + .5) / factor - .5, (j + .5) / factor - .5);
                const glm::dvec2 place = glm::dvec2(x, y) + sample / static_cast<double>(side);
                sum += bilinear(card, kCardSide, texelsAt(view, place));
            }
        return sum / (factor * factor);
    });
}

int sideOf(const Bench& bench) {
    return bench.pick(64, 128);
}

/// A plane from .26 texels per pixel at the bottom to 32 at the top.
CardView planeView(int side) {
    return {.texels = .32 * side};
}

/// Linear and trilinear filtering of the plane.
std::vector<Figure> planeInBytes(Bench& bench) {
    CardPicture picture(bench, sideOf(bench));
    const CardView view = planeView(picture.side());
    const std::vector<double> wanted = cardReference(view, picture.side());
    Figure figure;
    for (const Filter& filter : filters(1))
        if (filter.curve == "linear" || filter.curve == "mipmaps, trilinear")
            figure.add("filtered in bytes", picture.measure(view, filter, wanted));
    return {figure};
}

Figure planeFigure(Bench& bench) {
    const double mostAnisotropy = bench.capabilities().maxAnisotropy;
    CardPicture picture(bench, sideOf(bench));
    Figure figure{.name = "plane",
                  .title = fmt::format("A plane in perspective, .3 to 32 texels per pixel, {0} x {0} pixels",
                                       picture.side()),
                  .settingName = "texels read per pixel, at most",
                  .errorName = "root mean square error",
                  .errorUnit = "1/255",
                  .reference = kCardReference};
    const CardView view = planeView(picture.side());
    const std::vector<double> wanted = cardReference(view, picture.side());
    for (const Filter& filter : filters(mostAnisotropy))
        figure.add(filter.curve, picture.measure(view, filter, wanted));
    if (std::optional<std::vector<Point>> bytes = filteredInBytes(bench, planeInBytes))
        figure.curves.push_back(
            {.name = "filtered in bytes", .points = std::move(*bytes), .isForScenes = false});

    const Point& nearest = figure.last(0);
    for (const Curve& curve : figure.curves) {
        const bool isAnisotropic = curve.name == "anisotropic";
        if (!isAnisotropic && curve.name != "linear" && curve.name != "mipmaps, bilinear" &&
            curve.name != "mipmaps, trilinear")
            continue;
        const Point& point = curve.points.back();
        figure.note("{}: {:.0f} % of the error of nearest, {:.2f} times its time",
                    isAnisotropic ? fmt::format("{} ({})", curve.name, point.label) : curve.name,
                    100 * point.error / nearest.error, point.time->median / nearest.time->median);
    }
    if (mostAnisotropy < 2) {
        figure.note("this driver has no anisotropic filter");
    } else {
        const Point &least = curveNamed(figure, "anisotropic").points.front(),
                    &most = curveNamed(figure, "anisotropic").points.back();
        figure.note("anisotropy of {}: {}/255, {}: {}/255", least.label, numberText(least.error), most.label,
                    numberText(most.error));
    }
    figure.note("16 x 16 and 24 x 24 samples of the reference differ by {}/255",
                numberText(kByte * rootMeanSquare(cardReference(view, picture.side(), 24), wanted)));
    figure.note("glGenerateMipmap's texels are within {}/255 of the means of four that are used here",
                numberText(picture.differenceOfDriversLevels()));
    return figure;
}

Figure frontFigure(Bench& bench) {
    CardPicture picture(bench, sideOf(bench));
    Figure figure{.name = "front",
                  .title = "A surface seen from the front, by its distance",
                  .settingName = "texels per pixel",
                  .errorName = "root mean square error",
                  .errorUnit = "1/255",
                  .reference = kCardReference,
                  .alternatives = Alternatives::setting};
    for (const double ratio : bench.pick(std::vector{1., 2., 4., 11.3}, {1., 1.19, 1.41, 1.68, 2., 2.38, 2.83,
                                                                         4., 5.66, 8., 11.3, 16., 22.6})) {
        const CardView view{.isPlane = false, .texels = ratio * picture.side()};
        const std::vector<double> wanted = cardReference(view, picture.side());
        for (const Filter& filter : filters(bench.capabilities().maxAnisotropy)) {
            if (filter.factor > 1 || (filter.anisotropy > 1 && filter.anisotropy < 16)) continue;
            Point point = picture.measure(view, filter, wanted);
            point.setting = ratio;
            point.label = fmt::format("{:g} texels per pixel", ratio);
            figure.add(filter.curve, std::move(point));
        }
    }
    for (const Curve& curve : figure.curves) {
        const auto worst = std::ranges::max_element(curve.points, {}, &Point::error);
        figure.note("{}: at worst {}/255, at {}", curve.name, numberText(worst->error), worst->label);
    }
    return figure;
}

/// Texels magnified by the driver's linear filter: the largest error per magnification.
std::vector<Figure> magnified(Bench& bench) {
    constexpr int kSide = 256;
    CardPicture picture(bench, kSide);
    Figure figure{.name = "arithmetic",
                  .title = "The driver's linear filter, magnifying bytes, 256 x 256 pixels",
                  .settingName = "pixels per texel",
                  .errorName = "largest error",
                  .errorUnit = "1/255",
                  .reference = "bilinear interpolation of the same texels at the same places, in double",
                  .alternatives = Alternatives::setting};
    for (int pixels = 1; pixels <= kSide; pixels *= bench.pick(8, 2)) {
        const CardView view{
            .isPlane = false, .texels = static_cast<double>(kSide) / pixels, .start = {5.3, 9.7}};
        const CardPicture::Drawn drawn = picture.draw(view, {"linear", "linear"});
        const std::vector<double> wanted = cardReference(view, kSide, 1);
        figure.add("the driver as glibra sets it up",
                   {1. * pixels, fmt::format("{} pixels per texel", pixels),
                    kByte * largestDifference(drawn.pixels, wanted), drawn.time, drawn.bytes});
    }
    return {figure};
}

Figure arithmeticFigure(Bench& bench) {
    Figure figure = std::move(magnified(bench).front());
    if (std::optional<std::vector<Point>> bytes = filteredInBytes(bench, magnified))
        figure.curves.push_back({"filtered in bytes", std::move(*bytes)});
    for (const Curve& curve : figure.curves)
        figure.note("{}: at most {}/255 wrong", curve.name,
                    numberText(std::ranges::max_element(curve.points, {}, &Point::error)->error));
    if (figure.curves.size() > 1)
        figure.note("filtering in bytes takes {:.2f} times as long at {}",
                    figure.last(1).time->median / figure.last(0).time->median, figure.last(0).label);
    else
        figure.note("only one way of filtering bytes was measured");
    return figure;
}

}  // namespace

std::vector<Figure> measureMinification(Bench& bench) {
    return {planeFigure(bench), frontFigure(bench), arithmeticFigure(bench)};
}

}  // namespace glibra::bench
