#include "plan/frame_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "base/suggest.h"
#include "plan/accesses.h"
#include "plan/fragment_outputs.h"
#include "plan/needs.h"
#include "plan/planned_programs.h"
#include "plan/skipped.h"
#include "plan/submission.h"
#include "plan/texture_binding.h"
#include "plan/texture_uses.h"
#include "plan/uniform_names.h"
#include "scene/primitives.h"

namespace glibra::plan {
namespace {

class FramePlanner {
  public:
    FramePlanner(const scene::Scene& scene, const scene::NodeList& nodes, const PlanQuestions& questions,
                 const PlanOptions& options)
        : scene_(scene),
          nodes_(nodes),
          questions_(questions),
          options_(options),
          programs_(scene, questions, options, plan_),
          meshOfShape_(scene.shapes.size()),
          reads_(scene.shapes.size()) {}

    FramePlan plan() && {
        plan_.nodes = &nodes_;
        const Needs needs = this->needs();
        for (const scene::NodeIndex& node : nodes_.order) planNode(node, needs);
        if (options_.everything) planUndrawnPrograms();
        for (const scene::TextureIndex each : scene_.textures.indices())
            if (needs.textures[each]) plan_.textures.push_back(each);
        for (const scene::BufferIndex each : scene_.buffers.indices())
            if (needs.buffers.size() > each.position() && needs.buffers[each]) plan_.buffers.push_back(each);
        listAttributes();
        if (options_.reportsNames) {
            const FramePlan* own = &plan_;
            for (const Diagnostic& each : reportNames(scene_, {&own, 1}, options_.overrides)) report(each);
        }
        if (scene_.isModern) {
            plan_.accesses = accessesOf(scene_, plan_, options_.everything);
            findBeginnings(scene_, plan_);
            if (options_.shareTargets && !options_.everything)
                plan_.sharing = sharedTargets(scene_, plan_, options_.roots);
        }
        if (!options_.everything) plan_.skipped = listSkipped(scene_, needs, plan_);
        return std::move(plan_);
    }

  private:
    Needs needs() {
        NeedQuestions questions;
        questions.usesOf = [this](const scene::Draw& draw, const scene::Pass& pass) {
            return programs_.usesOf(draw, pass);
        };
        questions.mayWriteImages = questions_.mayWriteImages;
        if (!options_.everything) questions.outOfSight = questions_.outOfSight;
        if (!scene_.isModern) return findNeeds(scene_, nodes_, questions, options_.everything);
        questions.usesOfDispatch = [this](const scene::Dispatch& dispatch) {
            return programs_.usesOf(dispatch);
        };
        return findLiveNeeds(scene_, nodes_, questions, options_.roots, options_.everything);
    }

    /// Adds the diagnostic unless an equal one at the same place exists.
    void report(const Diagnostic& diagnostic) {
        if (reported_
                .emplace(diagnostic.id, diagnostic.text, diagnostic.place.file, diagnostic.place.line,
                         diagnostic.place.column)
                .second)
            plan_.diagnostics.push_back(diagnostic);
    }

