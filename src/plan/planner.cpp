#include "plan/planner.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "plan/accesses.h"
#include "plan/draw_remarks.h"
#include "plan/memory_pattern.h"
#include "plan/needs.h"
#include "plan/overrides.h"
#include "plan/planned_programs.h"
#include "plan/submission.h"
#include "plan/texture_binding.h"
#include "plan/uniform_names.h"
#include "scene/primitives.h"
#include "scene/scene.h"

namespace glibra::plan {
namespace {

// Finds what a plan leaves out, and why: passes, draws, statements, programs, meshes, attributes, textures,
// files, in this order, and each kind in the order of the scene.

class SkipList {
  public:
    SkipList(const scene::Scene& scene, const Needs& needs, const FramePlan& plan)
        : scene_(scene),
          needs_(needs),
          plan_(plan),
          firstDraws_(scene.shapes.size()),
          hasDraw_(scene.programs.size()),
          programs_(scene.programs.size()),
          textures_(scene.textures.size()),
          files_(scene.files.size()) {}

    std::vector<Skipped> list() && {
        for (std::size_t pass = 0; pass < plan_.nodes->passes.size(); ++pass) addPass(pass);
        addNodes();
        addPrograms();
        addMeshes();
        addTextures();
        addBuffers();
        addFiles();
        return std::move(skipped_);
    }

  private:
    void add(const char* what, std::string why, const Place& place) {
        skipped_.push_back({what, std::move(why), place});
    }

    void useFile(scene::FileIndex file) {
        if (file) files_[file] = true;
    }

    void addPass(std::size_t index) {
        const scene::Pass& pass = plan_.nodes->passes[index];
        if (!needs_.passes[index]) add("pass", pass.isWindow ? clearedAgain(pass) : unseen(pass), pass.place);
        for (std::size_t step = 0; step < pass.steps.size(); ++step) {
            const StepNeed need = needs_.steps[index][step];
            if (const auto* draw = std::get_if<scene::Draw>(&pass.steps[step]))
                addDraw(*draw, pass, {index, step}, need);
            else if (need == StepNeed::coveredByClear)
                add("statement", "Clear: " + clearedAgain(pass),
                    std::get<scene::Clear>(pass.steps[step]).place);
        }
    }

    void addDraw(const scene::Draw& draw, const scene::Pass& pass, scene::StepIndex at, StepNeed need) {
        const scene::Draw*& first = firstDraws_[draw.shape];
        if (first == nullptr) first = &draw;
        if (draw.program) hasDraw_[draw.program] = true;
        if (need == StepNeed::coveredByClear) add("draw", draw.word + ": " + clearedAgain(pass), draw.place);
        if (need == StepNeed::outOfSight)
            add("draw", draw.word + ": " + needs_.outOfSight.at(at), draw.place);
        if (need == StepNeed::drawsNothing)
            add("draw", draw.word + ": it has no size and draws nothing", draw.place);
    }

    void addNodes() {
        for (std::size_t i = 0; i < needs_.dispatches.size(); ++i) {
            const scene::Dispatch& dispatch = plan_.nodes->dispatches[i];
            if (needs_.dispatches[i]) continue;
            add("dispatch",
                fmt::format("'{}': nothing reads what it writes", scene_.programs[dispatch.program].name),
                dispatch.place);
        }
        for (std::size_t i = 0; i < needs_.clears.size(); ++i)
            if (!needs_.clears[i])
                add("statement", "Clear: nothing reads what it clears", plan_.nodes->clears[i].place);
    }

    [[nodiscard]] std::string clearedAgain(const scene::Pass& pass) const {
        if (!pass.isWindow || needs_.clear.file.empty()) return "it is cleared again";
        return fmt::format("the window is cleared again on line {}", needs_.clear.line);
    }

