#include "bench/subjects/scene_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/core/fit.h"
#include "bench/draw/byte_filter.h"
#include "bench/draw/scene_picture.h"
#include "render/scene_renderer.h"

namespace glibra::bench {
namespace {

RenderOptions optionsAt(const SceneSweep& sweep, double value) {
    RenderOptions options = sweep.options;
    options.set.push_back(fmt::format("{}={}", sweep.name, value));
    return options;
}

/// The picture with the value, and how long drawing it again takes.
Result<std::pair<image::Image, Timing>> measureAt(Bench& bench, gpu::Context& context,
                                                  const SceneSweep& sweep, double value) {
    RenderOptions options = optionsAt(sweep, value);
    options.skip = false;  // nothing is kept from one drawing to the next
    render::Stats stats;
    Result<render::SceneRenderer> loaded = render::SceneRenderer::load(context, sweep.scene, options, stats);
    if (!loaded) return std::move(loaded.diagnostics);
    const double time = sweep.options.time;
    Result<image::Image> picture = loaded->draw(time, stats);
    if (!picture) return std::move(picture.diagnostics);
    const Timing timing = bench.time([&] {
        if (time > 0 && loaded->runsSteps()) (void)loaded->draw(0, stats);  // the steps run again
        (void)loaded->draw(time, stats);
    });
    Diagnostics remarks = std::move(loaded.diagnostics);
    append(remarks, std::move(picture.diagnostics));
    return {std::pair(std::move(*picture), timing), std::move(remarks)};
}

/// The cheapest value whose error stays below a step of eight bits.
std::string enough(const Curve& curve, const std::string& name) {
    const auto found = std::ranges::find_if(curve.points, [](const Point& each) { return each.error < 1; });
    const Point& finest = curve.points.back();
    if (found == curve.points.end() - 1)
        return fmt::format("no value but the last one is within 1/255 of it, in the mean");
    return fmt::format("{} = {} is within 1/255 of the finest, in the mean, in {} instead of {}", name,
                       found->label, secondsText(found->time->median), secondsText(finest.time->median));
}

}  // namespace

Result<std::vector<Figure>> measureSweep(Bench& bench, const SceneSweep& sweep) {
    const Result<gpu::Context*> context = bench.context();
    if (!context) return context.diagnostics;
    std::vector<std::pair<image::Image, Timing>> measured;
    Diagnostics remarks;
    for (const double value : sweep.values) {
        auto each = measureAt(bench, **context, sweep, value);
        append(remarks, std::move(each.diagnostics));
        if (!each) return remarks;
        measured.push_back(std::move(*each));
    }
    Curve curve{.name = sweep.scene.filename().string()};
    for (std::size_t i = 0; i < measured.size(); ++i) {
        const auto& [picture, time] = measured[i];
        const PictureError error = pictureError(measured.back().first, picture);
        curve.points.push_back({.setting = sweep.values[i],
                                .label = fmt::format("{}", sweep.values[i]),
                                .error = error.rootMeanSquare * kByte,
                                .time = time});
    }
    Curve others = curve;  // the finest is the reference itself
    others.points.pop_back();
    Figure figure{.name = "sweep",
                  .title = fmt::format("{}: {}", sweep.scene.filename().string(), sweep.name),
                  .settingName = sweep.name,
                  .errorName = "root mean square of the difference",
                  .errorUnit = "1/255",
                  .reference = fmt::format("the picture with {} = {}, so that point has no error of its own",
                                           sweep.name, curve.points.back().label),
                  .findings = {orderSentence(others, sweep.name), enough(curve, sweep.name)}};
    figure.curves.push_back(std::move(curve));
    return {std::vector{std::move(figure)}, std::move(remarks)};
}

}  // namespace glibra::bench
