#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/core/device.h"
#include "bench/reference/exact.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

constexpr double kNear = 1;  // only ratios matter
constexpr int kBufferSide = 256;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();  ///< for a gap that does not exist
constexpr const char* kOrderReference =
    "the order of the two distances, known in double; theory: one step of the buffer times z^2 (f - n) / (f "
    "n)";

// Eye space; z is the distance. uProjection: clip z = x * distance + y.
constexpr std::string_view kDepthVertex = R"(layout(location = 0) in vec3 aPosition;
uniform vec2 uProjection;
void main() {
    gl_Position = vec4(aPosition.xy, uProjection.x * aPosition.z + uProjection.y, aPosition.z);
}
)";
constexpr std::string_view kDepthFragment = R"(uniform float uBrightness;
out vec4 fColor;
void main() { fColor = vec4(uBrightness); }
)";

/// `Pass ... reversed` of the language is reversed in 0..1.
bool isForScenes(const DepthKind& kind) {
    return !kind.isReversed || kind.isZeroToOne;
}

/// Clip z as a factor and a constant of the distance, in double.
glm::dvec2 projection(const DepthKind& kind, double near, double far) {
    const double span = far - near;
    const glm::dvec2 usual = kind.isZeroToOne ? glm::dvec2(far, -far * near) / span
                                              : glm::dvec2(far + near, -2 * far * near) / span;
    if (!kind.isReversed) return usual;
    return kind.isZeroToOne ? glm::dvec2(-near, far * near) / span : -usual;
}

void push(std::vector<float>& vertices, double x, double y, double distance) {
    for (const double each : {x * distance, y * distance, distance})
        vertices.push_back(static_cast<float>(each));
}

/// Those that this driver supports.
std::vector<DepthKind> usableKinds(const gpu::Capabilities& capabilities) {
    std::vector<DepthKind> usable(kDepthKinds.begin(), kDepthKinds.end());
    std::erase_if(usable,
                  [&](const DepthKind& kind) { return kind.isZeroToOne && !capabilities.atLeast(4, 5); });
    return usable;
}

/// Two distances from the eye, near <= front <= back <= far.
struct DepthPair {
    double front = 0, back = 0;
};

/// A square picture with depth of that kind. The state of the context stays as it was.
class DepthPicture {
  public:
    DepthPicture(Bench& bench, const DepthKind& kind, int side)
        : kind_(kind),
          canvas_(bench, side, side, gpu::TexelFormat::rgba8, 1, kind.format),
          shader_(bench, kDepthVertex, kDepthFragment) {}

    /// For every pair: draws the farther surface, then the nearer one in the same pixel with a depth test
    /// that passes only nearer surfaces. The result says whether the nearer one is visible. At most side *
    /// side pairs.
    [[nodiscard]] std::vector<bool> resolvePairs(double near, double far,
                                                 std::span<const DepthPair> pairs) const {
        std::vector<float> back, front;
        const auto side = static_cast<std::size_t>(canvas_.width());
        const auto middle = [&](std::size_t pixel) {
            return (static_cast<double>(pixel) + .5) * 2 / canvas_.width() - 1;
        };
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const double x = middle(i % side), y = middle(i / side);
            push(back, x, y, pairs[i].back);
            push(front, x, y, pairs[i].front);
        }
        draw(near, far, {{GL_POINTS, std::move(back), .5}, {GL_POINTS, std::move(front), 1}});
        const std::vector<float> pixels = canvas_.pixels(1);
        std::vector<bool> isResolved;
        for (std::size_t i = 0; i < pairs.size(); ++i)  // pictures start at the top
            isResolved.push_back(pixels[(side - 1 - i / side) * side + i % side] == 1);
        return isResolved;
    }

    /// The share of pixels, 0..1, in which the farther of two parallel planes wins. The nearer plane fills
    /// the picture from 1 / 1.2 to 1 / .8 of the distance, bottom to top. The farther one is `gap` (a share
    /// of the distance) behind it along every line of sight, is larger than the picture, and is drawn first.
    [[nodiscard]] double fighting(double near, double far, double distance, double gap) const {
        const auto plane = [&](double scale, double width, double height) {
            std::vector<float> vertices;
            // Two triangles as a strip. On a plane, 1 / distance is linear over the picture.
            for (const double y : {-height, height})
                for (const double x : {-width, width}) push(vertices, x, y, distance * scale / (1 - .2 * y));
            return vertices;
        };
        draw(near, far,
             {{GL_TRIANGLE_STRIP, plane(1 + gap, 1.7, 1.3), .5}, {GL_TRIANGLE_STRIP, plane(1, 1, 1), 1}});
        const std::vector<float> pixels = canvas_.pixels(1);
        const auto wrong = std::ranges::count_if(pixels, [](float each) { return each != 1; });
        return static_cast<double>(wrong) / static_cast<double>(pixels.size());
    }

    /// Clears, draws `layers` rectangles over all pixels from back to front.
    void drawLayers(int layers) const {
        std::vector<Layer> all;
        for (int layer = layers; layer > 0; --layer) {
            Layer& each = all.emplace_back(Layer{GL_TRIANGLE_STRIP, {}, 1. / layer});
            for (const double y : {-1., 1.})
                for (const double x : {-1., 1.}) push(each.vertices, x, y, layer + .5);
        }
        draw(1, layers + 2, all);
    }

  private:
    struct Layer {
        GLenum primitive;
        std::vector<float> vertices;
        double brightness;
    };
    void draw(double near, double far, const std::vector<Layer>& layers) const {
        canvas_.clear({}, kind_.isReversed ? 0 : 1);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(kind_.isReversed ? GL_GREATER : GL_LESS);
        if (kind_.isZeroToOne) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        shader_.set("uProjection", glm::vec2(projection(kind_, near, far)));
        for (const Layer& each : layers) {
            shader_.set("uBrightness", each.brightness);
            Vertices({{each.vertices}}).draw(shader_, each.primitive);
        }
        glDisable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        if (kind_.isZeroToOne) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    }

    DepthKind kind_;
    Canvas canvas_;
    Shader shader_;
};