    /// Why a pass into textures is not needed.
    [[nodiscard]] std::string unseen(const scene::Pass& pass) const {
        std::string names;
        std::vector<scene::TextureIndex> targets = pass.targets;
        if (pass.depth) targets.push_back(pass.depth->texture);
        for (const scene::TextureIndex each : targets)
            if (const std::string& name = scene_.textures[each].name; !name.empty())
                names += fmt::format("{}'{}'", names.empty() ? "" : ", ", name);
        if (names.empty()) return "nothing visible samples its targets";
        return fmt::format("nothing visible reads what it draws into {}", names);
    }

    void addPrograms() {
        for (const PlannedProgram& each : plan_.programs)
            if (each.variant.program) programs_[each.variant.program] = true;
        for (const scene::ProgramIndex i : scene_.programs.indices()) {
            const scene::Program& program = scene_.programs[i];
            if (programs_[i]) {
                for (const scene::StageFile& stage : program.stages) useFile(stage.file);
                continue;
            }
            const bool isWhole =
                (program.hasStage(glsl::Stage::vertex) && program.hasStage(glsl::Stage::fragment)) ||
                program.stages.size() == 1;
            const char* why = !hasDraw_[i] ? "nothing is drawn with it"
                              : !isWhole   ? "it has no vertex or no fragment stage"
                                           : "nothing visible is drawn with it";
            add("program", fmt::format("'{}': {}", program.name, why), program.place);
        }
    }

    void addMeshes() {
        scene::List<const PlannedMesh*, scene::Shape> planned(scene_.shapes.size());
        scene::List<int, scene::Shape> meshes(scene_.shapes.size());  // two if one has adjacency
        for (const PlannedMesh& mesh : plan_.meshes) {
            planned[mesh.shape] = &mesh;
            ++meshes[mesh.shape];
        }
        scene::List<int, scene::Shape> draws(scene_.shapes.size());  // that are planned
        plan_.visitDraws([&](const auto&, const scene::Draw& draw, const auto&) { ++draws[draw.shape]; });
        std::vector<Skipped> attributes;
        for (const scene::ShapeIndex i : scene_.shapes.indices()) {
            const std::string word = firstDraws_[i] != nullptr ? firstDraws_[i]->word : std::string("shape");
            const Place place = firstDraws_[i] != nullptr ? firstDraws_[i]->place : Place{};
            const bool isOfOtherList =
                firstDraws_[i] == nullptr && !(scene_.once.empty() && scene_.steps.empty());
            if (planned[i] == nullptr && isOfOtherList) continue;
            if (planned[i] == nullptr) {
                add("mesh", word + ": nothing visible draws it", place);
                continue;
            }
            useFile(scene_.shapes[i].file);
            if (draws[i] > 1 && meshes[i] == 1)
                add("mesh", fmt::format("{}: one mesh serves all its {} draws", word, draws[i]), place);
            for (const std::string& attribute : attributesOf(scene_.shapes[i]))
                // Few models have colours.
                if (std::ranges::find(planned[i]->attributes, attribute) == planned[i]->attributes.end() &&
                    (scene_.shapes[i].list != nullptr || attribute != geometry::kColor))
                    attributes.push_back(
                        {"attribute", fmt::format("{} of {}: no program reads it", attribute, word), place});
        }
        skipped_.insert(skipped_.end(), attributes.begin(), attributes.end());
    }

    void addTextures() {
        for (const scene::TextureIndex each : plan_.textures) textures_[each] = true;
        for (const scene::TextureIndex i : scene_.textures.indices()) {
            const scene::Texture& texture = scene_.textures[i];
            const auto* picture = std::get_if<scene::PictureSource>(&texture.source);
            const auto* noise = std::get_if<scene::NoiseSource>(&texture.source);
            if (textures_[i]) {
                if (picture != nullptr)
                    for (const scene::FileIndex file : picture->files) useFile(file);
                if (noise != nullptr) useFile(noise->file);
                continue;
            }
            const std::string which = texture.name.empty() ? "unit " + slotText(texture.unit, texture.target)
                                                           : fmt::format("'{}'", texture.name);
            add(noise != nullptr ? "noise texture" : "texture", which + ": no active sampler reads it",
                texture.place);
        }
    }

