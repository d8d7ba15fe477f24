#include <cmath>
#include <iterator>
#include <numbers>
#include <span>

#include "base/text.h"
#include "bench/core/device.h"
#include "bench/subjects/filters.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

/// Decodes to linear light and encodes again, as expressions of a vec3 c.
struct ColorCurve {
    const char *name, *decode, *encode;
};
constexpr const char* kSrgbDecode = "mix(c / 12.92, pow((c + .055) / 1.055, vec3(2.4)), step(.04045, c))";
constexpr const char* kSrgbEncode =
    "mix(12.92 * c, 1.055 * pow(c, vec3(1. / 2.4)) - .055, step(.0031308, c))";
constexpr ColorCurve kColorCurves[] = {
    {"the curve of sRGB", kSrgbDecode, kSrgbEncode},
    {"power 2.2", "pow(c, vec3(2.2))", "pow(c, vec3(1. / 2.2))"},
    {"square and root", "c * c", "sqrt(c)"},
    {"decoded by the curve, encoded by power 2.2", kSrgbDecode, "pow(c, vec3(1. / 2.2))"}};

std::string colorPass(const char* expression) {
    return fmt::format(R"(uniform sampler2D uPicture;
out vec4 fColor;
void main() {{
    vec3 c = max(texelFetch(uPicture, ivec2(gl_FragCoord.xy), 0).rgb, 0.);
    fColor = vec4({}, 1.);
}}
)",
                       expression);
}

/// Every byte, decoded into a texture, encoded again, and so on; all passes but the last, which writes
/// floats, write texels of one format.
Figure roundTripFigure(Bench& bench) {
    Figure figure{.name = "round-trips",
                  .title = "Bytes made linear and encoded again, by the curve and by the texels between",
                  .settingName = "round trips",
                  .errorName = "largest error of a byte",
                  .errorUnit = "1/255",
                  .reference = "the byte itself: a round trip changes nothing",
                  .alternatives = Alternatives::none};
    Plane ramp{256, 1, {}};
    for (int i = 0; i < 256; ++i) ramp.values.push_back(i / kByte);
    for (const ColorCurve& curve : kColorCurves)
        for (const auto& [format, texels] : kColorFormats) {
            const std::string name = fmt::format("{}, {}", curve.name, format);
            Passes passes;
            for (int trips = 1; trips <= bench.pick(4, 16); trips *= 2) {
                while (std::ssize(passes) < 2 * trips) {
                    passes.push_back(colorPass(curve.decode));
                    passes.push_back(colorPass(curve.encode));
                }
                const FilterChain chain(bench, ramp, passes, texels);
                const Timing time = bench.timeDrawing([&] { chain.draw(); });
                const Plane back = chain.result();
                figure.add(name,
                           {1. * trips, base::counted(trips, "round trip"),
                            kByte * largestDifference(back.values, ramp.values), time, chain.bytesBetween()});
            }
            const Point &once = figure.curves.back().points.front(),
                        &last = figure.curves.back().points.back();
            if (last.error < .5)
                figure.note("{}: every byte comes back after {}", name, last.label);
            else
                figure.note("{}: bytes are off by up to {} after {}, {} after {}", name,
                            numberText(once.error), once.label, numberText(last.error), last.label);
        }
    figure.findings.push_back(halfFloatSentence(bench));
    return figure;
}

}  // namespace

std::vector<Figure> measureColors(Bench& bench) {
    return {roundTripFigure(bench)};
}

