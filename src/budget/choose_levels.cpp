#include "budget/choose_levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "budget/least_levels.h"
#include "budget/pixel_text.h"

namespace glibra::budget {
namespace {

/// The surfaces of some draws as finely as the driver can show them, to compare levels with.
class Reference {
  public:
    /// Nothing if they cannot be captured.
    static std::optional<Reference> of(const std::vector<TessellatedDraw>& draws, const Request& request) {
        Reference made(draws, request);
        for (const TessellatedDraw& each : draws) {
            auto finest = request.patches(each.pass, each.step, {{}, double(request.mostLevel)});
            if (!finest) return std::nullopt;
            made.finest_.push_back(std::move(*finest));
        }
        const std::optional<double> rest = made.difference({{}, request.mostLevel / 2.});
        if (!rest) return std::nullopt;
        made.own_ = *rest / 3;
        return made;
    }

    /// The error of the finest surface, in pixels: the error falls with the square of the level, so it is a
    /// third of the difference that halving the levels makes.
    [[nodiscard]] double own() const { return own_; }

    /// The largest error in pixels with these values; that of the finest surface is included.
    [[nodiscard]] std::optional<double> error(std::span<const LevelValue> values) const {
        const std::optional<double> found = difference({values});
        return found ? std::optional(*found + own_) : std::nullopt;
    }

  private:
    Reference(const std::vector<TessellatedDraw>& draws, const Request& request)
        : draws_(draws), request_(request) {}

    [[nodiscard]] std::optional<double> difference(const Levels& levels) const {
        double largest = 0;
        for (std::size_t draw = 0; draw < draws_.size(); ++draw) {
            const TessellatedDraw& of = draws_[draw];
            const auto coarse = request_.patches(of.pass, of.step, levels);
            const std::vector<Patch>& fine = finest_[draw];
            if (!coarse || coarse->size() != fine.size()) return std::nullopt;
            for (std::size_t i = 0; i < fine.size(); ++i) {
                if ((*coarse)[i].vertices.empty()) continue;  // the scene culls it
                const std::optional<double> pixels = patchError((*coarse)[i], fine[i], of.size);
                if (!pixels) return std::nullopt;
                largest = std::max(largest, *pixels);
            }
        }
        return largest;
    }

    const std::vector<TessellatedDraw>& draws_;
    const Request& request_;
    std::vector<std::vector<Patch>> finest_;  ///< by draw
    double own_ = 0;
};

/// The program's name as plan::Override::program has it.
std::string programOf(const scene::Scene& scene, const plan::PlannedProgram& planned) {
    return std::to_string(scene.programs[planned.variant.program].place.line);
}

/// Why comparing levels would not show how far the picture is off; empty: it shows it.
std::string whyUnknown(const plan::ProgramInterface& program) {
    for (const glsl::TranslatedStage& each : program.facts.stages) {
        if (each.stage == glsl::Stage::geometry) return "its geometry stage works on individual triangles";
        if (each.stage == glsl::Stage::tessEvaluation &&
            each.source.find("gl_TessLevel") != std::string::npos)
            return "its evaluation stage reads the levels";
    }
    return {};
}

/// "uOuter 8, uInner 4"
std::string namedValues(const plan::PlannedProgram& planned, const std::vector<LevelValue>& values) {
    std::string text;
    for (const LevelValue& each : values)
        text += fmt::format("{}{} {:.4g}", text.empty() ? "" : ", ",
                            at(planned.interface->uniforms, each.uniform).name, each.value);
    return text;
}

/// "8, 4"
std::string statedValues(const std::vector<LevelUniform>& levels) {
    std::string text;
    for (const LevelUniform& each : levels)
        text += fmt::format("{}{:.4g}", text.empty() ? "" : ", ", each.value);
    return text;
}

void chooseFor(const scene::Scene& scene, const plan::PlannedProgram& planned,
               const std::vector<TessellatedDraw>& draws, const Request& request, ChosenLevels& chosen) {
    const scene::Draw& first = *draws.front().draw;
    const auto decide = [&](std::string why) {
        chosen.decisions.push_back({first.word, std::move(why), first.place});
    };
    const auto give = [&](const std::string& why) {
        decide("kept: " + why + ", so no bound is known");
        chosen.unknown.push_back({&first, why});
    };
    if (!request.patches) return;
    if (planned.interface->facts.tessellationOutput == "points")
        return decide("kept: its program shows single vertices");
    if (const std::string why = whyUnknown(*planned.interface); !why.empty()) return give(why);
    const std::optional<Reference> reference = Reference::of(draws, request);
    if (!reference) return give("what its tessellation does cannot be measured");

    LevelsRequest levels{levelUniforms(planned, request.mostLevel), request.overrideCounts, request.maxError,
                         [&](std::span<const LevelValue> values) { return reference->error(values); }};
    const std::size_t all = levels.uniforms.size();
    std::erase_if(levels.uniforms, [&](const LevelUniform& each) {
        const std::string& name = at(planned.interface->uniforms, each.uniform).name;
        return std::ranges::any_of(request.overrides,
                                   [&](const plan::Override& set) { return set.name == name; });
    });
    const bool areSet = levels.uniforms.size() < all;
    levels.isFree = levels.isFree && !levels.uniforms.empty();
    const std::optional<LeastLevels> found = leastLevels(levels);
    if (!found) return give("what its tessellation does cannot be measured");
    if (!std::isfinite(found->pixels)) return give("it reaches behind the eye");

    std::string with = namedValues(planned, found->values);
    std::string why = with + " as the scene states";
    Miss miss{found->pixels, &first, first.word, with, !levels.isFree};
    if (levels.isFree) {
        why = with + " in place of " + statedValues(levels.uniforms);
        for (const auto& [uniform, value] : found->values)
            chosen.overrides.push_back({at(planned.interface->uniforms, uniform).name,
                                        glib::UniformForm::number,
                                        {value},
                                        programOf(scene, planned)});
        // More does not help where other levels than those of the uniforms are too low.
        const bool areHighest = std::ranges::none_of(
            levels.uniforms, [&](const LevelUniform& each) { return each.most < request.mostLevel; });
        if (areHighest && reference->own() <= request.maxError) {
            miss.isStated = true;
            miss.fixedBy = "no uniform of the Program line decides its other levels alone";
        }
    } else if (levels.uniforms.empty()) {
        why = areSet ? "the levels of --set" : "the levels that its program has";
        miss.with = why;
        miss.fixedBy = areSet ? "--set states them" : "no uniform of the Program line decides them alone";
    }
    decide(fmt::format("{}: at most {}", why, pixelText(found->pixels)));
    if (!found->isKept) chosen.misses.push_back(std::move(miss));
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
