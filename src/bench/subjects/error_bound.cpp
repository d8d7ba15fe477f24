#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>

#include "bench/subjects/scene_pictures.h"
#include "bench/subjects/subjects.h"
#include "budget/contour_shift.h"
#include "render/scene_renderer.h"

namespace glibra::bench {
namespace {

constexpr double kBound = .25;  ///< pixels
/// Displacements are measured in a picture that is larger by this factor, where the bound is one pixel.
constexpr int kEnlarged = 4;
constexpr int kMostDisplacement = 12;  ///< enlarged pixels
/// Counts grow with the square root: the reference is four times as fine.
constexpr double kReferenceBound = kBound / 16;

/// The ways to draw a scene.
struct BudgetWay {
    const char* name;
    double maxError = 0;
    bool overrideCounts = false;
    bool isBounded = false;  ///< by kBound
};
constexpr std::array<BudgetWay, 4> kBudgetWays{{{"default"},
                                                {"--max-error", kBound, false, true},
                                                {"--max-error --override-counts", kBound, true, true},
                                                {"four times as fine", kReferenceBound, true}}};

/// One scene with each of the ways.
struct SceneRow {
    std::string name;
    struct Setting {
        double off = 0;           ///< pixels
        bool isReported = false;  ///< the program reports that it does not keep the bound
        Timing time{};
        double bytes = 0;
    };
    std::array<Setting, 4> settings{};
};

/// draw-W07: the bound cannot be kept; draw-N03: it is not kept, because the scene states its numbers;
/// draw-N05: none is known, because a program moves the vertices.
bool tellsOfTheBound(const Diagnostics& diagnostics) {
    return std::ranges::any_of(diagnostics, [](const Diagnostic& each) {
        return each.id == "draw-W07" || each.id == "draw-N03" || each.id == "draw-N05";
    });
}

SceneRow measuredRow(Bench& bench, const ShippedScene& scene) {
    RenderOptions plain;
    if (bench.isQuick()) plain.width = plain.height = 100;
    const image::Image first = need(scenePicture(bench.context(), scene.path, plain));
    const auto optionsOf = [&](const BudgetWay& way) {
        RenderOptions options = plain;
        options.maxError = way.maxError;
        options.overrideCounts = way.overrideCounts;
        return options;
    };
    // The same meshes in a larger picture: a bound in pixels grows with it.
    const auto enlarged = [&](const BudgetWay& way) {
        RenderOptions options = optionsOf(way);
        options.width = kEnlarged * first.width;
        options.height = kEnlarged * first.height;
        options.maxError *= kEnlarged;
        options.samples = 1;
        return scenePicture(bench.context(), scene.path, options);
    };
    const image::Image reference = need(enlarged(kBudgetWays.back()));
    SceneRow row{scene.name};
    for (std::size_t i = 0; i < kBudgetWays.size(); ++i) {
        const Result<image::Image> large = enlarged(kBudgetWays[i]);
        if (!large) throw Failed(large.diagnostics);
        // Only meshes and noise are compared: all pictures have the default number of samples.
        RenderOptions timed = optionsOf(kBudgetWays[i]);
        timed.samples = 1;
        const DrawnScene drawn = drawnScene(bench, scene.path, timed);
        row.settings[i] = {
            static_cast<double>(displacement(*large, reference, kMostDisplacement)) / kEnlarged,
            tellsOfTheBound(large.diagnostics), drawn.time, drawn.bytes};
    }
    return row;
}

/// How many scenes keep the bound, which one is worst, and the total time; and which scenes break the bound
/// without a report by the program.
std::string finding(const std::vector<SceneRow>& rows, std::size_t way) {
    const auto offOf = [&](const SceneRow& each) { return each.settings[way].off; };
    const auto worst = std::ranges::max_element(rows, {}, offOf);
    const auto kept =
        std::ranges::count_if(rows, [&](const SceneRow& each) { return offOf(each) <= kBound; });
    std::string text =
        fmt::format("{}: {} of {} scenes within {} px, the worst {} px{} ({})", kBudgetWays.at(way).name,
                    kept, rows.size(), kBound, numberText(offOf(*worst)),
                    offOf(*worst) * kEnlarged > kMostDisplacement ? " or more" : "", worst->name);
    std::vector<std::string> silent;
    double total = 0;
    for (const SceneRow& each : rows) {
        if (offOf(each) > kBound && !each.settings[way].isReported) silent.push_back(each.name);
        total += each.settings[way].time.median;
    }
    if (kBudgetWays.at(way).isBounded && kept < std::ssize(rows))
        text += silent.empty() ? "; the program reports all others"
                               : fmt::format("; without a word: {}", fmt::join(silent, ", "));
    return text + fmt::format("; all together {}", secondsText(total));
}

}  // namespace

std::vector<Figure> measureBudget(Bench& bench) {
    std::vector<SceneRow> rows;
    const std::vector<std::string> failures =
        forEachScene(bench, bench.pick<std::size_t>(3, 1),
                     [&](const ShippedScene& scene) { rows.push_back(measuredRow(bench, scene)); });
    std::ranges::stable_sort(rows, std::ranges::greater(),
                             [](const SceneRow& each) { return each.settings[0].off; });
    Figure figure{.name = "bound",
                  .title = fmt::format("Shipped scenes under --max-error {}px", kBound),
                  .settingName = "rank of the scene",
                  .errorName = "displacement",
                  .errorUnit = "pixels",
                  .reference =
                      "pictures four times as large with meshes and noise four times as fine: the radius "
                      "within which all but 1 of 1000 pixels find their value",
                  .alternatives = Alternatives::none};
    for (std::size_t way = 0; way < kBudgetWays.size(); ++way) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const SceneRow::Setting& each = rows[i].settings[way];
            figure.add(kBudgetWays[way].name,
                       {static_cast<double>(i + 1), rows[i].name, each.off, each.time, each.bytes});
        }
        figure.findings.push_back(finding(rows, way));
    }
    figure.findings.insert(figure.findings.end(), failures.begin(), failures.end());
    return {std::move(figure)};
}

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
