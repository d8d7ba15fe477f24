#pragma once
// Private to this room: the programs of a plan, each once, with what they read and write.

#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "plan/accesses.h"
#include "plan/answers.h"
#include "plan/frame_plan.h"
#include "plan/texture_binding.h"

namespace glibra::plan {

/// Adds programs and vertex inputs to a plan and answers what draws and dispatches do with objects.
class PlannedPrograms {
  public:
    /// All of them must outlive this.
    PlannedPrograms(const scene::Scene& scene, const Answers& answers, const PlanOptions& options,
                    Questions& questions, FramePlan& plan)
        : scene_(scene), answers_(answers), options_(options), questions_(questions), plan_(plan) {
        plan.usedOverrides.resize(options.overrides.size());
    }

    /// The planner's private data about a PlannedProgram.
    struct State {
        Diagnostics diagnostics;  ///< from translating, compiling and linking, and about its pairs
        std::vector<UnitUse> units;
        Diagnostics unitProblems;                ///< draw-E13, reported at each draw
        Diagnostics badBindings;                 ///< draw-E09, draw-E10: nothing is drawn with it
        std::vector<scene::ObjectView> refused;  ///< UniformResolution::refusedImages
        bool isAnnounced = false;                ///< its diagnostics are in the plan
        PlannedProgramIndex other{};             ///< another variant with the same values, or none
    };

    PlannedProgramIndex of(const scene::Draw& draw, const scene::Pass& pass) {
        return of(variantOf(scene_, draw, pass), draw.uniforms, draw.place.file);
    }
    PlannedProgramIndex of(const scene::Dispatch& dispatch) {
        const bool isCut =
            options_.cutsDispatches && !std::holds_alternative<scene::GroupsFrom>(dispatch.groups);
        ProgramVariant variant = plainVariant(scene_, dispatch.program);
        variant.inPieces = isCut || dispatch.tiles > 1;
        return of(variant, dispatch.uniforms, dispatch.place.file);
    }
    /// Returns the index of the variant with these values in the plan. One whose interface is not known is
    /// asked for, and not usable.
    /// `file`: of the statement that gives the values, for messages.
    PlannedProgramIndex of(const ProgramVariant& variant, scene::UniformSetIndex uniforms = {},
                           const std::string& file = {});

    State& state(PlannedProgramIndex program) { return states_[program]; }
    [[nodiscard]] const PlannedProgram& operator[](PlannedProgramIndex program) const {
        return plan_.programs[program];
    }
    /// The program as the scene states it; null for the built-in one.
    [[nodiscard]] const scene::Program* declared(scene::ProgramIndex index) const {
        return index ? &scene_.programs[index] : nullptr;
    }

    /// The textures that a draw's samplers read. Draws with equal program, slots and wrap share them.
    template <class Reader>  // Draw or Dispatch
    const std::vector<TextureUse>& texturesOf(const Reader& reader, PlannedProgramIndex program) {
        static const std::vector<TextureUse> kNone;
        if (state(program).units.empty()) return kNone;
        const auto [entry, isNew] = uses_.try_emplace({program, reader.slots, reader.sampling.clamp});
        if (isNew)
            entry->second = textureUses(scene_, reader.slots, reader.sampling, *(*this)[program].interface,
                                        state(program).units);
        return entry->second;
    }
    PlannedInputsIndex inputsOf(const scene::Draw& draw, PlannedProgramIndex program);

    /// What a draw does with objects, besides the targets of its pass. Images that are refused count as
    /// written, so that the draw is needed and its error reported.
    std::vector<ObjectUse> usesOf(const scene::Draw& draw, const scene::Pass& pass);
    std::vector<ObjectUse> usesOf(const scene::Dispatch& dispatch);
    /// False, too, if it is not known yet.
    bool mayWrite(const scene::Draw& draw);

  private:
    void resolve(PlannedProgram& program, State& state, scene::UniformSetIndex uniforms,
                 const std::string& file);
    void addRefused(PlannedProgramIndex program, std::vector<ObjectUse>& to);
    int loopLimit();

    const scene::Scene& scene_;
    const Answers& answers_;
    const PlanOptions& options_;
    Questions& questions_;
    FramePlan& plan_;
    std::vector<PlannedProgramIndex> withValues_;  ///< by place of the uniform set, from 1; 0: of none
    scene::List<State, PlannedProgram> states_;
    std::map<std::tuple<PlannedProgramIndex, scene::SlotTableIndex, bool>, std::vector<TextureUse>> uses_;
    /// Values of uniforms do not matter, so that draws that differ only in them share a vertex array.
    std::map<std::pair<ProgramVariant, scene::AttributeSetIndex>, PlannedInputsIndex> inputs_;
};

}  // namespace glibra::plan