    void planNode(const scene::NodeIndex& node, const Needs& needs) {
        switch (node.kind) {
            case scene::NodeIndex::Kind::pass:
                if (needs.passes[node.index]) planPass(node.index, needs.steps[node.index]);
                break;
            case scene::NodeIndex::Kind::dispatch:
                reportLackOfCompute(nodes_.dispatches[node.index]);
                if (needs.dispatches[node.index])
                    planDispatch(node.index);
                else
                    reportWithoutEffect(nodes_.dispatches[node.index]);
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

    /// A dispatch that writes nothing is skipped, which may be due to a mistake in its program.
    void reportWithoutEffect(const scene::Dispatch& dispatch) {
        if (!options_.lacksCompute.empty()) return;
        const std::vector<ObjectUse> uses = programs_.usesOf(dispatch);
        const PlannedProgramIndex program = programs_.of(dispatch);
        if (std::none_of(uses.begin(), uses.end(), [](const ObjectUse& each) { return each.writes; }))
            announce(program);
        for (const Diagnostic& each : programs_.state(program).diagnostics)
            if (each.id == "glib-E16") report(each);  // a key of the statement, misspelt
    }

    void planDispatch(std::size_t index) {
        const scene::Dispatch& dispatch = nodes_.dispatches[index];
        const PlannedProgramIndex program = programs_.of(dispatch);
        announce(program);
        if (!programs_[program].interface->usable) return;
        Diagnostics problems = programs_.state(program).badBindings;
        for (Diagnostic each : programs_.state(program).unitProblems) {
            each.place = dispatch.place;
            each.text = "Dispatch: " + each.text;
            problems.push_back(std::move(each));
        }
        for (const Diagnostic& each : problems) report(each);
        if (hasError(problems)) return;
        const std::vector<TextureUse>& uses = programs_.texturesOf(dispatch, program);
        reportEmptySlots(dispatch.place, program, uses);
        reportHazards("Dispatch", dispatch.place, program, uses);
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
        const PlannedProgramIndex index = programs_.of(draw, pass);
        const ProgramInterface& interface = *programs_[index].interface;
        const scene::Program* program = programs_.declared(programs_[index].variant.program);
        announce(index);
        reportMissingStage(draw, interface);

        if (!interface.usable) return planUnusable(step, index, result);
        const Result<Submission> submission = submissionOf(scene_, draw, program, interface);
        Diagnostics problems = submission.diagnostics;
        for (Diagnostic each : programs_.state(index).unitProblems) {
            each.place = draw.place;
            each.text = draw.word + ": " + each.text;
            problems.push_back(std::move(each));
        }
        append(problems, programs_.state(index).badBindings);
        const std::vector<TextureUse>& uses = programs_.texturesOf(draw, index);
        append(problems, feedback(draw, pass, index, uses));
        append(problems, outputProblems(scene_, draw, pass, interface));
        for (const Diagnostic& each : problems) report(each);
        if (!submission || hasError(problems)) return;

        reportRemarks(draw, index, program, *submission, uses);
        const std::bitset<base::kRasterTargets> unwritten =
            targetsWithoutOutput(scene_, draw, pass, interface);
        if (unwritten.any()) reportUnwritten(draw, pass, index, unwritten);
        reportLayers(draw, pass, index);
        const PlannedInputsIndex inputs = programs_.inputsOf(draw, index);
        result.steps.emplace_back(PlannedDraw{step, index, meshOf(draw, index, inputs, submission->topology),
                                              *submission, uses, inputs, unwritten});
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
        if (std::exchange(programs_.state(program).isAnnounced, true)) return;
        for (const Diagnostic& each : programs_.state(program).diagnostics) report(each);
    }

    /// Reports draw-W01 once per program: where the built-in program draws, and where the colour of a
    /// supplied fragment stage is a guess.
    void reportMissingStage(const scene::Draw& draw, const ProgramInterface& interface) {
        const std::optional<std::string>& color = interface.facts.suppliedColor;
        const bool isGuess = color && *color != "gl_FrontColor";
        if (!draw.program || !(usesBuiltin(scene_, draw) || isGuess) ||
            !incomplete_.insert(draw.program).second)
            return;
        const scene::Program& program = *programs_.declared(draw.program);
        const bool hasVertex = program.hasStage(glsl::Stage::vertex);
        const bool hasFragment = program.hasStage(glsl::Stage::fragment);
        const char* missing = hasVertex     ? "no fragment stage"
                              : hasFragment ? "no vertex stage"
                                            : "no vertex and no fragment stage";
        const std::string used = !isGuess         ? "a flat colour"
                                 : color->empty() ? "the current colour"
                                                  : fmt::format("its output '{}'", *color);
        report(diagnose("draw-W01",
                        fmt::format("Program '{}' has {}; {} is used{}", program.name, missing, used,
                                    hasVertex || hasFragment || !scene_.hasStages
                                        ? ""
                                        : "; the statements Vertex and Fragment stand before their Program"),
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
            const int unit = texture.name.empty() ? programs_.state(program).units.at(i).binding.unit : 0;
            if (!seen.emplace(uses[i].view.texture, unit).second) continue;
            std::string text =
                fmt::format("{} samples unit {} while rendering into it (RenderToTexture on line {})",
                            draw.word, unit, pass.place.line);
            if (!texture.name.empty())
                text = fmt::format(
                    "{} samples {} while drawing into it (line {}); {}", draw.word,
                    nameOf(scene_, uses[i].view), pass.place.line,
                    pass.targets.empty() && !pass.isWindow
                        ? "use a program here that does not read it: depth alone needs only a vertex stage"
                        : fmt::format("read another part, or declare '{0}' with history and read '{0}.prev'",
                                      texture.name));
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

    /// Reports draw-W02, W03, W05, W12 and W15, each only at the first draw that it applies to.
    void reportRemarks(const scene::Draw& draw, PlannedProgramIndex index, const scene::Program* program,
                       const Submission& submission, const std::vector<TextureUse>& uses) {
        reportEmptySlots(draw.place, index, uses);
        reportHazards(draw.word, draw.place, index, uses);
        reportUnknownInputs(draw, index);
        reportUnreadAttributes(draw, index);
        if (ignoresPointSize(draw, program, *programs_[index].interface, submission))
            reportIgnoredPointSize(draw, index, *program);
    }

    void warnOnce(const Place& place, PlannedProgramIndex index, const char* id, const std::string& text,
                  std::string subject = {}, std::string suggestion = {}) {
        if (remarks_.emplace(programs_[index].variant.program, id, text).second)
            report(about(diagnose(id, text, place), std::move(subject), std::move(suggestion)));
    }

    void reportHazards(const std::string& word, const Place& place, PlannedProgramIndex index,
                       const std::vector<TextureUse>& uses) {
        for (const Diagnostic& each : readsOfWritten(scene_, programs_[index], uses, word, place))
            report(each);
    }

    void reportEmptySlots(const Place& place, PlannedProgramIndex index,
                          const std::vector<TextureUse>& uses) {
        for (std::size_t i = 0; i < uses.size(); ++i) {
            if (uses[i].view.texture || uses[i].buffer.buffer ||
                programs_.state(index).units.at(i).binding.isLost)
                continue;
            const ActiveUniform& sampler = at(programs_[index].interface->uniforms, uses[i].uniform);
            const int unit = programs_.state(index).units.at(i).binding.unit;
            const std::string slot = sampler.type.target ? slotText(unit, *sampler.type.target)
                                                         : fmt::format("{} / {}", unit, sampler.type.word);
            warnOnce(place, index, "draw-W02",
                     fmt::format("{} '{}' reads unit {}, which is empty",
                                 uses[i].isImage ? "image" : "sampler", sampler.name, slot),
                     // Known only where the warning may follow from glib-W37, which says "it reads unit 0".
                     !uses[i].isImage && unit == 0 ? sampler.name : std::string());
        }
    }

    /// Reports draw-W10 for targets that the draw leaves as they are.
    void reportUnwritten(const scene::Draw& draw, const scene::Pass& pass, PlannedProgramIndex index,
                         const std::bitset<base::kRasterTargets>& unwritten) {
        const std::string& name = programs_.declared(programs_[index].variant.program)->name;
        if (programs_[index].interface->outputs.empty()) {
            return warnOnce(
                draw.place, index, "draw-W10",
                fmt::format("the fragment stage of program '{}' has no output, so the draw leaves "
                            "the colours as they are; write 'State write none' if that is meant",
                            name));
        }
        for (std::size_t target = 0; target < unwritten.size(); ++target)
            if (unwritten[target])
                warnOnce(draw.place, index, "draw-W10",
                         fmt::format("program '{}' has no output for {}, so the draw leaves it as it is; "
                                     "declare 'layout(location = {}) out vec4 ...' in the fragment stage",
                                     name, describeTarget(scene_, pass, target), target));
    }

    /// Reports draw-W14 for a draw that reaches the first of several layers only.
    void reportLayers(const scene::Draw& draw, const scene::Pass& pass, PlannedProgramIndex index) {
        if (programs_[index].interface->facts.writesLayer) return;
        const std::optional<LayeredTarget> target = layeredTarget(scene_, pass);
        if (!target) return;
        warnOnce(
            draw.place, index, "draw-W14",
            fmt::format("'{}' has {} {}, but only {} 0 is drawn into: name one, such as '{}.{}(0)', or "
                        "write gl_Layer in a geometry stage",
                        target->name, target->count, target->isCube ? "faces" : "layers",
                        target->isCube ? "face" : "layer", target->name, target->isCube ? "face" : "layer"));
    }

    /// True if the scene would supply the input if it were modern.
    [[nodiscard]] bool suppliesIfModern(const ActiveInput& input) const {
        return !scene_.isModern && glsl::findWellKnownInput(input.name, input.type.word) != nullptr;
    }

    /// The hint for an input that nothing feeds: an attribute of the draw with a name that is near and that
    /// no input has, otherwise a well-known name.
    struct InputHint {
        std::string text, suggestion;
    };

    [[nodiscard]] InputHint hintForInput(const scene::Draw& draw, const ProgramInterface& interface,
                                         const ActiveInput& input) const {
        if (suppliesIfModern(input))
            return {"; scenes with a Camera or another modern statement supply it", {}};
        if (!scene_.isModern) return {};
        const std::string name = userNameOf(interface, input.name);
        const auto isFed = [&](std::string_view attribute) {
            return std::any_of(
                interface.inputs.begin(), interface.inputs.end(),
                [&](const ActiveInput& each) { return userNameOf(interface, each.name) == attribute; });
        };
        std::vector<std::string_view> names;
        if (draw.attributes)
            for (const scene::AttributeBinding& each : scene_.attributeSets[draw.attributes].bindings)
                if (!isFed(each.name)) names.emplace_back(each.name);
        if (const std::string own = base::nearestName(name, names, 1); !own.empty())
            return {fmt::format("; did you mean the attribute '{}'?", own), own};
        names.clear();
        for (const glsl::WellKnownInput& each : glsl::wellKnownInputs())
            if (glsl::findWellKnownInput(each.name, input.type.word) != nullptr) names.push_back(each.name);
        std::string near = base::nearestName(name, names, 1);
        if (near.empty()) return {};
        return {fmt::format("; did you mean '{}'?", near), near};
    }

    void reportUnknownInputs(const scene::Draw& draw, PlannedProgramIndex index) {
        const ProgramInterface& interface = *programs_[index].interface;
        const scene::Shape& shape = scene_.shapes[draw.shape];
        const std::vector<InputSource>& sources = plan_.inputs[programs_.inputsOf(draw, index)].sources;
        for (std::size_t i = 0; i < sources.size(); ++i) {
            const std::string name = userNameOf(interface, interface.inputs[i].name);
            const bool isOfList = shape.list != nullptr && shape.list->attribute(name) != nullptr;
            if (sources[i].isKnown || isOfList || isInternalName(name)) continue;
            const InputHint hint = hintForInput(draw, interface, interface.inputs[i]);
            warnOnce(draw.place, index, "draw-W03",
                     fmt::format("vertex input '{}' is not supplied; it reads 0 0 0 1{}", name, hint.text),
                     name, hint.suggestion);
        }
    }

    /// Reports draw-W15 for attributes of the draw that no input has and whose names are near that of an
    /// input without one.
    void reportUnreadAttributes(const scene::Draw& draw, PlannedProgramIndex index) {
        if (!draw.attributes) return;
        const ProgramInterface& interface = *programs_[index].interface;
        const auto& bindings = scene_.attributeSets[draw.attributes].bindings;
        const std::vector<InputSource>& sources = plan_.inputs[programs_.inputsOf(draw, index)].sources;
        std::vector<std::string> inputs;
        for (const ActiveInput& each : interface.inputs) inputs.push_back(userNameOf(interface, each.name));
        std::vector<std::string_view> free;  // what is not supplied at all is draw-W03
        for (std::size_t i = 0; i < inputs.size(); ++i)
            if (sources[i].isKnown && std::none_of(bindings.begin(), bindings.end(),
                                                   [&](const auto& each) { return each.name == inputs[i]; }))
                free.emplace_back(inputs[i]);
        for (const scene::AttributeBinding& each : bindings) {
            if (std::find(inputs.begin(), inputs.end(), each.name) != inputs.end()) continue;
            if (const std::string near = base::nearestName(each.name, free); !near.empty())
                warnOnce(
                    each.place, index, "draw-W15",
                    fmt::format("Attribute: program '{}' has no vertex input '{}'; did you mean '{}'?",
                                programs_.declared(programs_[index].variant.program)->name, each.name, near),
                    each.name, near);
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
        if (!programs_[program].interface->usable)
            reads_[draw.shape].insert(std::string(geometry::kPosition));
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
        nodes.visitDraws([&](const scene::Draw& draw, const auto&) { programs.insert(draw.program); });
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
            const bool isFullScreen = scene_.isModern && isWithoutVertexStage(program);
            const bool isCompute = program.hasStage(glsl::Stage::compute) && options_.lacksCompute.empty();
            const bool isDrawable = program.hasStage(glsl::Stage::fragment) &&
                                    (program.hasStage(glsl::Stage::vertex) || isFullScreen);
            if (drawn.contains(i) || !(isDrawable || isCompute)) continue;
            // What a draw would set is not known.
            const PlannedProgramIndex undrawn = programs_.of(ProgramVariant{i, false, 1, isFullScreen});
            if (scene_.isModern)
                std::erase_if(programs_.state(undrawn).diagnostics, [](const Diagnostic& each) {
                    return each.id == "glib-W37" || each.id == "memory-E02" ||
                           (each.id == "glsl-W11" && each.subject == "vST");  // Fill gives it
                });
            announce(undrawn);
        }
    }

    const scene::Scene& scene_;
    const scene::NodeList& nodes_;
    const PlanQuestions& questions_;
    const PlanOptions& options_;
    FramePlan plan_;
    PlannedPrograms programs_;
    scene::List<PlannedMeshIndex, scene::Shape> meshOfShape_;
    std::map<std::pair<scene::ShapeIndex, geometry::Topology>, PlannedMeshIndex> adjacentMeshes_;
    scene::List<std::set<std::string>, scene::Shape> reads_;  ///< attributes that some program reads
    bool reportedCompute_ = false;
    std::set<scene::ProgramIndex> incomplete_;  ///< programs of draw-W01
    std::set<std::tuple<scene::ProgramIndex, std::string, std::string>> remarks_;
    std::set<std::tuple<std::string, std::string, std::string, int, int>> reported_;
};

}  // namespace

scene::NodeIndex FramePlan::declared(const scene::NodeIndex& node) const {
    switch (node.kind) {
        case scene::NodeIndex::Kind::pass:
            return {node.kind, passes.at(node.index).pass};
        case scene::NodeIndex::Kind::dispatch:
            return {node.kind, dispatches.at(node.index).dispatch};
        case scene::NodeIndex::Kind::clear:
            break;
    }
    return {node.kind, clears.at(node.index).clear};
}

const Place& FramePlan::placeOf(const scene::NodeIndex& node) const {
    return nodes->placeOf(declared(node));
}

ProgramVariant variantOf(const scene::Scene& scene, const scene::Draw& draw, const scene::Pass& pass) {
    const bool isBuiltin = usesBuiltin(scene, draw);
    const bool coversTarget = scene.isModern && std::holds_alternative<scene::ClipSpace>(draw.projection);
    ProgramVariant variant{.flatColors = draw.flatColors,
                           .colorTargets = std::max<int>(1, static_cast<int>(pass.targets.size()))};
    if (isBuiltin) return variant;
    const scene::Program& program = scene.programs[draw.program];
    const std::vector<scene::StageFile>& stages = program.stages;
    variant.program = draw.program;
    variant.isFullScreen = coversTarget || (scene.shapes[draw.shape].bare && isWithoutVertexStage(program));
    variant.suppliesFragment = !program.hasStage(glsl::Stage::fragment) && needsFragments(scene, draw, pass);
    variant.isFill =
        draw.isFill && std::any_of(stages.begin(), stages.end(), scene::Program::isLeftOutByFill);
    return variant;
}

FramePlan planFrame(const scene::Scene& scene, const scene::NodeList& nodes, const PlanQuestions& questions,
                    const PlanOptions& options) {
    return FramePlanner(scene, nodes, questions, options).plan();
}

}  // namespace glibra::plan
