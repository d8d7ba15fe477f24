#include <cmath>
#include <numbers>
#include <span>

#include "bench/core/device.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
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