namespace {

constexpr int kLayerSide = 64;

/// Adds a point for each number of layers: `draw` draws them all, `wanted` is a pixel's red in closed form.
template <class Drawing, class Wanted>
void addLayers(Figure& figure, Bench& bench, const std::string& curve, gpu::TexelFormat format,
               const Shader& shader, const Drawing& draw, const Wanted& wanted) {
    const Canvas canvas(bench, kLayerSide, kLayerSide, format);
    for (int layers = 4; layers <= bench.pick(256, 4096); layers *= 4) {
        const auto drawn = [&] {
            canvas.clear();
            glEnable(GL_BLEND);
            for (int i = 0; i < layers; ++i) {
                draw(i, layers);
                shader.draw();
            }
            glDisable(GL_BLEND);
        };
        const Timing time = bench.timeDrawing(drawn);
        const auto exact =
            overPixels(kLayerSide, kLayerSide, [&](double x, double y) { return wanted(x, y, layers); });
        figure.add(curve, {1. * layers, fmt::format("{} {}", layers, figure.settingName),
                           kByte * rootMeanSquare(canvas.pixels(1), exact), time, canvas.bytes()});
    }
}

/// Layers of one colour and opacity per pixel, one over the other.
Figure blendingFigure(Bench& bench) {
    Figure figure{.name = "blending",
                  .title = "Many translucent layers, one over the other, by the texels of the target",
                  .settingName = "layers",
                  .errorName = "root mean square error",
                  .errorUnit = "1/255",
                  .reference = "the colour behind n layers in closed form, c (1 - (1 - a)^n), in double",
                  .alternatives = Alternatives::setting};
    const Shader shader(bench, R"(in vec2 vPlace;
out vec4 fColor;
void main() { fColor = vec4(vec3(vPlace.x), .1 * vPlace.y); }
)");
    for (const NamedFormat& each : kColorFormats)
        addLayers(
            figure, bench, each.name, each.format, shader,
            [](int, int) { glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA); },
            [](double x, double y, int layers) { return x * (1 - std::pow(1 - .1 * y, layers)); });
    for (const Curve& curve : figure.curves)
        figure.note("{}: {} of a byte's step after {}", curve.name, numberText(curve.points.back().error),
                    curve.points.back().label);
    figure.findings.push_back(halfFloatSentence(bench));
    return figure;
}

/// The mean of many samples: as a sum of n-th parts, and as a mean that each sample moves.
Figure accumulationFigure(Bench& bench) {
    Figure figure{.name = "accumulation",
                  .title = "The mean of many samples, accumulated in a target",
                  .settingName = "samples",
                  .errorName = "root mean square error",
                  .errorUnit = "1/255",
                  .reference = "the mean of the same samples in double",
                  .alternatives = Alternatives::setting};
    const Shader shader(bench, R"(in vec2 vPlace;
uniform float uSample;
uniform float uShare;
out vec4 fColor;
void main() { fColor = vec4((vPlace.x + .5 * uSample) * uShare); }
)");
    // Spread evenly over 0..1 (golden section).
    const auto sample = [](int i) { return std::fmod(i * std::numbers::phi, 1.); };
    const auto mean = [&](double x, double, int layers) {
        double sum = 0;
        for (int i = 0; i < layers; ++i) sum += sample(i);
        return x + .5 * sum / layers;
    };
    for (const bool isRunning : {false, true})
        for (const NamedFormat& each : std::span(kColorFormats).last(2))
            addLayers(
                figure, bench, fmt::format("{}, {}", isRunning ? "running mean" : "sum of shares", each.name),
                each.format, shader,
                [&](int i, int layers) {
                    const double share = isRunning ? 1. / (i + 1) : 1. / layers;
                    glBlendColor(0, 0, 0, static_cast<float>(1 - share));
                    glBlendFunc(GL_ONE, isRunning ? GL_CONSTANT_ALPHA : GL_ONE);
                    shader.set("uSample", sample(i)).set("uShare", share);
                },
                mean);
    figure.noteOrders("samples");
    figure.findings.push_back(halfFloatSentence(bench));
    return figure;
}

}  // namespace

std::vector<Figure> measureLayers(Bench& bench) {
    return {blendingFigure(bench), accumulationFigure(bench)};
}

}  // namespace glibra::bench
