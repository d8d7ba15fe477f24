#include "plan/frame_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "plan/accesses.h"
#include "plan/loop_rounds.h"
#include "plan/needs.h"
#include "plan/overrides.h"
#include "plan/skipped.h"
#include "plan/submission.h"
#include "plan/texture_binding.h"
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
    Diagnostics badBindings;   ///< draw-E09, draw-E10: nothing is drawn with it
    bool isAnnounced = false;  ///< its diagnostics are in the plan
};

class FramePlanner {
  public:
    FramePlanner(const scene::Scene& scene, const scene::NodeList& nodes, const InterfaceOf& interfaceOf,
                 const PlanOptions& options)
        : scene_(scene),
          nodes_(nodes),
          interfaceOf_(interfaceOf),
          options_(options),
          usedOverrides_(options.overrides.size()),
          meshOfShape_(scene.shapes.size()),
          reads_(scene.shapes.size()) {}

    FramePlan plan(const MayWriteImages& mayWriteImages) && {
        plan_.nodes = &nodes_;
        const Needs needs = this->needs(mayWriteImages);
        for (const scene::NodeIndex& node : nodes_.order) planNode(node, needs);
        if (options_.everything) planUndrawnPrograms();
        for (const scene::TextureIndex each : scene_.textures.indices())
            if (needs.textures[each]) plan_.textures.push_back(each);
        for (const scene::BufferIndex each : scene_.buffers.indices())
            if (needs.buffers.size() > each.position() && needs.buffers[each]) plan_.buffers.push_back(each);
        listAttributes();
        if (options_.reportsOverrides) reportOverrides();
        if (scene_.isModern) {
            plan_.exchanges = exchangesOf(scene_, plan_);
            findBeginnings(scene_, plan_);
            if (options_.shareTargets && !options_.everything)
                plan_.sharing = sharedTargets(scene_, plan_, options_.roots);
        }
        if (!options_.everything) plan_.skipped = listSkipped(scene_, needs, plan_);
        return std::move(plan_);
    }

  private:
    using VariantKey = std::tuple<scene::ProgramIndex, bool, int, bool, bool, scene::UniformSetIndex>;

    const scene::Program* sceneProgram(scene::ProgramIndex index) const {
        return index ? &scene_.programs[index] : nullptr;
    }
    ProgramState& state(PlannedProgramIndex program) { return states_[program]; }
    const PlannedProgram& planned(PlannedProgramIndex program) const { return plan_.programs[program]; }

    Needs needs(const MayWriteImages& mayWriteImages) {
        NeedQuestions questions;
        questions.texturesOf = [this](const scene::Draw& draw, const scene::Pass& pass) {
            std::vector<scene::TextureIndex> textures;
            for (const TextureUse& use : usesOf(draw, programOf(draw, pass)))
                textures.push_back(use.view.texture);
            return textures;
        };
        questions.mayWriteImages = mayWriteImages;
        if (!options_.everything) questions.outOfSight = options_.outOfSight;
        if (!scene_.isModern) return findNeeds(scene_, nodes_, questions, options_.everything);
        questions.usesOf = [this](const scene::Draw& draw, const scene::Pass& pass) {
            return objectUses(draw, pass);
        };
        questions.usesOfDispatch = [this](const scene::Dispatch& dispatch) { return objectUses(dispatch); };
        return findLiveNeeds(scene_, nodes_, questions, options_.roots, options_.everything);
    }

    /// What a draw does with objects, besides the targets of its pass.
    std::vector<ObjectUse> objectUses(const scene::Draw& draw, const scene::Pass& pass) {
        const PlannedProgramIndex program = programOf(draw, pass);
        std::vector<ObjectUse> uses = shaderUses(planned(program), usesOf(draw, program));
        const auto read = [&](const scene::BufferView& view) {
            if (view.buffer) uses.push_back({view});
        };
        read(draw.instancesFrom);
        read(draw.verticesFrom);
        for (const InputSource& each : plan_.inputs[inputsOf(draw, program)].sources)
            if (const auto* view = std::get_if<scene::BufferView>(&each.from)) read(*view);
        return uses;
    }

