#include <algorithm>
#include <cmath>

#include "bench/core/device.h"
#include "bench/core/run.h"
#include "bench/reference/pixel_filter.h"
#include "bench/reference/test_card.h"
#include "bench/subjects/subjects.h"
#include "embedded/bench_shaders.h"

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
