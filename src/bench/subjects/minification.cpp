#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "bench/core/fit.h"
#include "bench/draw/byte_filter.h"
#include "bench/draw/offscreen.h"
#include "bench/reference/pixel_filter.h"
#include "bench/reference/test_card.h"
#include "bench/subjects/subjects.h"
#include "gpu/object/sampler.h"

namespace glibra::bench {
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

/// The texels at a place of the picture, 0..1 from the lower left. The shader below computes the same in
/// float.
glm::dvec2 texelsAt(const CardView& view, const glm::dvec2& place) {
    if (!view.isPlane) return view.start + view.texels * place;
    const double depth = 1 / (1.1 - place.y);
    return view.start + view.texels * glm::dvec2((place.x - .5) * depth, depth);
}

constexpr std::string_view kCardFragment =
    "in vec2 vPlace;\n"
    "uniform sampler2D uCard;\n"
    "uniform vec4 uView;\n"  // start, texels, is a plane
    "out vec4 fColor;\n"
    "void main() {\n"
    "    float depth = 1. / (1.1 - vPlace.y);\n"
    "    vec2 place = uView.w > 0. ? vec2((vPlace.x - .5) * depth, depth) : vPlace;\n"
    "    fColor = texture(uCard, (uView.xy + uView.z * place) / 512.);\n"
    "}\n";

/// A way of reading a texture, and the largest number of texels that one pixel reads.
struct Filter {
    std::string_view curve;
    std::string label;
    base::Filter filter = base::Filter::linear;
    double anisotropy = 1;
    int factor = 1;  ///< supersampling: factor x factor samples per pixel
    double reads = 4;
};

std::vector<Filter> filters(const gpu::Capabilities& capabilities) {
    using enum base::Filter;
    std::vector<Filter> all{
        {"nearest", "nearest", nearest, 1, 1, 1},
        {"linear", "linear", linear, 1, 1, 4},
        {"mipmaps, nearest", "nearest", nearestMipmapNearest, 1, 1, 1},
        {"mipmaps, bilinear", "bilinear", linearMipmapNearest, 1, 1, 4},
        {"mipmaps, trilinear", "trilinear", linearMipmapLinear, 1, 1, 8},
    };
    for (int most = 2; most <= capabilities.maxAnisotropy; most *= 2)
        all.push_back(
            {"anisotropic", fmt::format("at most {}:1", most), linearMipmapLinear, 1. * most, 1, 8. * most});
    for (const int factor : {2, 4, 8}) {
        all.push_back({"supersampling, linear", fmt::format("{0} x {0}", factor), linear, 1, factor,
                       4. * factor * factor});
        all.push_back({"supersampling, trilinear", fmt::format("{0} x {0}", factor), linearMipmapLinear, 1,
                       factor, 8. * factor * factor});
    }
    return all;
}

/// Draws views of the card.
class CardPicture {
  public:
    static Result<CardPicture> create(const gpu::Capabilities& capabilities, int side) {
        Result<gpu::Program> built = program(capabilities, kWholeTarget, kCardFragment);
        if (!built) return std::move(built.diagnostics);
        Result<CardTexture> texture = CardTexture::create();
        if (!texture) return std::move(texture.diagnostics);
        return CardPicture(capabilities, std::move(*built), std::move(*texture), side);
    }

    [[nodiscard]] int side() const { return side_; }
    [[nodiscard]] const CardTexture& texture() const { return texture_; }

    /// A target with that many samples per pixel.
    Result<gpu::Target> target(int factor) const {
        return gpu::Target::window(*capabilities_, side_ * factor, side_ * factor, gpu::TexelFormat::r32f);
    }
    /// One grey value per pixel, 0..1, rows from the top.
    Result<std::vector<double>> draw(const gpu::Target& target, const CardView& view,
                                     const Filter& filter) const {
        const gpu::Sampler sampler(
            gpu::SamplerState{.filter = filter.filter, .anisotropy = filter.anisotropy, .border = {}});
        texture_.bind(0);
        sampler.bind(0);
        setInt(program_, "uCard", 0);
        setFloats(program_, "uView",
                  {static_cast<float>(view.start.x), static_cast<float>(view.start.y),
                   static_cast<float>(view.texels), view.isPlane ? 1.F : 0.F});
        target.bind();
        drawWhole(program_);
        Result<std::vector<float>> samples = readFloats(*capabilities_, target, 1);
        glBindSampler(0, 0);
        if (!samples) return std::move(samples.diagnostics);
        return reduce(*samples, side_, side_, filter.factor, PixelFilter::box);
    }

