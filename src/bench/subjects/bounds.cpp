#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "bench/core/fit.h"
#include "bench/draw/scene_picture.h"
#include "bench/subjects/shipped_scenes.h"
#include "bench/subjects/subjects.h"
#include "budget/contour_shift.h"
#include "render/scene_renderer.h"

namespace glibra::bench {
namespace {

constexpr double kVisible = 8. / 255;
constexpr double kMostColored = .002;  ///< twice what small pictures allow

/// The names and values of the Bound variables of a scene.
struct BoundValues {
    std::vector<std::string> set{}, finest{};  ///< "NAME=VALUE": as they are, and the finest
    bool isKept = false;                       ///< the program reports that something is not chosen
};

Result<BoundValues> valuesWith(gpu::Context& context, const ShippedScene& scene,
                               const RenderOptions& options) {
    render::Stats stats;
    const Result<render::SceneRenderer> loaded =
        render::SceneRenderer::load(context, scene.path, options, stats);
    if (!loaded) return loaded.diagnostics;
    BoundValues values;
    for (const scene::Variable& each : loaded->scene().variables) {
        if (!each.bound) continue;
        values.set.push_back(fmt::format("{}={}", each.name, each.current.front()));
        values.finest.push_back(fmt::format("{}={}", each.name, each.bound->finest));
    }
    values.isKept = std::ranges::any_of(loaded.diagnostics, [&](const Diagnostic& each) {
        return each.id == "draw-W07" &&
               std::ranges::any_of(loaded->scene().variables, [&](const auto& variable) {
                   return variable.bound && variable.name == each.subject;
               });
    });
    return values;
}

/// One way of drawing a scene.
struct DrawnBound {
    image::Image picture{};
    Timing time{};
};

Result<DrawnBound> drawnWith(Bench& bench, gpu::Context& context, const ShippedScene& scene,
                             const std::vector<std::string>& set) {
    RenderOptions options;
    options.set = set;
    options.samples = 1;
    Result<image::Image> picture = scenePicture(context, scene.path, options);
    if (!picture) return std::move(picture.diagnostics);
    DrawnBound drawn{std::move(*picture)};
    drawn.time = bench.time([&] { (void)scenePicture(context, scene.path, options); }, .2);
    return drawn;
}

}  // namespace

Result<std::vector<Figure>> measureBounds(Bench& bench) {
    const Result<gpu::Context*> context = bench.context();
    if (!context) return context.diagnostics;
    const Result<std::vector<ShippedScene>> scenes = shippedScenes();
    if (!scenes) return scenes.diagnostics;
    std::vector<Figure> figures;
    for (const double bound : {.5, 1., 4.}) {
        if (bench.isQuick() && bound != 1) continue;
        figures.push_back(
            {.name = fmt::format("bound-{}", bound == .5 ? "half" : fmt::format("{:.0f}", bound)),
             .title = fmt::format("Scenes with Bound under --max-error {}px", bound),
             .settingName = "scene",
             .errorName = "contours of 98 of 100 squares",
             .errorUnit = "pixels",
             .reference =
                 "the picture of full size with the finest values; what chooses sees small pictures only",
             .curves = {{"--max-error"}, {"values of the scene"}, {"finest values"}},
             .alternatives = Alternatives::none});
    }
    std::vector<double> worst(figures.size());
    std::vector<std::string> worstScene(figures.size(), "none"), unknown(figures.size());
    std::vector<std::string> failures;
    std::vector<double> chosenTime(figures.size()), finestTime(figures.size());
    int count = 0;
    for (const ShippedScene& scene : *scenes) {
        const Result<BoundValues> own = valuesWith(**context, scene, {});
        if (!own || own->set.empty()) continue;
        if (bench.isQuick() && count >= 3) break;
        ++count;
        const Result<DrawnBound> finest = drawnWith(bench, **context, scene, own->finest);
        const Result<DrawnBound> stated = drawnWith(bench, **context, scene, own->set);
        if (!finest || !stated) {
            const Diagnostics& reasons = finest ? stated.diagnostics : finest.diagnostics;
            failures.push_back(fmt::format("{} cannot be drawn: {}", scene.name,
                                           reasons.empty() ? "" : toString(reasons.front())));
            continue;
        }
        const auto pointOf = [&](const DrawnBound& drawn) {
            return Point{
                .setting = static_cast<double>(count),
                .label = scene.name,
                .error = budget::ContourShifts(drawn.picture, finest->picture).ofChangesAbove(kVisible),
                .time = drawn.time};
        };
        for (std::size_t i = 0; i < figures.size(); ++i) {
            RenderOptions options;
            options.maxError = figures.size() == 1 ? 1. : std::array{.5, 1., 4.}.at(i);
            const Result<BoundValues> values = valuesWith(**context, scene, options);
            if (!values) return values.diagnostics;
            const Result<DrawnBound> chosen = drawnWith(bench, **context, scene, values->set);
            if (!chosen) return chosen.diagnostics;
            Figure& figure = figures[i];
            figure.curves[0].points.push_back(pointOf(*chosen));
            figure.curves[1].points.push_back(pointOf(*stated));
            figure.curves[2].points.push_back(pointOf(*finest));
            if (values->isKept) {
                unknown[i] += (unknown[i].empty() ? "" : ", ") + scene.name;
                continue;
            }
            chosenTime[i] += chosen->time.median;
            finestTime[i] += finest->time.median;
            const double ratio = figure.curves[0].points.back().error / options.maxError;
            if (ratio > worst[i]) {
                worst[i] = ratio;
                worstScene[i] = scene.name;
            }
            const double colored = budget::ContourShifts(chosen->picture, finest->picture)
                                       .shareOfSmoothChangesAbove(kVisible, options.maxError);
            if (colored > kMostColored)
                figure.findings.push_back(fmt::format("{}: {} of 1000 pixels have another colour", scene.name,
                                                      numberText(1000 * colored)));
        }
    }
    if (count == 0) return diagnose("file-E01", "no scene of the library that has a Bound can be drawn");
    for (std::size_t i = 0; i < figures.size(); ++i) {
        figures[i].findings.insert(
            figures[i].findings.begin(),
            {fmt::format("the worst error is {:.2f} of the bound ({}), of {} scenes", worst[i], worstScene[i],
                         count),
             fmt::format("with the finest values all pictures take {:.2f} times as long",
                         finestTime[i] / std::max(chosenTime[i], 1e-9)),
             unknown[i].empty() ? std::string("every value is chosen")
                                : "not chosen, with a warning, in " + unknown[i]});
        figures[i].findings.insert(figures[i].findings.end(), failures.begin(), failures.end());
    }
    return figures;
}

}  // namespace glibra::bench
