#include "plan/frame_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "plan/loop_rounds.h"
#include "plan/needs.h"
#include "plan/overrides.h"
#include "plan/skipped.h"
#include "plan/submission.h"
#include "plan/texture_uses.h"
#include "plan/uniform_names.h"
#include "scene/primitives.h"

namespace glibra::plan {
namespace {

/// The planner's private data about a PlannedProgram.
struct ProgramState {
    Diagnostics diagnostics;  ///< from translating, compiling and linking, and about its pairs
    std::vector<UnitUse> units;
    Diagnostics unitProblems;  ///< draw-E05, reported at each draw
    bool isAnnounced = false;  ///< its diagnostics are in the plan
};

class FramePlanner {
  public:
    FramePlanner(const scene::Scene& scene, const InterfaceOf& interfaceOf, const PlanOptions& options)
        : scene_(scene),
          interfaceOf_(interfaceOf),
          options_(options),
          usedOverrides_(options.overrides.size()),
          meshOfShape_(scene.shapes.size()),
          reads_(scene.shapes.size()) {}

    FramePlan plan(const MayWriteImages& mayWriteImages) && {
        plan_.nodes = &scene_.frame;
        const TexturesOf texturesOf = [this](const scene::Draw& draw, const scene::Pass& pass) {
            std::vector<scene::TextureIndex> textures;
            for (const TextureUse& use : usesOf(draw, programOf(draw, pass))) textures.push_back(use.texture);
            return textures;
        };
        const Needs needs = findNeeds(
            scene_, {texturesOf, mayWriteImages, options_.everything ? OutOfSight() : options_.outOfSight},
            options_.everything);
        for (std::size_t pass = 0; pass < scene_.frame.passes.size(); ++pass)
            if (needs.passes[pass]) planPass(pass, needs.steps[pass]);
        if (options_.everything) planUndrawnPrograms();
        for (const scene::TextureIndex each : scene_.textures.indices())
            if (needs.textures[each]) plan_.textures.push_back(each);
        listAttributes();
        reportOverrides();
        if (!options_.everything) plan_.skipped = listSkipped(scene_, needs, plan_);
        return std::move(plan_);
    }

  private:
    using VariantKey = std::tuple<scene::ProgramIndex, bool, int, scene::UniformSetIndex>;

    const scene::Program* sceneProgram(scene::ProgramIndex index) const {
        return index ? &scene_.programs[index] : nullptr;
    }
    ProgramState& state(PlannedProgramIndex program) { return states_[program]; }
    const PlannedProgram& planned(PlannedProgramIndex program) const { return plan_.programs[program]; }

    /// Adds the diagnostic unless an equal one at the same place exists.
    void report(const Diagnostic& diagnostic) {
        if (reported_
                .emplace(diagnostic.id, diagnostic.text, diagnostic.place.file, diagnostic.place.line,
                         diagnostic.place.column)
                .second)
            plan_.diagnostics.push_back(diagnostic);
    }

    PlannedProgramIndex programOf(const scene::Draw& draw, const scene::Pass& pass) {
        return programOf(variantOf(scene_, draw, pass), draw.uniforms);
    }

    /// Returns the index of the variant with these values in the plan. The first call asks for its interface.
    PlannedProgramIndex programOf(const ProgramVariant& variant, scene::UniformSetIndex uniforms = {}) {
        PlannedProgramIndex& index =
            programs_[VariantKey{variant.program, variant.flatColors, variant.colorTargets, uniforms}];
        if (index) return index;
        const ProgramInterface& interface = interfaceOf_(variant);
        PlannedProgram program{variant, &interface, {}, {}};
        ProgramState state;
        state.diagnostics = interface.facts.diagnostics;
        if (interface.usable) {
            const scene::Program noPairs;
            const scene::Program* own = sceneProgram(variant.program);
            scene::Program merged;  // what a draw sets comes after what the Program statement sets
            if (own != nullptr && uniforms) {
                merged = *own;
                const scene::UniformSet& set = scene_.uniformSets[uniforms];
                merged.uniforms.insert(merged.uniforms.end(), set.begin(), set.end());
                own = &merged;
            }
            const std::span<const Override> overrides(options_.overrides);
            UniformResolution resolution =
                resolveUniforms(own != nullptr ? *own : noPairs, scene_.path, interface,
                                own != nullptr ? overrides : overrides.first(0), usedOverrides_);
            program.values = std::move(resolution.values);
            program.controls = std::move(resolution.controls);
            append(state.diagnostics, std::move(resolution.diagnostics));
            auto units =
                assignUnits(interface, resolution.samplers, options_.maxTextureUnits, options_.maxImageUnits);
            if (units) state.units = std::move(*units);
            state.unitProblems = std::move(units.diagnostics);
        }
        append(state.diagnostics, reportLongLoops(program, [this] { return loopLimit(); }));
        states_.push_back(std::move(state));
        return index = plan_.programs.add(std::move(program));
    }

