#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>

#include "bench/subjects/scene_pictures.h"
#include "bench/subjects/subjects.h"

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

}  // namespace glibra::bench