    void addBuffers() {
        scene::List<bool, scene::Buffer> used(scene_.buffers.size());
        for (const scene::BufferIndex each : plan_.buffers) used[each] = true;
        for (const scene::BufferIndex i : scene_.buffers.indices()) {
            const scene::Buffer& buffer = scene_.buffers[i];
            if (used[i])
                useFile(buffer.file);
            else
                add("buffer", fmt::format("'{}': nothing reads it", buffer.name), buffer.place);
        }
    }

    void addFiles() {
        for (const scene::FileIndex i : scene_.files.indices())
            if (!files_[i])
                add("file", fmt::format("'{}': nothing visible needs it", scene_.files[i].name),
                    scene_.files[i].place);
    }

    const scene::Scene& scene_;
    const Needs& needs_;
    const FramePlan& plan_;
    scene::List<const scene::Draw*, scene::Shape> firstDraws_;  ///< first draw of each shape
    scene::List<bool, scene::Program> hasDraw_;                 ///< some draw has the program, visible or not
    // Used by the plan:
    scene::List<bool, scene::Program> programs_;
    scene::List<bool, scene::Texture> textures_;
    scene::List<bool, scene::FileReference> files_;
    std::vector<Skipped> skipped_;
};

class FramePlanner {
  public:
    FramePlanner(const scene::Scene& scene, const scene::NodeList& nodes, const Answers& answers,
                 const PlanOptions& options)
        : scene_(scene),
          nodes_(nodes),
          options_(options),
          programs_(scene, answers, options, questions_, plan_),
          meshOfShape_(scene.shapes.size()),
          reads_(scene.shapes.size()) {
        plan_.nodes = &nodes;
        needs_ = findNeeds(scene, nodes, programs_, answers, options, questions_);
    }

    std::variant<FramePlan, Questions> plan() && {
        if (questions_.isEmpty()) complete(needs_);
        if (!questions_.isEmpty()) return std::move(questions_);
        return std::move(plan_);
    }

  private:
    void complete(const Needs& needs) {
        for (const scene::NodeIndex& node : nodes_.order) planNode(node, needs);
        if (options_.everything && &nodes_ == &scene_.frame) planUndrawnPrograms(true);
        const std::set<scene::TextureIndex> idle = idleNoise();
        for (const scene::TextureIndex each : scene_.textures.indices())
            if (needs.textures[each] && !idle.contains(each)) plan_.textures.push_back(each);
        for (const scene::BufferIndex each : scene_.buffers.indices())
            if (needs.buffers.size() > each.position() && needs.buffers[each]) plan_.buffers.push_back(each);
        if (std::ranges::any_of(plan_.buffers, [this](auto each) { return lacksStructure(each); }))
            planUndrawnPrograms(false);
        listAttributes();
        plan_.accesses = accessesOf(scene_, plan_, options_.everything);
        if (options_.reportsNames) {
            const FramePlan* own = &plan_;
            for (const Diagnostic& each : reportNames(scene_, {&own, 1}, options_.overrides))
                remarks_.report(each);
        }
        findBeginnings(scene_, plan_);
        if (options_.shareTargets && !options_.everything)
            plan_.sharing = sharedTargets(scene_, plan_, options_.roots);
        if (!options_.everything) plan_.skipped = SkipList(scene_, needs, plan_).list();
    }

    /// Built-in noise that is planned only because all textures are, unless PlanOptions::idleNoise.
    [[nodiscard]] std::set<scene::TextureIndex> idleNoise() const {
        std::set<scene::TextureIndex> idle;
        if (!options_.everything || options_.idleNoise) return idle;
        for (const scene::TextureIndex each : scene_.textures.indices()) {
            const auto* noise = std::get_if<scene::NoiseSource>(&scene_.textures[each].source);
            if (noise != nullptr && !noise->file && noise->remarks.empty()) idle.insert(each);
        }
        plan_.visitStatements([&](const auto& planned, const auto&) {
            for (const TextureUse& use : planned.textures) idle.erase(use.view.texture);
        });
        return idle;
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
        remarks_.report(
            diagnose("memory-E01", "Dispatch needs a driver with " + options_.lacksCompute, dispatch.place));
    }