    int loopLimit() {
        if (!loopLimit_) loopLimit_ = options_.loopLimit ? options_.loopLimit() : 0;
        return *loopLimit_;
    }

    /// The textures that a draw's samplers read. Draws with equal program, slots and wrap share them.
    const std::vector<TextureUse>& usesOf(const scene::Draw& draw, PlannedProgramIndex program) {
        const auto [entry, isNew] = uses_.try_emplace({program, draw.slots, draw.sampling.clamp});
        if (isNew)
            entry->second = textureUses(scene_, draw, *planned(program).interface, state(program).units);
        return entry->second;
    }

    void planPass(std::size_t index, const std::vector<StepNeed>& needs) {
        const scene::Pass& pass = scene_.frame.passes[index];
        PlannedPass result;
        result.pass = index;
        for (std::size_t step = 0; step < pass.steps.size(); ++step) {
            if (needs[step] != StepNeed::needed) continue;
            if (std::holds_alternative<scene::Clear>(pass.steps[step]))
                result.steps.emplace_back(PlannedClear{{index, step}});
            else
                planDraw({index, step}, result);
        }
        plan_.passes.push_back(std::move(result));
    }

    void planDraw(scene::StepIndex step, PlannedPass& result) {
        const scene::Pass& pass = scene_.frame.passes[step.pass];
        const scene::Draw& draw = scene_.frame.draw(step);
        const PlannedProgramIndex index = programOf(draw, pass);
        const ProgramInterface& interface = *planned(index).interface;
        const scene::Program* program = sceneProgram(planned(index).variant.program);
        announce(index);
        reportMissingStage(draw);

        if (!interface.usable) return planUnusable(step, index, result);
        const Result<Submission> submission = submissionOf(scene_, draw, program, interface);
        Diagnostics problems = submission.diagnostics;
        for (Diagnostic each : state(index).unitProblems) {
            each.place = draw.place;
            each.text = draw.word + ": " + each.text;
            problems.push_back(std::move(each));
        }
        const std::vector<TextureUse>& uses = usesOf(draw, index);
        append(problems, feedback(draw, pass, index, uses));
        for (const Diagnostic& each : problems) report(each);
        if (!submission || hasError(problems)) return;

        reportRemarks(draw, index, program, *submission, uses);
        result.steps.emplace_back(PlannedDraw{step, index, meshOf(draw, interface), *submission, uses});
    }

    /// The program has no usable stages, so a window shows the shape in one colour. It cannot show patches
    /// that way.
    void planUnusable(scene::StepIndex step, PlannedProgramIndex index, PlannedPass& result) {
        const scene::Draw& draw = scene_.frame.draw(step);
        const geometry::Topology topology = topologyOf(scene_.shapes[draw.shape]);
        if (topology == geometry::Topology::patches) return;
        result.steps.emplace_back(
            PlannedDraw{step, index, meshOf(draw, *planned(index).interface), {topology, 0}, {}});
    }

    void announce(PlannedProgramIndex program) {
        if (std::exchange(state(program).isAnnounced, true)) return;
        for (const Diagnostic& each : state(program).diagnostics) report(each);
    }

    /// Reports draw-W01 once per program.
    void reportMissingStage(const scene::Draw& draw) {
        if (!draw.program || !usesBuiltin(scene_, draw) || !incomplete_.insert(draw.program).second) return;
        const scene::Program& program = *sceneProgram(draw.program);
        const bool hasVertex = program.hasStage(glsl::Stage::vertex);
        const bool hasFragment = program.hasStage(glsl::Stage::fragment);
        const char* missing = hasVertex     ? "no fragment stage"
                              : hasFragment ? "no vertex stage"
                                            : "no vertex and no fragment stage";
        report(diagnose("draw-W01",
                        fmt::format("Program '{}' has {}; a flat colour is used", program.name, missing),
                        draw.place));
    }

