#include "bench/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <string>

#include "bench/fit.h"
#include "bench/scene_picture.h"
#include "bench/shipped_scenes.h"

namespace glibra::bench {
namespace {

constexpr std::array<int, 3> kSamples{1, 2, 4};

/// One scene by each number of samples.
struct Measured {
    const ShippedScene* scene = nullptr;
    int width = 0, height = 0;
    std::array<PictureError, kSamples.size()> errors{};
    std::array<Timing, kSamples.size()> times{};
};

Result<Measured> measure(Bench& bench, gpu::Context& context, const ShippedScene& scene) {
    RenderOptions options;
    if (bench.isQuick()) options.width = options.height = 64;
    RenderOptions best = options;
    best.set = scene.finest;
    const Result<image::Image> reference = sampledPicture(context, scene.path, best, bench.isQuick() ? 4 : 8);
    if (!reference) return reference.diagnostics;
    Measured measured{.scene = &scene, .width = reference->width, .height = reference->height};
    for (std::size_t i = 0; i < kSamples.size(); ++i) {
        options.samples = kSamples[i];
        Result<image::Image> picture = scenePicture(context, scene.path, options);
        if (!picture) return std::move(picture.diagnostics);
        measured.errors[i] = pictureError(*reference, *picture);
        measured.times[i] = bench.time([&] { picture = scenePicture(context, scene.path, options); });
    }
    return measured;
}

std::string sizeText(const Measured& each) {
    return fmt::format("{} x {}", each.width, each.height);
}

/// Scenes by one measure of their error, largest first; a curve for each number of samples.
Figure ranked(std::vector<Measured> all, Figure figure, double (*errorOf)(const PictureError&)) {
    std::ranges::sort(all, std::ranges::greater(),
                      [&](const Measured& each) { return errorOf(each.errors.front()); });
    for (std::size_t i = 0; i < kSamples.size(); ++i) {
        Curve curve{.name = fmt::format("{} sample{}", kSamples[i], kSamples[i] == 1 ? "" : "s"),
                    .points = {}};
        for (std::size_t rank = 0; rank < all.size(); ++rank)
            curve.points.push_back({.setting = static_cast<double>(rank + 1),
                                    .label = all[rank].scene->name,
                                    .error = errorOf(all[rank].errors[i]),
                                    .time = all[rank].times[i],
                                    .memory = {}});
        figure.curves.push_back(std::move(curve));
    }
    constexpr std::size_t kTold = 10;
    for (std::size_t rank = 0; rank < std::min(kTold, all.size()); ++rank) {
        const Measured& each = all[rank];
        figure.findings.push_back(
            fmt::format("{} ({}): {}, with 4 samples {}; {} and {}", each.scene->name, sizeText(each),
                        numberText(errorOf(each.errors.front())), numberText(errorOf(each.errors.back())),
                        secondsText(each.times.front().median), secondsText(each.times.back().median)));
    }
    return figure;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values.empty() ? std::numeric_limits<double>::quiet_NaN() : values[values.size() / 2];
}

/// What 4 samples bring and cost, and which scenes take longest.
std::vector<std::string> overall(const std::vector<Measured>& all) {
    std::vector<double> better, longer, times;
    for (const Measured& each : all) {
        if (each.errors.front().rootMeanSquare > 0)
            better.push_back(each.errors.back().rootMeanSquare / each.errors.front().rootMeanSquare);
        longer.push_back(each.times.back().median / each.times.front().median);
        times.push_back(each.times.front().median);
    }
    const auto slowest =
        std::ranges::max_element(all, {}, [](const Measured& each) { return each.times.front().median; });
    return {
        fmt::format(
            "{} scenes; of half of them the picture takes less than {} (parse, plan, upload, draw, read), "
            "the longest takes {}: {}",
            all.size(), secondsText(median(times)), secondsText(slowest->times.front().median),
            slowest->scene->name),
        fmt::format("4 samples leave {:.2f} of the error in {:.2f} of the time (medians over the scenes)",
                    median(better), median(longer))};
}

}  // namespace

Result<std::vector<Figure>> measureScenes(Bench& bench) {
    const Result<gpu::Context*> context = bench.context();
    if (!context) return context.diagnostics;
    const Result<std::vector<ShippedScene>> scenes = shippedScenes();
    if (!scenes) return scenes.diagnostics;
    std::vector<Measured> all;
    std::vector<std::string> failures;
    Diagnostics reasons;
    for (const ShippedScene& scene : *scenes) {
        Result<Measured> measured = measure(bench, **context, scene);
        if (measured) {
            all.push_back(std::move(*measured));
            continue;
        }
        failures.push_back(
            fmt::format("{} cannot be drawn: {}", scene.name, toString(measured.diagnostics.front())));
        append(reasons, std::move(measured.diagnostics));
    }
    if (all.empty()) return reasons;
    const std::string reference = fmt::format(
        "the mean of {} pictures shifted by parts of a pixel, with the finest tessellation of the "
        "scene's sliders",
        bench.isQuick() ? 16 : 64);
    const auto figure = [&](std::string name, std::string title, std::string error) {
        return Figure{.name = std::move(name),
                      .title = std::move(title),
                      .settingName = "rank of the scene",
                      .errorName = std::move(error),
                      .errorUnit = "",
                      .reference = reference,
                      .curves = {},
                      .findings = {}};
    };
    std::vector<Figure> figures{
        ranked(all,
               figure("root-mean-square", "Shipped scenes: error of the picture, largest first",
                      "root mean square"),
               [](const PictureError& each) { return each.rootMeanSquare; }),
        ranked(all,
               figure("pixels", "Shipped scenes: pixels that are visibly off, largest share first",
                      "share of pixels off by more than 8/255"),
               [](const PictureError& each) { return each.differing; }),
        ranked(all,
               figure("flip", "Shipped scenes: difference that a person sees, largest first", "mean FLIP"),
               [](const PictureError& each) { return each.flip; })};
    std::vector<std::string>& first = figures.front().findings;
    const std::vector<std::string> summary = overall(all);
    first.insert(first.begin(), summary.begin(), summary.end());
    first.insert(first.end(), failures.begin(), failures.end());
    return figures;
}

}  // namespace glibra::bench