    /// A dispatch that writes nothing is skipped, which may be due to a mistake in its program.
    void reportWithoutEffect(const scene::Dispatch& dispatch) {
        if (!options_.lacksCompute.empty()) return;
        const std::vector<ObjectUse> uses = programs_.usesOf(dispatch);
        const PlannedProgramIndex program = programs_.of(dispatch);
        if (std::ranges::none_of(uses, &ObjectUse::writes)) announce(program);
        for (const Diagnostic& each : programs_.state(program).diagnostics)
            if (each.id == "glib-E16") remarks_.report(each);  // a key of the statement, misspelt
    }

    void planDispatch(std::size_t index) {
        const scene::Dispatch& dispatch = nodes_.dispatches[index];
        const PlannedProgramIndex program = programs_.of(dispatch);
        announce(program);
        if (!programs_[program].interface->usable) return;
        Diagnostics problems = programs_.state(program).badBindings;
        append(problems, unitProblems(program, "Dispatch", dispatch.place));
        for (const Diagnostic& each : problems) remarks_.report(each);
        if (hasError(problems)) return;
        const std::vector<TextureUse>& uses = programs_.texturesOf(dispatch, program);
        remarks_.emptySlots(dispatch.place, program, uses);
        remarks_.hazards("Dispatch", dispatch.place, program, uses);
        plan_.order.push_back({scene::NodeIndex::Kind::dispatch, plan_.dispatches.size()});
        plan_.dispatches.push_back({index, program, uses});
    }