    /// Returns draw-E01 if a sampler reads a target of its own pass.
    Diagnostics feedback(const scene::Draw& draw, const scene::Pass& pass, PlannedProgramIndex program,
                         const std::vector<TextureUse>& uses) {
        Diagnostics errors;
        std::set<int> units;
        for (std::size_t i = 0; i < uses.size(); ++i) {
            const bool isTarget =
                uses[i].texture && !uses[i].isImage &&
                std::find(pass.targets.begin(), pass.targets.end(), uses[i].texture) != pass.targets.end();
            const int unit = state(program).units.at(i).binding.unit;
            if (isTarget && units.insert(unit).second)
                errors.push_back(diagnose("draw-E01",
                                          fmt::format("{} samples unit {} while rendering into it "
                                                      "(RenderToTexture on line {})",
                                                      draw.word, unit, pass.place.line),
                                          draw.place));
        }
        return errors;
    }

    /// Reports draw-W02, W03 and W05, each only at the first draw that it applies to.
    void reportRemarks(const scene::Draw& draw, PlannedProgramIndex index, const scene::Program* program,
                       const Submission& submission, const std::vector<TextureUse>& uses) {
        reportEmptySlots(draw, index, uses);
        reportUnknownInputs(draw, index);
        if (ignoresPointSize(draw, program, *planned(index).interface, submission))
            reportIgnoredPointSize(draw, index, *program);
    }

    void warnOnce(const scene::Draw& draw, PlannedProgramIndex index, const char* id,
                  const std::string& text) {
        if (remarks_.emplace(planned(index).variant.program, id, text).second)
            report(diagnose(id, text, draw.place));
    }

    void reportEmptySlots(const scene::Draw& draw, PlannedProgramIndex index,
                          const std::vector<TextureUse>& uses) {
        for (std::size_t i = 0; i < uses.size(); ++i) {
            if (uses[i].texture) continue;
            const ActiveUniform& sampler = at(planned(index).interface->uniforms, uses[i].uniform);
            const int unit = state(index).units.at(i).binding.unit;
            const std::string slot = sampler.type.target ? slotText(unit, *sampler.type.target)
                                                         : fmt::format("{} / {}", unit, sampler.type.word);
            warnOnce(draw, index, "draw-W02",
                     fmt::format("{} '{}' reads unit {}, which is empty",
                                 uses[i].isImage ? "image" : "sampler", sampler.name, slot));
        }
    }

    void reportUnknownInputs(const scene::Draw& draw, PlannedProgramIndex index) {
        const ProgramInterface& interface = *planned(index).interface;
        for (const ActiveInput& input : interface.inputs) {
            const std::string name = userName(interface, input.name);
            if (glsl::findBuiltinInput(input.name) == nullptr && !isInternalName(name))
                warnOnce(draw, index, "draw-W03",
                         fmt::format("vertex input '{}' is not supplied; it reads 0 0 0 1", name));
        }
    }

    void reportIgnoredPointSize(const scene::Draw& draw, PlannedProgramIndex index,
                                const scene::Program& program) {
        using glsl::Stage;
        const Stage last = program.hasStage(Stage::geometry)         ? Stage::geometry
                           : program.hasStage(Stage::tessEvaluation) ? Stage::tessEvaluation
                                                                     : Stage::vertex;
        const std::string file = stageFileName(scene_, program, last);
        warnOnce(draw, index, "draw-W05",
                 fmt::format("{} writes gl_PointSize, but PointSizeMode is 0",
                             file.empty() ? "Program '" + program.name + "'" : file));
    }

    static std::string userName(const ProgramInterface& interface, const std::string& name) {
        const auto found = interface.facts.userNames.find(name);
        return found != interface.facts.userNames.end() ? found->second : name;
    }
    /// Returns the mesh of the draw's shape and records the attributes that this program reads.
    PlannedMeshIndex meshOf(const scene::Draw& draw, const ProgramInterface& interface) {
        PlannedMeshIndex& mesh = meshOfShape_[draw.shape];
        if (!mesh || !options_.shareMeshes) mesh = plan_.meshes.add({draw.shape, {}});
        for (const ActiveInput& input : interface.inputs)
            if (const glsl::BuiltinInput* row = glsl::findBuiltinInput(input.name); row != nullptr)
                reads_[draw.shape].insert(row->attribute);
        // A window shows the draws of an unusable program in one colour, so it needs their positions.
        if (!interface.usable) reads_[draw.shape].insert(geometry::kPosition);
        return mesh;
    }

