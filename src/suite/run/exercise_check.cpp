#include "suite/run/exercise_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "image/compare/judge.h"
#include "suite/run/shot_renderer.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

/// A little more than what drivers differ by (image::Tolerance), because another order of the same sums
/// rounds differently.
image::Tolerance solvedTolerance() {
    image::Tolerance tolerance;
    tolerance.largest = 4;
    tolerance.fraction = .001;
    tolerance.cluster = 16;
    tolerance.line = 24;
    tolerance.bias = 1.5;
    return tolerance;
}

std::string percent(double share) {
    return share < .001 ? "less than 0.1 %" : fmt::format("{:.3g} %", 100 * share);
}

std::string whyOtherColors(const ColorShare& has, const image::Image& own) {
    const auto components = static_cast<std::size_t>(own.components);
    std::size_t count = 0;
    for (int y = 0; y < own.height; ++y) {
        const std::span<const std::byte> row = own.row(y);
        for (std::size_t x = 0; x < row.size(); x += components)
            count += std::ranges::all_of(std::array{0U, 1U, 2U}, [&](std::size_t i) {
                const double value =
                    std::to_integer<int>(row[x + std::min(std::size_t{i}, components - 1)]) / 255.;
                return std::abs(value - has.color.at(i)) <= has.within;
            });
    }
    const double share = static_cast<double>(count) / std::max(1., 1. * own.width * own.height);
    if (share >= has.least && share <= has.most) return {};
    return fmt::format("{} of its picture has the colour {:g} {:g} {:g}, expected {:g} to {:g} %",
                       percent(share), has.color[0], has.color[1], has.color[2], 100 * has.least,
                       100 * has.most);
}

Diagnostics unsolved(const fs::path& scene, const std::string& label, const std::string& why) {
    return {diagnose("check-E04",
                     "the exercise is not solved yet: " + (label.empty() ? why : "at " + label + " " + why),
                     {scene.generic_string(), 1, 1})};
}

Diagnostics errorsOf(Diagnostics diagnostics) {
    std::erase_if(diagnostics, [](const Diagnostic& each) { return each.severity != Severity::error; });
    return diagnostics;
}

}  // namespace

std::string whyUnsolved(const std::optional<ColorShare>& has, const image::Image& solution,
                        const image::Image& own) {
    if (has) return whyOtherColors(*has, own);
    const image::Judgement found = image::judge(solution, own, solvedTolerance());
    if (found.same) return {};
    if (found.decidedBy == image::Rung::size)
        return fmt::format("its picture has {} x {} pixels, the solution's {} x {}", own.width, own.height,
                           solution.width, solution.height);
    if (found.decidedBy == image::Rung::bias)
        return fmt::format("its picture is lighter or darker than the solution's around {}, {}", found.biasX,
                           found.biasY);
    return fmt::format("its picture differs from the solution's in {} of the pixels, most at {}, {}",
                       percent(static_cast<double>(found.beyond) / (1. * own.width * own.height)),
                       found.comparison.x, found.comparison.y);
}

Diagnostics checkExercise(gpu::Context& context, const fs::path& scene, const RenderOptions& options,
                          const std::function<void()>& drawn) {
    const fs::path file = exerciseFileOf(scene);
    const Result<Exercise> exercise = readExercise(file);
    if (!exercise) return exercise.diagnostics;
    RenderOptions common = options;
    common.set.clear();  // values and times are those of the file
    common.time = 0;
    Result<std::vector<Moment>> moments = momentsOf(*exercise, file, common);
    if (!moments) return std::move(moments.diagnostics);
    ShotRenderer ofSolution(context), ofOwn(context);
    for (Moment& each : *moments) {
        Rendering solution = ofSolution.render(each.shot);
        drawn();
        if (!solution.picture) return errorsOf(std::move(solution.diagnostics));
        each.shot.script = scene;
        each.shot.options.width = solution.picture->width;
        each.shot.options.height = solution.picture->height;
        Rendering own = ofOwn.render(each.shot);
        drawn();
        const auto missing = std::ranges::find(own.diagnostics, "suite-E19", &Diagnostic::id);
        if (missing != own.diagnostics.end()) return unsolved(scene, "", missing->text);
        if (!own.picture) return errorsOf(std::move(own.diagnostics));
        if (const std::string why = whyUnsolved(each.has, *solution.picture, *own.picture); !why.empty())
            return unsolved(scene, each.label, why);
    }
    return {diagnose("check-N03",
                     moments->size() == 1
                         ? std::string("the exercise is solved")
                         : fmt::format("the exercise is solved, with {} sets of values", moments->size()),
                     {scene.generic_string(), 1, 1})};
}

}  // namespace glibra::suite