/// The smallest gap, as a share of z, such that every gap from there on is resolved at all distances from .7
/// z to z, which meet the steps of the buffer in every phase; NaN if not even the largest is.
double smallestGap(const DepthPicture& picture, double far, double z, bool isQuick) {
    constexpr int kOctaves = 25;
    const int perOctave = isQuick ? 4 : 8, jitters = isQuick ? 32 : 96;
    std::vector<double> gaps;  // as shares of the distance, rising
    for (int i = -kOctaves * perOctave; i <= 0; ++i)
        gaps.push_back(std::exp2(static_cast<double>(i) / perOctave));
    std::vector<DepthPair> pairs;
    for (int jitter = 0; jitter < jitters; ++jitter)
        for (const double gap : gaps) {
            const double there = z * (1 - .3 * jitter / jitters);
            pairs.push_back({there, std::min(there * (1 + gap), far)});
        }
    const std::vector<bool> isResolved = picture.resolvePairs(kNear, far, pairs);
    std::size_t first = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (!isResolved[i]) first = std::max(first, i % gaps.size() + 1);
    return first < gaps.size() ? gaps[first] : kNaN;
}

/// Bytes of a buffer with `side` x `side` pixels.
double bufferBytes(const DepthKind& kind, int side) {
    return static_cast<double>(gpu::bytesPerTexel(kind.format)) * side * side;
}

/// The place where a gap is measured.
struct GapPlace {
    double setting = 0, far = 0, z = 0;
    std::string label;
};

void noteTheory(Figure& figure, const Curve& measured, const Curve& theory) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (std::size_t i = 0; i < measured.points.size(); ++i) {
        const double steps = measured.points[i].error / theory.points[i].error;
        if (std::isnan(steps)) continue;
        least = std::min(least, steps);
        most = std::max(most, steps);
    }
    if (most == 0) return figure.note("{}: nothing is resolved", measured.name);
    figure.note("{}: the smallest gap is {:.2g} to {:.2g} times one step in theory", measured.name, least,
                most);
}

/// A measured curve and a theoretical one for each kind.
Figure gapFigure(Bench& bench, std::string name, std::string title, std::string settingName,
                 const std::vector<GapPlace>& places) {
    Figure figure{.name = std::move(name),
                  .title = std::move(title),
                  .settingName = std::move(settingName),
                  .errorName = "smallest gap that is always resolved",
                  .errorUnit = "distances",
                  .reference = kOrderReference,
                  .alternatives = Alternatives::setting};
    const std::vector<DepthKind> kinds = usableKinds(bench.capabilities());
    for (const DepthKind& kind : kinds) {
        const DepthPicture picture(bench, kind, kBufferSide);
        for (const GapPlace& at : places)
            figure
                .add(kind.name, {at.setting, at.label, smallestGap(picture, at.far, at.z, bench.isQuick()),
                                 std::nullopt, bufferBytes(kind, kBufferSide)})
                .isForScenes = isForScenes(kind);
    }
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const std::string theory = fmt::format("theory: {}", kinds[i].name);
        for (const GapPlace& at : places)
            figure.add(theory, {at.setting, at.label, depthStep(kinds[i], kNear, at.far, at.z) / at.z})
                .theoryOf = i;
        noteTheory(figure, figure.curves[i], figure.curves.back());
    }
    if (!bench.capabilities().atLeast(4, 5))
        figure.note(
            "this driver has no glClipControl (GL 4.5), so that reversed depth in 0..1 is not measured");
    return figure;
}