    void listAttributes() {
        for (PlannedMesh& mesh : plan_.meshes) {
            for (std::string& name : attributesOf(scene_.shapes[mesh.shape]))
                if (options_.everything || reads_[mesh.shape].contains(name))
                    mesh.attributes.push_back(std::move(name));
        }
    }

    /// `glibra check` also compiles programs without draws.
    void planUndrawnPrograms() {
        std::set<scene::ProgramIndex> drawn;
        for (const PlannedProgram& each : plan_.programs) drawn.insert(each.variant.program);
        for (const scene::ProgramIndex i : scene_.programs.indices()) {
            const scene::Program& program = scene_.programs[i];
            if (drawn.contains(i) || !program.hasStage(glsl::Stage::vertex) ||
                !program.hasStage(glsl::Stage::fragment))
                continue;
            announce(programOf(ProgramVariant{i, false, 1}));
        }
    }

    /// Reports glib-W23 for `--set` names that no program has. For a program that was not asked for or did
    /// not link, only the pairs are known, so a name among them is accepted.
    void reportOverrides() {
        std::vector<std::string> names;
        for (const scene::Variable& each : scene_.variables) names.push_back(each.name);
        std::set<scene::ProgramIndex> known;
        for (const PlannedProgram& program : plan_.programs) {
            if (program.interface->usable) known.insert(program.variant.program);
            for (const ActiveUniform& uniform : program.interface->uniforms)
                if (!isInternalName(uniform.name) && suppliedBy(uniform) == nullptr)
                    names.push_back(uniform.name);
        }
        for (const scene::ProgramIndex i : scene_.programs.indices()) {
            if (known.contains(i)) continue;
            for (const glib::UniformSpec& spec : scene_.programs[i].uniforms)
                for (std::size_t each = 0; each < options_.overrides.size(); ++each)
                    if (options_.overrides[each].name == spec.tag) usedOverrides_[each] = true;
        }
        reportInactiveOverrides();
        for (const Diagnostic& each : unusedOverrides(options_.overrides, usedOverrides_, names))
            report(each);
    }

    /// Reports glib-W24 for names that are declared but not active. Drivers differ in which unused uniforms
    /// they keep.
    void reportInactiveOverrides() {
        const auto isDeclared = [this](const Override& override) {
            const auto declares = [&](const PlannedProgram& program) {
                const scene::Program* own = sceneProgram(program.variant.program);
                return own != nullptr && isFor(override, *own) &&
                       program.interface->facts.uniforms.contains(std::string(rootName(override.name)));
            };
            return std::any_of(plan_.programs.begin(), plan_.programs.end(), declares);
        };
        for (std::size_t i = 0; i < options_.overrides.size(); ++i) {
            if (usedOverrides_[i] || !isDeclared(options_.overrides[i])) continue;
            usedOverrides_[i] = true;
            report(diagnose("glib-W24",
                            fmt::format("uniform '{}' is declared but unused, so setting it has no effect",
                                        options_.overrides[i].name)));
        }
    }

    const scene::Scene& scene_;
    const InterfaceOf& interfaceOf_;
    const PlanOptions& options_;
    std::vector<bool> usedOverrides_;
    std::map<VariantKey, PlannedProgramIndex> programs_;
    scene::List<ProgramState, PlannedProgram> states_;
    std::map<std::tuple<PlannedProgramIndex, scene::SlotTableIndex, bool>, std::vector<TextureUse>> uses_;
    scene::List<PlannedMeshIndex, scene::Shape> meshOfShape_;
    scene::List<std::set<std::string_view>, scene::Shape> reads_;  ///< attributes that some program reads
    std::optional<int> loopLimit_;
    std::set<scene::ProgramIndex> incomplete_;  ///< programs of draw-W01
    std::set<std::tuple<scene::ProgramIndex, std::string, std::string>> remarks_;
    std::set<std::tuple<std::string, std::string, std::string, int, int>> reported_;
    FramePlan plan_;
};

}  // namespace

ProgramVariant variantOf(const scene::Scene& scene, const scene::Draw& draw, const scene::Pass& pass) {
    return {usesBuiltin(scene, draw) ? scene::ProgramIndex() : draw.program, draw.flatColors,
            std::max<int>(1, static_cast<int>(pass.targets.size()))};
}

FramePlan planFrame(const scene::Scene& scene, const InterfaceOf& interfaceOf,
                    const MayWriteImages& mayWriteImages, const PlanOptions& options) {
    return FramePlanner(scene, interfaceOf, options).plan(mayWriteImages);
}

}  // namespace glibra::plan