    std::vector<ObjectUse> objectUses(const scene::Dispatch& dispatch) {
        if (!options_.lacksCompute.empty()) return {};
        const PlannedProgramIndex program = programOf(dispatch);
        std::vector<ObjectUse> uses = shaderUses(planned(program), usesOf(dispatch, program));
        if (const auto* groups = std::get_if<scene::GroupsFrom>(&dispatch.groups))
            uses.push_back({groups->buffer});
        if (const scene::ObjectView* size = sizeOf(dispatch))  // its content is not read
            uses.push_back({*size, false, false});
        return uses;
    }
    /// The object whose size is the number of invocations, or null.
    static const scene::ObjectView* sizeOf(const scene::Dispatch& dispatch) {
        const auto* over = std::get_if<scene::Over>(&dispatch.groups);
        return over != nullptr ? std::get_if<scene::ObjectView>(&over->what) : nullptr;
    }

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
    PlannedProgramIndex programOf(const scene::Dispatch& dispatch) {
        return programOf(ProgramVariant{.program = dispatch.program, .inPieces = dispatch.tiles > 1},
                         dispatch.uniforms);
    }

    /// Returns the index of the variant with these values in the plan. The first call asks for its interface.
    PlannedProgramIndex programOf(const ProgramVariant& variant, scene::UniformSetIndex uniforms = {}) {
        if (!variant.program) uniforms = {};  // the built-in program reads none of them
        PlannedProgramIndex& index =
            programs_[VariantKey{variant.program, variant.flatColors, variant.colorTargets,
                                 variant.isFullScreen, variant.inPieces, uniforms}];
        if (index) return index;
        const ProgramInterface& interface = interfaceOf_(variant);
        PlannedProgram program{variant, &interface, {}, {}, {}};
        ProgramState state;
        state.diagnostics = interface.facts.diagnostics;
        if (interface.usable) {
            const scene::Program noPairs;
            const scene::Program* own = sceneProgram(variant.program);
            scene::Program merged;  // what a draw sets comes after what the Program statement sets
            if (own != nullptr && uniforms) {
                merged = *own;
                const std::vector<glib::UniformSpec>& set = scene_.uniformSets[uniforms].values;
                merged.uniforms.insert(merged.uniforms.end(), set.begin(), set.end());
                own = &merged;
            }
            if (own != nullptr) {
                Result<std::vector<BlockUse>> blocks = blockUses(scene_, *own, uniforms, interface);
                append(state.diagnostics, std::move(blocks.diagnostics));
                if (blocks) program.blocks = std::move(*blocks);
            }
            const std::span<const Override> overrides(options_.overrides);
            const DrawValues drawn{scene_.isModern ? &scene_ : nullptr,
                                   uniforms ? &scene_.uniformSets[uniforms] : nullptr,
                                   [&](const ActiveUniform& each) { return isInBuffer(program, each); }};
            UniformResolution resolution =
                resolveUniforms(own != nullptr ? *own : noPairs, scene_.path, interface,
                                own != nullptr ? overrides : overrides.first(0), usedOverrides_, drawn);
            program.foundByName = std::move(resolution.foundByName);
            if (scene_.isModern && own != nullptr) listNamedInputs(interface, program.foundByName);
            state.badBindings = std::move(resolution.badBindings);
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

    /// True for members of a uniform block whose values are in a buffer of the scene.
    static bool isInBuffer(const PlannedProgram& program, const ActiveUniform& uniform) {
        return uniform.block >= 0 &&
               std::any_of(program.blocks.begin(), program.blocks.end(), [&](const BlockUse& each) {
                   return each.kind == BlockUse::Kind::uniform &&
                          each.index == static_cast<std::size_t>(uniform.block);
               });
    }

    /// Adds the vertex inputs whose names are in the table of well-known names.
    static void listNamedInputs(const ProgramInterface& interface, std::vector<std::string>& to) {
        for (const ActiveInput& input : interface.inputs) {
            if (glsl::findBuiltinInput(input.name) != nullptr) continue;
            if (const auto* row = glsl::findWellKnownInput(input.name, input.type.word))
                to.push_back(
                    fmt::format("vertex input '{}' is the attribute {}", input.name, row->attribute));
        }
    }

    /// True if the scene would supply the input if it were modern.
    [[nodiscard]] bool suppliesIfModern(const ActiveInput& input) const {
        return !scene_.isModern && glsl::findWellKnownInput(input.name, input.type.word) != nullptr;
    }

    int loopLimit() {
        if (!loopLimit_) loopLimit_ = options_.loopLimit ? options_.loopLimit() : 0;
        return *loopLimit_;
    }

    /// The textures that a draw's samplers read. Draws with equal program, slots and wrap share them.
    template <class Reader>  // Draw or Dispatch
    const std::vector<TextureUse>& usesOf(const Reader& reader, PlannedProgramIndex program) {
        const auto [entry, isNew] = uses_.try_emplace({program, reader.slots, reader.sampling.clamp});
        if (isNew)
            entry->second = textureUses(scene_, reader.slots, reader.sampling, *planned(program).interface,
                                        state(program).units);
        return entry->second;
    }

    void planNode(const scene::NodeIndex& node, const Needs& needs) {
        switch (node.kind) {
            case scene::NodeIndex::Kind::pass:
                if (needs.passes[node.index]) planPass(node.index, needs.steps[node.index]);
                break;
            case scene::NodeIndex::Kind::dispatch:
                reportLackOfCompute(nodes_.dispatches[node.index]);
                if (needs.dispatches[node.index]) planDispatch(node.index);
                break;
            case scene::NodeIndex::Kind::clear:
                if (!needs.clears[node.index]) break;
                plan_.order.push_back({node.kind, plan_.clears.size()});
                plan_.clears.push_back({node.index});
                break;
        }
    }

    void reportLackOfCompute(const scene::Dispatch& dispatch) {
        if (options_.lacksCompute.empty() || std::exchange(reportedCompute_, true)) return;
        report(
            diagnose("memory-E01", "Dispatch needs a driver with " + options_.lacksCompute, dispatch.place));
    }

    void planDispatch(std::size_t index) {
        const scene::Dispatch& dispatch = nodes_.dispatches[index];
        const PlannedProgramIndex program = programOf(dispatch);
        announce(program);
        if (!planned(program).interface->usable) return;
        Diagnostics problems = state(program).badBindings;
        for (Diagnostic each : state(program).unitProblems) {
            each.place = dispatch.place;
            each.text = "Dispatch: " + each.text;
            problems.push_back(std::move(each));
        }
        for (const Diagnostic& each : problems) report(each);
        if (hasError(problems)) return;
        const std::vector<TextureUse>& uses = usesOf(dispatch, program);
        reportEmptySlots(dispatch.place, program, uses);
        plan_.order.push_back({scene::NodeIndex::Kind::dispatch, plan_.dispatches.size()});
        plan_.dispatches.push_back({index, program, uses});
    }

    void planPass(std::size_t index, const std::vector<StepNeed>& needs) {
        const scene::Pass& pass = nodes_.passes[index];
        PlannedPass result;
        result.pass = index;
        for (std::size_t step = 0; step < pass.steps.size(); ++step) {
            if (needs[step] != StepNeed::needed) continue;
            if (std::holds_alternative<scene::Clear>(pass.steps[step]))
                result.steps.emplace_back(PlannedClear{{index, step}});
            else
                planDraw({index, step}, result);
        }
        plan_.order.push_back({scene::NodeIndex::Kind::pass, plan_.passes.size()});
        plan_.passes.push_back(std::move(result));
    }

    void planDraw(scene::StepIndex step, PlannedPass& result) {
        const scene::Pass& pass = nodes_.passes[step.pass];
        const scene::Draw& draw = nodes_.draw(step);
        const PlannedProgramIndex index = programOf(draw, pass);
        const ProgramInterface& interface = *planned(index).interface;
        const scene::Program* program = sceneProgram(planned(index).variant.program);
        announce(index);
        reportMissingStage(draw, pass);

        if (!interface.usable) return planUnusable(step, index, result);
        const Result<Submission> submission = submissionOf(scene_, draw, program, interface);
        Diagnostics problems = submission.diagnostics;
        for (Diagnostic each : state(index).unitProblems) {
            each.place = draw.place;
            each.text = draw.word + ": " + each.text;
            problems.push_back(std::move(each));
        }
        append(problems, state(index).badBindings);
        const std::vector<TextureUse>& uses = usesOf(draw, index);
        append(problems, feedback(draw, pass, index, uses));
        for (const Diagnostic& each : problems) report(each);
        if (!submission || hasError(problems)) return;

        reportRemarks(draw, index, program, *submission, uses);
        const PlannedInputsIndex inputs = inputsOf(draw, index);
        result.steps.emplace_back(PlannedDraw{step, index, meshOf(draw, index, inputs, submission->topology),
                                              *submission, uses, inputs});
    }

    PlannedInputsIndex inputsOf(const scene::Draw& draw, PlannedProgramIndex program) {
        PlannedInputsIndex& index = inputs_[{program, draw.attributes}];
        if (!index)
            index = plan_.inputs.add({inputSources(scene_, draw.attributes, *planned(program).interface)});
        return index;
    }

    /// The program has no usable stages, so a window shows the shape in one colour. It cannot show patches
    /// that way.
    void planUnusable(scene::StepIndex step, PlannedProgramIndex index, PlannedPass& result) {
        const scene::Draw& draw = nodes_.draw(step);
        const geometry::Topology topology = topologyOf(scene_.shapes[draw.shape]);
        if (topology == geometry::Topology::patches) return;
        result.steps.emplace_back(
            PlannedDraw{step, index, meshOf(draw, index, {}, topology), {topology, 0}, {}, {}});
    }

    void announce(PlannedProgramIndex program) {
        if (std::exchange(state(program).isAnnounced, true)) return;
        for (const Diagnostic& each : state(program).diagnostics) report(each);
    }

    /// Reports draw-W01 once per program.
    void reportMissingStage(const scene::Draw& draw, const scene::Pass& pass) {
        if (!draw.program || !usesBuiltin(scene_, draw, pass) || !incomplete_.insert(draw.program).second)
            return;
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

    /// Returns draw-E01 if a sampler reads a part of a texture that its own pass draws into.
    Diagnostics feedback(const scene::Draw& draw, const scene::Pass& pass, PlannedProgramIndex program,
                         const std::vector<TextureUse>& uses) {
        Diagnostics errors;
        std::set<std::pair<scene::TextureIndex, int>> seen;
        for (std::size_t i = 0; i < uses.size(); ++i) {
            if (uses[i].isImage || !uses[i].view.texture || !drawsInto(pass, uses[i])) continue;
            const scene::Texture& texture = scene_.textures[uses[i].view.texture];
            const int unit = texture.name.empty() ? state(program).units.at(i).binding.unit : 0;
            if (!seen.emplace(uses[i].view.texture, unit).second) continue;
            std::string text =
                fmt::format("{} samples unit {} while rendering into it (RenderToTexture on line {})",
                            draw.word, unit, pass.place.line);
            if (!texture.name.empty())
                text = fmt::format(
                    "{} samples {} while drawing into it (line {}); read another part, or "
                    "declare '{}' with history and read '{}.prev'",
                    draw.word, nameOf(scene_, uses[i].view), pass.place.line, texture.name, texture.name);
            errors.push_back(diagnose("draw-E01", text, draw.place));
        }
        return errors;
    }

    [[nodiscard]] bool drawsInto(const scene::Pass& pass, const TextureUse& use) const {
        for (std::size_t i = 0; i < pass.targets.size(); ++i) {
            const scene::TargetPart part = i < pass.parts.size() ? pass.parts[i] : scene::TargetPart{};
            if (readsPart(scene_, use,
                          {.texture = pass.targets[i], .level = part.level, .layer = part.layer}))
                return true;
        }
        return pass.depth && readsPart(scene_, use, *pass.depth);
    }

    /// Reports draw-W02, W03 and W05, each only at the first draw that it applies to.
    void reportRemarks(const scene::Draw& draw, PlannedProgramIndex index, const scene::Program* program,
                       const Submission& submission, const std::vector<TextureUse>& uses) {
        reportEmptySlots(draw.place, index, uses);
        reportUnknownInputs(draw, index);
        if (ignoresPointSize(draw, program, *planned(index).interface, submission))
            reportIgnoredPointSize(draw, index, *program);
    }

    void warnOnce(const Place& place, PlannedProgramIndex index, const char* id, const std::string& text) {
        if (remarks_.emplace(planned(index).variant.program, id, text).second)
            report(diagnose(id, text, place));
    }

    void reportEmptySlots(const Place& place, PlannedProgramIndex index,
                          const std::vector<TextureUse>& uses) {
        for (std::size_t i = 0; i < uses.size(); ++i) {
            if (uses[i].view.texture) continue;
            const ActiveUniform& sampler = at(planned(index).interface->uniforms, uses[i].uniform);
            const int unit = state(index).units.at(i).binding.unit;
            const std::string slot = sampler.type.target ? slotText(unit, *sampler.type.target)
                                                         : fmt::format("{} / {}", unit, sampler.type.word);
            warnOnce(place, index, "draw-W02",
                     fmt::format("{} '{}' reads unit {}, which is empty",
                                 uses[i].isImage ? "image" : "sampler", sampler.name, slot));
        }
    }

    void reportUnknownInputs(const scene::Draw& draw, PlannedProgramIndex index) {
        const ProgramInterface& interface = *planned(index).interface;
        const scene::Shape& shape = scene_.shapes[draw.shape];
        const std::vector<InputSource>& sources = plan_.inputs[inputsOf(draw, index)].sources;
        for (std::size_t i = 0; i < sources.size(); ++i) {
            const std::string name = userNameOf(interface, interface.inputs[i].name);
            const bool isOfList = shape.list != nullptr && shape.list->attribute(name) != nullptr;
            if (!sources[i].isKnown && !isOfList && !isInternalName(name))
                warnOnce(draw.place, index, "draw-W03",
                         fmt::format("vertex input '{}' is not supplied; it reads 0 0 0 1{}", name,
                                     suppliesIfModern(interface.inputs[i])
                                         ? "; scenes with a Camera or another modern statement supply it"
                                         : ""));
        }
    }

    void reportIgnoredPointSize(const scene::Draw& draw, PlannedProgramIndex index,
                                const scene::Program& program) {
        using glsl::Stage;
        const Stage last = program.hasStage(Stage::geometry)         ? Stage::geometry
                           : program.hasStage(Stage::tessEvaluation) ? Stage::tessEvaluation
                                                                     : Stage::vertex;
        const std::string file = stageFileName(scene_, program, last);
        warnOnce(draw.place, index, "draw-W05",
                 fmt::format("{} writes gl_PointSize, but PointSizeMode is 0",
                             file.empty() ? "Program '" + program.name + "'" : file));
    }

    /// Returns the mesh of the draw's shape and records the attributes that this program reads.
    PlannedMeshIndex meshOf(const scene::Draw& draw, PlannedProgramIndex program, PlannedInputsIndex inputs,
                            geometry::Topology submitted) {
        const std::optional<geometry::Topology> adjacency =
            addedAdjacency(scene_.shapes[draw.shape], submitted);
        PlannedMeshIndex& mesh =
            adjacency ? adjacentMeshes_[{draw.shape, *adjacency}] : meshOfShape_[draw.shape];
        if (!mesh || !options_.shareMeshes) mesh = plan_.meshes.add({draw.shape, {}, adjacency});
        if (inputs)
            for (const InputSource& each : plan_.inputs[inputs].sources)
                if (const auto* name = std::get_if<std::string>(&each.from)) reads_[draw.shape].insert(*name);
        // A window shows the draws of an unusable program in one colour, so it needs their positions.
        if (!planned(program).interface->usable) reads_[draw.shape].insert(std::string(geometry::kPosition));
        return mesh;
    }

    void listAttributes() {
        for (PlannedMesh& mesh : plan_.meshes) {
            for (std::string& name : attributesOf(scene_.shapes[mesh.shape]))
                if (options_.everything || reads_[mesh.shape].contains(name))
                    mesh.attributes.push_back(std::move(name));
        }
    }

    static std::set<scene::ProgramIndex> programsOf(const scene::NodeList& nodes) {
        std::set<scene::ProgramIndex> programs;
        for (const scene::Dispatch& each : nodes.dispatches) programs.insert(each.program);
        for (const scene::Pass& pass : nodes.passes)
            for (const auto& step : pass.steps)
                if (const auto* draw = std::get_if<scene::Draw>(&step)) programs.insert(draw->program);
        return programs;
    }

    /// `glibra check` also compiles programs without draws.
    void planUndrawnPrograms() {
        if (&nodes_ != &scene_.frame) return;
        std::set<scene::ProgramIndex> drawn = programsOf(scene_.frame);
        for (const scene::OnceBlock& each : scene_.once) drawn.merge(programsOf(each.nodes));
        for (const scene::StepBlock& each : scene_.steps) drawn.merge(programsOf(each.nodes));
        for (const scene::ProgramIndex i : scene_.programs.indices()) {
            const scene::Program& program = scene_.programs[i];
            const bool isFullScreen = isWithoutVertexStage(scene_, program);
            const bool isCompute = program.hasStage(glsl::Stage::compute) && options_.lacksCompute.empty();
            const bool isDrawable = program.hasStage(glsl::Stage::fragment) &&
                                    (program.hasStage(glsl::Stage::vertex) || isFullScreen);
            if (drawn.contains(i) || !(isDrawable || isCompute)) continue;
            announce(programOf(ProgramVariant{i, false, 1, isFullScreen}));
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
    const scene::NodeList& nodes_;
    const InterfaceOf& interfaceOf_;
    const PlanOptions& options_;
    std::vector<bool> usedOverrides_;
    std::map<VariantKey, PlannedProgramIndex> programs_;
    scene::List<ProgramState, PlannedProgram> states_;
    std::map<std::tuple<PlannedProgramIndex, scene::SlotTableIndex, bool>, std::vector<TextureUse>> uses_;
    scene::List<PlannedMeshIndex, scene::Shape> meshOfShape_;
    std::map<std::pair<scene::ShapeIndex, geometry::Topology>, PlannedMeshIndex> adjacentMeshes_;
    scene::List<std::set<std::string>, scene::Shape> reads_;  ///< attributes that some program reads
    std::map<std::pair<PlannedProgramIndex, scene::AttributeSetIndex>, PlannedInputsIndex> inputs_;
    bool reportedCompute_ = false;
    std::optional<int> loopLimit_;
    std::set<scene::ProgramIndex> incomplete_;  ///< programs of draw-W01
    std::set<std::tuple<scene::ProgramIndex, std::string, std::string>> remarks_;
    std::set<std::tuple<std::string, std::string, std::string, int, int>> reported_;
    FramePlan plan_;
};

}  // namespace

ProgramVariant variantOf(const scene::Scene& scene, const scene::Draw& draw, const scene::Pass& pass) {
    const bool isBuiltin = usesBuiltin(scene, draw, pass);
    const bool coversTarget = scene.isModern && std::holds_alternative<scene::ClipSpace>(draw.projection);
    return {isBuiltin ? scene::ProgramIndex() : draw.program, draw.flatColors,
            std::max<int>(1, static_cast<int>(pass.targets.size())),
            !isBuiltin && (coversTarget || isWithoutVertexStage(scene, scene.programs[draw.program]))};
}

FramePlan planFrame(const scene::Scene& scene, const scene::NodeList& nodes, const InterfaceOf& interfaceOf,
                    const MayWriteImages& mayWriteImages, const PlanOptions& options) {
    return FramePlanner(scene, nodes, interfaceOf, options).plan(mayWriteImages);
}

}  // namespace glibra::plan