    void planPass(std::size_t index, const std::vector<StepNeed>& needs) {
        const scene::Pass& pass = nodes_.passes[index];
        PlannedPass result;
        result.pass = index;
        result.steps.reserve(static_cast<std::size_t>(std::ranges::count(needs, StepNeed::needed)));
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
        remarks_.missingStage(draw, interface);

        if (!interface.usable) return planUnusable(step, index, result);
        const Result<Submission> submission = submissionOf(scene_, draw, program, interface);
        Diagnostics problems = submission.diagnostics;
        append(problems, unitProblems(index, draw.word, draw.place));
        append(problems, programs_.state(index).badBindings);
        const std::vector<TextureUse>& uses = programs_.texturesOf(draw, index);
        append(problems, feedback(draw, pass, index, uses));
        append(problems, outputProblems(scene_, draw, pass, interface));
        for (const Diagnostic& each : problems) remarks_.report(each);
        if (!submission || hasError(problems)) return;

        remarks_.ofDraw(draw, index, program, *submission, uses);
        const std::bitset<base::kRasterTargets> unwritten = targetsWithoutOutput(draw, pass, interface);
        if (unwritten.any()) remarks_.unwritten(draw, pass, index, unwritten);
        remarks_.layers(draw, pass, index);
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

    /// State::unitProblems at a statement.
    Diagnostics unitProblems(PlannedProgramIndex program, const std::string& word, const Place& place) {
        Diagnostics problems = programs_.state(program).unitProblems;
        for (Diagnostic& each : problems) {
            each.place = place;
            each.text = word + ": " + each.text;
        }
        return problems;
    }

    void announce(PlannedProgramIndex program) {
        if (std::exchange(programs_.state(program).isAnnounced, true)) return;
        for (const Diagnostic& each : programs_.state(program).diagnostics) remarks_.report(each);
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
            const std::string text =
                texture.name.empty()
                    ? fmt::format("{} samples unit {} while rendering into it (RenderToTexture on line {})",
                                  draw.word, unit, pass.place.line)
                    : fmt::format(
                          "{} samples {} while drawing into it (line {}); {}", draw.word,
                          nameOf(scene_, uses[i].view), pass.place.line,
                          pass.targets.empty() && !pass.isWindow
                              ? "use a program here that does not read it: depth alone needs only a vertex "
                                "stage"
                              : fmt::format(
                                    "read another part, or declare '{0}' with history and read '{0}.prev'",
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

    /// Returns the mesh of the draw's shape and records the attributes that this program reads.
    PlannedMeshIndex meshOf(const scene::Draw& draw, PlannedProgramIndex program, PlannedInputsIndex inputs,
                            geometry::Topology submitted) {
        const std::optional<geometry::Topology> adjacency =
            addedAdjacency(scene_.shapes[draw.shape], submitted);
        const glsl::ExpandedGeometry& expanded = programs_[program].interface->facts.expanded;
        const bool isExpanded = expanded.corners > 0 || expanded.numbersPrimitives;
        PlannedMeshIndex& mesh = isExpanded  ? expandedMeshes_[{draw.shape, submitted}]
                                 : adjacency ? adjacentMeshes_[{draw.shape, *adjacency}]
                                             : meshOfShape_[draw.shape];
        if (!mesh || !options_.shareMeshes) mesh = plan_.meshes.add({draw.shape, {}, adjacency, isExpanded});
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

    /// True if the buffer has the type of a structure that no program so far declares.
    [[nodiscard]] bool lacksStructure(scene::BufferIndex buffer) const {
        const std::string& type = scene_.buffers[buffer].type;
        const auto declares = [&](const PlannedProgram& program) {
            return program.interface->facts.memory.structures.contains(type);
        };
        return !type.empty() && !patternOf(type, {}) && std::ranges::none_of(plan_.programs, declares);
    }

    /// `glibra check` also compiles programs without draws, and reports their mistakes.
    void planUndrawnPrograms(bool announces) {
        std::set<scene::ProgramIndex> drawn = programsOf(scene_.frame);
        for (const scene::OnceBlock& each : scene_.once) drawn.merge(programsOf(each.nodes));
        for (const scene::StepBlock& each : scene_.steps) drawn.merge(programsOf(each.nodes));
        for (const scene::ProgramIndex i : scene_.programs.indices()) {
            const scene::Program& program = scene_.programs[i];
            const bool isFullScreen = scene_.suppliesNames && isWithoutVertexStage(program);
            const bool isCompute = program.hasStage(glsl::Stage::compute) && options_.lacksCompute.empty();
            const bool isDrawable = program.hasStage(glsl::Stage::fragment) &&
                                    (program.hasStage(glsl::Stage::vertex) || isFullScreen);
            if (drawn.contains(i) || !(isDrawable || isCompute)) continue;
            // What a draw would set is not known.
            ProgramVariant variant = plainVariant(scene_, i);
            variant.isFullScreen = isFullScreen;
            const PlannedProgramIndex undrawn = programs_.of(variant);
            if (scene_.suppliesNames)
                std::erase_if(programs_.state(undrawn).diagnostics, [](const Diagnostic& each) {
                    return each.id == "glib-W37" || each.id == "memory-E02" ||
                           (each.id == "glsl-W11" && each.subject == "vST");  // Fill gives it
                });
            if (announces) announce(undrawn);
        }
    }

    const scene::Scene& scene_;
    const scene::NodeList& nodes_;
    const PlanOptions& options_;
    Questions questions_;
    FramePlan plan_;
    PlannedPrograms programs_;
    Needs needs_;
    scene::List<PlannedMeshIndex, scene::Shape> meshOfShape_;
    std::map<std::pair<scene::ShapeIndex, geometry::Topology>, PlannedMeshIndex> adjacentMeshes_,
        expandedMeshes_;
    scene::List<std::set<std::string>, scene::Shape> reads_;  ///< attributes that some program reads
    bool reportedCompute_ = false;
    DrawRemarks remarks_{scene_, programs_, plan_, options_.clipsFromZero};
};

}  // namespace

std::variant<FramePlan, Questions> planFrame(const scene::Scene& scene, const scene::NodeList& nodes,
                                             const Answers& answers, const PlanOptions& options) {
    return FramePlanner(scene, nodes, answers, options).plan();
}

}  // namespace glibra::plan
