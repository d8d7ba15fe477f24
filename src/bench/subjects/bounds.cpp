#include <algorithm>
#include <array>

#include "bench/subjects/scene_pictures.h"
#include "bench/subjects/subjects.h"
#include "budget/contour_shift.h"
#include "render/scene_renderer.h"

namespace glibra::bench {
namespace {

constexpr double kVisibleChange = 8. / 255;
constexpr double kMostColored = .002;  ///< twice what small pictures allow

/// The names and values of the Bound variables of a scene.
struct BoundValues {
    std::vector<std::string> set{}, finest{};  ///< "NAME=VALUE": as they are, and the finest
    bool isKept = false;                       ///< the program reports that something is not chosen
};

BoundValues valuesWith(Bench& bench, const ShippedScene& scene, const RenderOptions& options) {
    render::Stats stats;
    Result<render::SceneRenderer> loaded =
        render::SceneRenderer::load(bench.context(), scene.path, options, stats);
    const Diagnostics remarks = loaded.diagnostics;
    const render::SceneRenderer renderer = need(std::move(loaded));
    BoundValues values;
    for (const scene::Variable& each : renderer.scene().variables) {
        if (!each.bound) continue;
        values.set.push_back(fmt::format("{}={}", each.name, each.current.front()));
        values.finest.push_back(fmt::format("{}={}", each.name, each.bound->finest));
        for (const Diagnostic& remark : remarks)
            values.isKept |= remark.id == "draw-W07" && remark.subject == each.name;
    }
    return values;
}

DrawnScene drawnWith(Bench& bench, const ShippedScene& scene, const std::vector<std::string>& set) {
    RenderOptions options;
    options.set = set;
    options.samples = 1;
    return drawnScene(bench, scene.path, options, .2);
}

/// One bound, and what is found of it.
struct MeasuredBound {
    double bound = 1;
    Figure figure{};
    double worst = 0, chosenTime = 0, finestTime = 0;
    std::string worstScene = "none", unknown{};
};

}  // namespace

std::vector<Figure> measureBounds(Bench& bench) {
    std::vector<MeasuredBound> bounds;
    for (const double bound : bench.pick(std::vector{1.}, {.5, 1., 4.}))
        bounds.push_back(
            {bound,
             {.name = fmt::format("bound-{}", bound == .5 ? "half" : fmt::format("{:.0f}", bound)),
              .title = fmt::format("Scenes with Bound under --max-error {}px", bound),
              .settingName = "scene",
              .errorName = "contours of 98 of 100 squares",
              .errorUnit = "pixels",
              .reference =
                  "the picture of full size with the finest values; what chooses sees small pictures only",
              .alternatives = Alternatives::none}});
    int count = 0;
    const std::vector<std::string> failures = forEachScene(bench, 1, [&](const ShippedScene& scene) {
        BoundValues own;
        try {
            own = valuesWith(bench, scene, {});
        } catch (const Failed&) {  // it cannot be drawn, with or without a bound
        }
        if (own.set.empty() || (bench.isQuick() && count >= 3)) return;
        ++count;
        const DrawnScene finest = drawnWith(bench, scene, own.finest),
                         stated = drawnWith(bench, scene, own.set);
        for (MeasuredBound& each : bounds) {
            RenderOptions options;
            options.maxError = each.bound;
            const BoundValues values = valuesWith(bench, scene, options);
            const DrawnScene chosen = drawnWith(bench, scene, values.set);
            const budget::ContourShifts shifts(chosen.picture, finest.picture);
            for (const auto& [curve, drawn] : {std::pair("--max-error", &chosen),
                                               {"values of the scene", &stated},
                                               {"finest values", &finest}})
                each.figure.add(
                    curve,
                    {1. * count, scene.name,
                     budget::ContourShifts(drawn->picture, finest.picture).ofChangesAbove(kVisibleChange),
                     drawn->time});
            if (values.isKept) {
                each.unknown += (each.unknown.empty() ? "" : ", ") + scene.name;
                continue;
            }
            each.chosenTime += chosen.time.median;
            each.finestTime += finest.time.median;
            const double ratio = each.figure.last(0).error / each.bound;
            if (ratio > each.worst) {
                each.worst = ratio;
                each.worstScene = scene.name;
            }
            const double colored = shifts.shareOfSmoothChangesAbove(kVisibleChange, each.bound);
            if (colored > kMostColored)
                each.figure.note("{}: {} of 1000 pixels have another colour", scene.name,
                                 numberText(1000 * colored));
        }
    });
    if (count == 0)
        throw Failed({diagnose("bench-E05", "no scene of the library that has a Bound can be drawn")});
    std::vector<Figure> figures;
    for (MeasuredBound& each : bounds) {
        std::vector<std::string>& findings = each.figure.findings;
        findings.insert(findings.begin(),
                        {fmt::format("the worst error is {:.2f} of the bound ({}), of {} scenes", each.worst,
                                     each.worstScene, count),
                         fmt::format("with the finest values all pictures take {:.2f} times as long",
                                     each.finestTime / std::max(each.chosenTime, 1e-9)),
                         each.unknown.empty() ? "every value is chosen"
                                              : "not chosen, with a warning, in " + each.unknown});
        findings.insert(findings.end(), failures.begin(), failures.end());
        figures.push_back(std::move(each.figure));
    }
    return figures;
}

}  // namespace glibra::bench
