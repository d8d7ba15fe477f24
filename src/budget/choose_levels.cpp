#include "budget/choose_levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

#include "budget/least_levels.h"
#include "budget/pixel_text.h"

namespace glibra::budget {
namespace {

/// Returns the largest difference in pixels between the draws' patches; nothing if it cannot be measured.
std::optional<double> levelError(const std::vector<TessellatedDraw>& draws, const Request& request,
                                 std::span<const LevelValue> coarse, std::span<const LevelValue> fine) {
    double largest = 0;
    for (const TessellatedDraw& draw : draws) {
        const auto from = request.patches(draw.pass, draw.step, coarse);
        const auto to = request.patches(draw.pass, draw.step, fine);
        if (!from || !to || from->size() != to->size()) return std::nullopt;
        for (std::size_t i = 0; i < from->size(); ++i) {
            const std::optional<double> pixels = patchError((*from)[i], (*to)[i], draw.size);
            if (!pixels) return std::nullopt;
            largest = std::max(largest, *pixels);
        }
    }
    return largest;
}

/// The program's name as plan::Override::program has it.
std::string programOf(const scene::Scene& scene, const plan::PlannedProgram& planned) {
    return std::to_string(scene.programs[planned.variant.program].place.line);
}

void chooseFor(const scene::Scene& scene, const plan::PlannedProgram& planned,
               const std::vector<TessellatedDraw>& draws, const Request& request, ChosenLevels& chosen) {
    LevelsRequest levels{
        levelUniforms(planned, request.mostLevel), request.overrideCounts, request.maxError, {}};
    const auto& uniforms = planned.interface->uniforms;
    const auto nameOf = [&](plan::UniformIndex uniform) { return at(uniforms, uniform).name; };
    std::erase_if(levels.uniforms, [&](const LevelUniform& each) {
        return std::ranges::any_of(
            request.overrides, [&](const plan::Override& set) { return set.name == nameOf(each.uniform); });
    });
    if (levels.uniforms.empty() || !request.patches) return;
    levels.error = [&](std::span<const LevelValue> coarse, std::span<const LevelValue> fine) {
        return levelError(draws, request, coarse, fine);
    };
    const std::optional<LeastLevels> found = leastLevels(levels);
    const scene::Draw& first = *draws.front().draw;
    const auto decide = [&](std::string why) {
        chosen.decisions.push_back({first.word, std::move(why), first.place});
    };
    if (!found) return decide("kept: what its tessellation does cannot be measured");

    std::string values, before;
    for (std::size_t i = 0; i < found->values.size(); ++i) {
        const auto& [uniform, value] = found->values[i];
        const std::string_view comma = i > 0 ? ", " : "";
        values += fmt::format("{}{} {:.4g}", comma, nameOf(uniform), value);
        before += fmt::format("{}{:.4g}", comma, levels.uniforms[i].value);
    }
    decide(fmt::format("{}{}: at most {}", values,
                       levels.isFree ? " in place of " + before : " as the scene states",
                       pixelText(found->pixels)));
    if (levels.isFree)
        for (const auto& [uniform, value] : found->values)
            chosen.overrides.push_back(
                {nameOf(uniform), glib::UniformForm::number, {value}, programOf(scene, planned)});
    if (!found->isKept) chosen.misses.push_back({found->pixels, &first, first.word, values, !levels.isFree});
}

}  // namespace

ChosenLevels chooseLevels(const scene::Scene& scene, const plan::FramePlan& plan,
                          const std::map<plan::PlannedProgramIndex, std::vector<TessellatedDraw>>& draws,
                          const Request& request) {
    ChosenLevels chosen;
    for (const auto& [program, each] : draws) chooseFor(scene, plan.programs[program], each, request, chosen);
    return chosen;
}

}  // namespace glibra::budget