/// The geometric mean of one curve's errors over another's, at the points where both have one.
double meanRatio(const Curve& above, const Curve& below) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < above.points.size(); ++i) {
        const double ratio = std::log(above.points[i].error / below.points[i].error);
        if (!std::isfinite(ratio)) continue;
        sum += ratio;
        ++count;
    }
    return count > 0 ? std::exp(sum / count) : kNaN;
}

Figure gapByRatio(Bench& bench) {
    std::vector<GapPlace> places;
    const int perDecade = bench.pick(1, 3);
    for (int i = perDecade; i <= 7 * perDecade; ++i) {
        const double ratio = std::pow(10, static_cast<double>(i) / perDecade);
        places.push_back({ratio, kNear * ratio, kNear * ratio / 2, fmt::format("{:.3g}:1", ratio)});
    }
    Figure figure = gapFigure(bench, "gap-by-range", "Smallest gap resolved at half the far distance",
                              "far / near", places);
    for (const Curve& curve : figure.curves) {
        if (curve.theoryOf) continue;
        double widest = 0;
        for (const Point& point : curve.points)
            if (point.error <= .001) widest = std::max(widest, point.setting);
        figure.note("{}: a gap of 1/1000 of the distance is resolved up to far / near = {:.3g}", curve.name,
                    widest);
    }
    figure.note(
        "floats that are not reversed: their smallest gaps are {:.3g} times those of 24 bits (geometric "
        "mean)",
        meanRatio(figure.curves[2], figure.curves[1]));
    return figure;
}

Figure gapByDistance(Bench& bench) {
    std::vector<GapPlace> places;
    for (int octave = 1; octave <= 12; octave += bench.pick(3, 1)) {
        const double z = std::ldexp(1., octave);
        places.push_back({z, 1e4, z, fmt::format("{:g}", z)});
    }
    Figure figure = gapFigure(bench, "gap-by-distance", "Smallest gap resolved, far / near = 10000",
                              "distance / near", places);
    figure.noteOrders("distance", 8);
    return figure;
}

Figure fightingByGap(Bench& bench) {
    constexpr double kFar = 1e4, kDistance = 1e3;
    Figure figure{.name = "fighting",
                  .title = "Two tilted planes at 1000 times the near distance, far / near = 10000",
                  .settingName = "steps of the buffer between them",
                  .errorName = "pixels in which the farther one wins",
                  .reference = "the nearer plane, which must be visible in every pixel",
                  .alternatives = Alternatives::none};
    for (const DepthKind& kind : usableKinds(bench.capabilities())) {
        const DepthPicture picture(bench, kind, kBufferSide);
        double clean = kNaN;
        for (int half = -6; half <= 12; half += bench.pick(2, 1)) {
            const double steps = std::exp2(half / 2.);
            const double gap = steps * depthStep(kind, kNear, kFar, kDistance) / kDistance;
            const double wrong = picture.fighting(kNear, kFar, kDistance, gap);
            figure.add(kind.name, {steps, fmt::format("{:.3g} steps", steps), wrong, std::nullopt,
                                   bufferBytes(kind, kBufferSide)});
            clean = wrong > 0 ? kNaN : std::isnan(clean) ? steps : clean;
        }
        figure.note("{}: no pixel is wrong from {} steps on", kind.name, numberText(clean));
    }
    return figure;
}

Figure depthCost(Bench& bench) {
    constexpr double kFar = 1e4;
    constexpr int kCostSide = 512, kLayers = 8;
    Figure figure{
        .name = "cost",
        .title = "Eight layers of 512 x 512 pixels; gap at half the far distance, far / near = 10000",
        .settingName = "bits per pixel",
        .errorName = "smallest gap that is always resolved",
        .errorUnit = "distances",
        .reference = kOrderReference};
    for (const DepthKind& kind : usableKinds(bench.capabilities())) {
        const DepthPicture picture(bench, kind, kCostSide);
        figure.add(kind.name,
                   {8. * static_cast<double>(gpu::bytesPerTexel(kind.format)), std::string(kind.name),
                    smallestGap(picture, kFar, kFar / 2, bench.isQuick()),
                    bench.timeDrawing([&] { picture.drawLayers(kLayers); }), bufferBytes(kind, kCostSide)});
        figure.curves.back().isForScenes = isForScenes(kind);
    }
    const Point &standard = figure.last(1), &last = figure.last(figure.curves.size() - 1);
    figure.note("{} takes {:.2f} times the time of {} and resolves gaps that are {:.3g} times smaller",
                last.label, last.time->median / standard.time->median, standard.label,
                standard.error / last.error);
    return figure;
}

}  // namespace

std::vector<Figure> measureDepth(Bench& bench) {
    return {gapByRatio(bench), gapByDistance(bench), fightingByGap(bench), depthCost(bench)};
}

}  // namespace glibra::bench