  private:
    CardPicture(const gpu::Capabilities& capabilities, gpu::Program program, CardTexture texture, int side)
        : capabilities_(&capabilities),
          program_(std::move(program)),
          texture_(std::move(texture)),
          side_(side) {}

    const gpu::Capabilities* capabilities_;
    gpu::Program program_;
    CardTexture texture_;
    int side_;
};

/// The reference for a view: means of factor x factor samples per pixel.
std::vector<double> cardReference(const CardView& view, int side, int factor) {
    const std::vector<std::uint8_t> card = testCard();
    std::vector<double> pixels;
    for (int row = side - 1; row >= 0; --row)
        for (int column = 0; column < side; ++column) {
            double sum = 0;
            for (int y = 0; y < factor; ++y)
                for (int x = 0; x < factor; ++x) {
                    const glm::dvec2 sample((x + .5) / factor, (y + .5) / factor);
                    const glm::dvec2 place = (glm::dvec2(column, row) + sample) / static_cast<double>(side);
                    sum += bilinear(card, kCardSide, texelsAt(view, place));
                }
            pixels.push_back(sum / (factor * factor));
        }
    return pixels;
}

/// Bytes of the texels that the filter may read, including smaller levels, and of the pixels.
double filterBytes(const Filter& filter, const gpu::Target& target) {
    const bool hasLevels = base::SamplerState{.filter = filter.filter, .border = {}}.readsMipmaps();
    const double texels = 4. * kCardSide * kCardSide * (hasLevels ? 4. / 3 : 1);
    return texels + static_cast<double>(target.width()) * target.height() * sizeof(float);
}

Result<Point> measureCard(const Bench& bench, const CardPicture& picture, const CardView& view,
                          const Filter& filter, const std::vector<double>& wanted) {
    Result<gpu::Target> target = picture.target(filter.factor);
    if (!target) return std::move(target.diagnostics);
    Result<std::vector<double>> drawn;
    const Timing timing = bench.time([&] { drawn = picture.draw(*target, view, filter); });
    if (!drawn) return std::move(drawn.diagnostics);
    return Point{.setting = filter.reads,
                 .label = filter.label,
                 .error = errorInBytes(*drawn, wanted),
                 .time = timing,
                 .memory = filterBytes(filter, *target)};
}

int sideOf(const Bench& bench) {
    return bench.isQuick() ? 64 : 128;
}

/// A plane from .26 texels per pixel at the bottom to 32 at the top.
CardView planeView(int side) {
    return {.texels = .32 * side};
}

/// Linear and trilinear filtering of the plane.
Result<std::vector<Point>> planeInBytes(const Bench& bench, const gpu::Capabilities& capabilities) {
    Result<CardPicture> picture = CardPicture::create(capabilities, sideOf(bench));
    if (!picture) return std::move(picture.diagnostics);
    const CardView view = planeView(picture->side());
    const std::vector<double> wanted = cardReference(view, picture->side(), kCardFactor);
    std::vector<Point> points;
    for (const Filter& filter : filters(capabilities)) {
        if (filter.curve != "linear" && filter.curve != "mipmaps, trilinear") continue;
        Result<Point> point = measureCard(bench, *picture, view, filter, wanted);
        if (!point) return std::move(point.diagnostics);
        points.push_back(std::move(*point));
    }
    return points;
}

Result<Figure> plane(Bench& bench, const gpu::Context& context) {
    const gpu::Capabilities& capabilities = context.capabilities();
    Result<CardPicture> picture = CardPicture::create(capabilities, sideOf(bench));
    if (!picture) return std::move(picture.diagnostics);
    Figure figure{.name = "plane",
                  .title = fmt::format("A plane in perspective, .3 to 32 texels per pixel, {0} x {0} pixels",
                                       picture->side()),
                  .settingName = "texels read per pixel, at most",
                  .errorName = "root mean square error",
                  .errorUnit = "1/255",
                  .reference = kCardReference};
    const CardView view = planeView(picture->side());
    const std::vector<double> wanted = cardReference(view, picture->side(), kCardFactor);
    for (const Filter& filter : filters(capabilities)) {
        Result<Point> point = measureCard(bench, *picture, view, filter, wanted);
        if (!point) return std::move(point.diagnostics);
        curveNamed(figure, filter.curve).points.push_back(std::move(*point));
    }
    if (std::optional<std::vector<Point>> bytes = withByteFilter<planeInBytes>(bench, context))
        figure.curves.push_back(
            {.name = "filtered in bytes", .points = std::move(*bytes), .isForScenes = false});

    const Point& nearest = curveNamed(figure, "nearest").points.back();
    for (const char* name : {"linear", "mipmaps, bilinear", "mipmaps, trilinear", "anisotropic"}) {
        if (std::ranges::find(figure.curves, name, &Curve::name) == figure.curves.end()) continue;
        const Point& point = curveNamed(figure, name).points.back();
        figure.findings.push_back(fmt::format(
            "{}: {:.0f} % of the error of nearest, {:.2f} times its time",
            name == std::string_view("anisotropic") ? fmt::format("{} ({})", name, point.label) : name,
            100 * point.error / nearest.error, point.time->median / nearest.time->median));
    }
    if (capabilities.maxAnisotropy < 2) {
        figure.findings.emplace_back("this driver has no anisotropic filter");
    } else {
        const Curve& limits = curveNamed(figure, "anisotropic");
        figure.findings.push_back(
            fmt::format("anisotropy of {}: {}/255, {}: {}/255", limits.points.front().label,
                        numberText(limits.points.front().error), limits.points.back().label,
                        numberText(limits.points.back().error)));
    }
    figure.findings.push_back(
        fmt::format("16 x 16 and 24 x 24 samples of the reference differ by {}/255",
                    numberText(errorInBytes(cardReference(view, picture->side(), 24), wanted))));
    figure.findings.push_back(
        fmt::format("glGenerateMipmap's texels are within {}/255 of the means of four that are used here",
                    numberText(picture->texture().differenceOfDriversLevels())));
    return figure;
}

Result<Figure> front(const Bench& bench, const gpu::Capabilities& capabilities) {
    Result<CardPicture> picture = CardPicture::create(capabilities, sideOf(bench));
    if (!picture) return std::move(picture.diagnostics);
    Figure figure{.name = "front",
                  .title = "A surface seen from the front, by its distance",
                  .settingName = "texels per pixel",
                  .errorName = "root mean square error",
                  .errorUnit = "1/255",
                  .reference = kCardReference,
                  .alternatives = Alternatives::setting};
    const std::vector<double> ratios =
        bench.isQuick() ? std::vector{1., 2., 4., 11.3}
                        : std::vector{1., 1.19, 1.41, 1.68, 2., 2.38, 2.83, 4., 5.66, 8., 11.3, 16., 22.6};
    for (const double ratio : ratios) {
        const CardView view{.isPlane = false, .texels = ratio * picture->side()};
        const std::vector<double> wanted = cardReference(view, picture->side(), kCardFactor);
        for (const Filter& filter : filters(capabilities)) {
            if (filter.factor > 1 || (filter.anisotropy > 1 && filter.anisotropy < 16)) continue;
            Result<Point> point = measureCard(bench, *picture, view, filter, wanted);
            if (!point) return std::move(point.diagnostics);
            point->setting = ratio;
            point->label = fmt::format("{:g} texels per pixel", ratio);
            curveNamed(figure, filter.curve).points.push_back(std::move(*point));
        }
    }
    for (const Curve& curve : figure.curves) {
        const auto worst = std::ranges::max_element(curve.points, {}, &Point::error);
        figure.findings.push_back(
            fmt::format("{}: at worst {}/255, at {}", curve.name, numberText(worst->error), worst->label));
    }
    return figure;
}

/// Texels magnified by the driver's linear filter: the largest error per magnification.
Result<std::vector<Point>> magnified(const Bench& bench, const gpu::Capabilities& capabilities) {
    constexpr int kSide = 256;
    Result<CardPicture> picture = CardPicture::create(capabilities, kSide);
    if (!picture) return std::move(picture.diagnostics);
    Result<gpu::Target> target = picture->target(1);
    if (!target) return std::move(target.diagnostics);
    const Filter linear{.curve = "linear", .label = "linear"};
    std::vector<Point> points;
    for (int pixels = 1; pixels <= kSide; pixels *= bench.isQuick() ? 8 : 2) {
        const CardView view{
            .isPlane = false, .texels = static_cast<double>(kSide) / pixels, .start = {5.3, 9.7}};
        Result<std::vector<double>> drawn;
        const Timing timing = bench.time([&] { drawn = picture->draw(*target, view, linear); });
        if (!drawn) return std::move(drawn.diagnostics);
        const std::vector<double> wanted = cardReference(view, kSide, 1);
        double largest = 0;
        for (std::size_t i = 0; i < wanted.size(); ++i)
            largest = std::max(largest, std::abs((*drawn)[i] - wanted[i]));
        points.push_back({.setting = static_cast<double>(pixels),
                          .label = fmt::format("{} pixels per texel", pixels),
                          .error = kByte * largest,
                          .time = timing,
                          .memory = filterBytes(linear, *target)});
    }
    return points;
}

Result<Figure> arithmetic(Bench& bench, const gpu::Context& context) {
    Figure figure{.name = "arithmetic",
                  .title = "The driver's linear filter, magnifying bytes, 256 x 256 pixels",
                  .settingName = "pixels per texel",
                  .errorName = "largest error",
                  .errorUnit = "1/255",
                  .reference = "bilinear interpolation of the same texels at the same places, in double",
                  .alternatives = Alternatives::setting};
    Result<std::vector<Point>> floats = magnified(bench, context.capabilities());
    if (!floats) return std::move(floats.diagnostics);
    figure.curves.push_back({.name = "the driver as glibra sets it up", .points = std::move(*floats)});
    if (std::optional<std::vector<Point>> bytes = withByteFilter<magnified>(bench, context))
        figure.curves.push_back({.name = "filtered in bytes", .points = std::move(*bytes)});
    for (const Curve& curve : figure.curves)
        figure.findings.push_back(
            fmt::format("{}: at most {}/255 wrong", curve.name,
                        numberText(std::ranges::max_element(curve.points, {}, &Point::error)->error)));
    if (figure.curves.size() > 1)
        figure.findings.push_back(fmt::format(
            "filtering in bytes takes {:.2f} times as long at {}",
            figure.curves[1].points.back().time->median / figure.curves[0].points.back().time->median,
            figure.curves[0].points.back().label));
    else
        figure.findings.emplace_back("only one way of filtering bytes was measured");
    return figure;
}

}  // namespace

Result<std::vector<Figure>> measureMinification(Bench& bench) {
    Result<gpu::Context*> context = bench.context();
    if (!context) return std::move(context.diagnostics);
    std::vector<Figure> figures;
    const auto add = [&](Result<Figure> figure) {
        if (figure) figures.push_back(std::move(*figure));
        return std::move(figure.diagnostics);
    };
    Diagnostics problems = add(plane(bench, **context));
    append(problems, add(front(bench, (*context)->capabilities())));
    append(problems, add(arithmetic(bench, **context)));
    if (hasError(problems)) return problems;
    return figures;
}

}  // namespace glibra::bench
