#include "scene/interpret.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <utility>

#include "base/text.h"
#include "geometry/shapes/primitive.h"
#include "glib/messages.h"
#include "glib/statement_table.h"
#include "scene/actions.h"
#include "scene/classic/classic.h"
#include "scene/modern/modern.h"
#include "scene/run/camera_use.h"
#include "scene/run/scope.h"
#include "scene/run/statements.h"
#include "scene/run/uniforms.h"

namespace glibra::scene {
namespace {

/// Reports draw-N04 for the programs after the last statement that draws.
void reportIdlePrograms(Interpreter& in) {
    const std::vector<Command>& commands = in.script->commands;
    const auto last = std::find_if(commands.rbegin(), commands.rend(), [&](const Command& each) {
        const CommandAction* action = actionOf(in.actions, each.id);
        return each.id == CommandId::include || (action != nullptr && action->draws);
    });
    if (last == commands.rend()) return;
    for (auto each = last.base(); each != commands.end(); ++each)
        if (each->id == CommandId::program)
            in.reportAt(*each, "draw-N04",
                        fmt::format("Program '{}' stands after everything that is drawn, so nothing uses it; "
                                    "move it before the shapes",
                                    each->text()));
}

/// The statement of a stage that no Program has taken yet.
struct PendingStage {
    const Command* command;
    std::string file;  ///< empty: a shader in the script
};

std::string listOfStages(const std::vector<PendingStage>& stages) {
    std::string text;
    for (std::size_t i = 0; i < stages.size(); ++i)
        text += fmt::format("{}{} (line {})",
                            i == 0                   ? ""
                            : i + 1 == stages.size() ? " and "
                                                     : ", ",
                            stages[i].command->word, stages[i].command->position.line);
    return text;
}

/// Reports draw-W16 for shaders that no Program takes before others take their place or the script ends. An
/// included file may have the Program.
void reportStagesWithoutProgram(Interpreter& in) {
    std::map<CommandId, PendingStage> pending;
    std::vector<PendingStage> lost;
    const auto report = [&](const Command* before) {
        if (lost.empty()) return;
        std::ranges::sort(lost, [](const PendingStage& a, const PendingStage& b) {
            return a.command->position.line < b.command->position.line;
        });
        in.reportAt(
            *lost.front().command, "draw-W16",
            fmt::format(
                "{} belong{} to no Program, so nothing is drawn with {}; write 'Program NAME' "
                "after {}{}",
                listOfStages(lost), lost.size() == 1 ? "s" : "", lost.size() == 1 ? "it" : "them",
                lost.size() == 1 ? "it" : "them",
                before != nullptr ? fmt::format(", before line {}", before->position.line) : std::string()));
        lost.clear();
    };
    const Command* replacing = nullptr;  // the first of `lost`
    for (const Command& each : in.script->commands) {
        switch (each.id) {
            case CommandId::vertex:
            case CommandId::tessControl:
            case CommandId::tessEvaluation:
            case CommandId::geometry:
            case CommandId::fragment:
            case CommandId::compute: {
                const auto known = pending.find(each.id);
                const bool isAgain =
                    known != pending.end() && !each.values.empty() && known->second.file == each.text();
                if (known != pending.end() && !isAgain) {
                    if (lost.empty()) replacing = &each;
                    lost.push_back(known->second);
                }
                pending.erase(each.id);
                if (!each.values.empty() || !each.body.empty())
                    pending.emplace(each.id, PendingStage{&each, each.text()});
                break;
            }
            case CommandId::program:
                report(replacing);
                if (pending.erase(CommandId::compute) == 0) pending.clear();  // it takes that stage alone
                break;
            case CommandId::include:
                lost.clear();
                pending.clear();
                break;
            default:
                break;
        }
    }
    report(replacing);
    for (const auto& [id, stage] : pending) lost.push_back(stage);
    report(nullptr);
}

}  // namespace

struct Interpretation::State {
    glib::Script script;
    InterpretOptions options;
    SearchFolders folders;
    SharedState shared;
    std::vector<NamedCamera> cameras;  ///< of the last scene

    Scene run(const FrameInputs& inputs);
    /// Runs the frame before for its cameras, whatever ran last.
    void runBefore(const FrameInputs& inputs);
};

namespace {

constexpr double kFramesPerSecond = 60;

/// Notes what messages about programs mention.
void noteNames(Scene& scene, const glib::Script& script) {
    for (const Command& each : script.commands) {
        if (each.id == CommandId::vertex || each.id == CommandId::fragment)
            scene.hasStages = scene.hasStages || each.isModern || !each.values.empty();
        if (each.id == CommandId::group)
            for (const KeyedValues& parameter : each.tags) scene.localNames.insert(parameter.key);
        if (each.id != CommandId::repeat) continue;
        const KeyedValues* as = each.key("as");
        scene.localNames.insert(as != nullptr ? as->values.front().text : "i");
    }
}

/// Notes the names that no value of a uniform has.
void noteOtherNames(Interpreter& in) {
    using Kind = DeclaredName::Kind;
    for (const auto& [name, declared] : in.modern.names)
        if (declared.kind == Kind::camera || declared.kind == Kind::sampler || declared.kind == Kind::mesh)
            in.scene.otherNames.insert(name);
    for (const auto& [name, group] : in.modern.groups) in.scene.otherNames.insert(name);
}

/// The values of the names that every scene has.
void setInputs(Interpreter& in) {
    Environment& names = in.names();
    names.beginFrame();
    in.shared->frameRate = kFramesPerSecond;
    setTime(in);
    for (const auto& [name, camera] : in.shared->seen.previous)
        names.setCamera(name.first + ".prev", camera, name.second);
}

/// Adds what an earlier run of the same frame has reported, and this one has not.
void addMissing(Diagnostics& diagnostics, Diagnostics earlier) {
    const auto isKnown = [&](const Diagnostic& each) {
        return std::ranges::any_of(diagnostics, [&](const Diagnostic& other) {
            return other.id == each.id && other.text == each.text && other.place == each.place;
        });
    };
    std::erase_if(earlier, isKnown);
    diagnostics.insert(diagnostics.begin(), std::make_move_iterator(earlier.begin()),
                       std::make_move_iterator(earlier.end()));
}

}  // namespace

Scene Interpretation::State::run(const FrameInputs& inputs) {
    Interpreter in{.script = &script,
                   .shared = &shared,
                   .actions = allActions(),
                   .inputs = inputs,
                   .log = glib::MessageLog(script.path),
                   .folders = folders,
                   .runsAll = options.runsAll};
    in.modern.lostNames = script.lostNames;
    in.out.nodes = &in.scene.frame;
    in.scene.files = shared.files.all;  // the indices of files are those of earlier frames
    in.scene.path = script.path;
    in.isModern = script.isModern;
    in.scene.suppliesNames = in.isModern;
    in.scene.goesOn = !in.isModern;
    in.scene.verbose = std::ranges::any_of(
        script.commands, [](const Command& command) { return command.id == CommandId::verbose; });
    for (const Command& each : script.withoutFile)
        in.scene.missingFiles.push_back(
            {std::string(glib::nameOf(each.id)), script.place(each.position), false});
    noteNames(in.scene, script);
    shared.depends = expression::Depends::nothing;
    shared.seen.foundAspects.clear();
    for (const Diagnostic& each : shared.found) in.report(each);
    try {
        setInputs(in);
        addNoiseTextures(in);
        expectNames(in);
        scene::run(in, 0, script.commands.size());
        if (in.runsAll) drawOtherGroups(in);
        checkList(in);
        checkStack(in);
        finishPasses(in);
        finishNoise(in);
        if (!hasError(script.diagnostics) && in.log.errorCount() == 0) {  // else they may be consequences
            reportIdlePrograms(in);
            reportUnusedCameras(in);
            reportLateEye(in);
            reportUnusedRaster(in);
            reportStagesWithoutProgram(in);
        }
        shared.seen.cameras.clear();
        cameras.clear();
        for (const auto& [name, camera] : in.modern.cameras) {
            const auto aspects = shared.seen.aspects.find(name);
            const bool isSeen = aspects != shared.seen.aspects.end() && !aspects->second.empty();
            const double aspect = isSeen ? *aspects->second.begin() : windowAspect(in);
            shared.seen.cameras[name] = valuesOf(camera, aspect);
            cameras.push_back(
                {textOf(in, name), camera.view,
                 camera.clip || camera.aspect ? projectionOf(camera, aspect) : camera.projection,
                 camera.isMirrored});
        }
        if (const CameraName eye{"eye", 0}; findCamera(in, eye) == nullptr)
            shared.seen.cameras[eye] = valuesOf(classicCamera(in), windowAspect(in));
        in.scene.namedValues = namedValues(in);
        noteOtherNames(in);
        if (in.isModern) in.scene.mayBeWritten = undecidedWrites(in);
        in.scene.idleChecks = idleChecks(in);
    } catch (const std::exception& problem) {
        const auto& [of, position] = in.running;
        in.report(diagnose("glib-E14", "the scene cannot be run: " + base::reasonOf(problem),
                           (of != nullptr ? of : &script)->place(position)));
    }
    in.scene.diagnostics = in.log.take();
    in.scene.hiddenFiles = shared.files.hidden;
    hideTexts(in.scene.diagnostics, in.scene.hiddenFiles);
    return std::move(in.scene);
}

void Interpretation::State::runBefore(const FrameInputs& inputs) {
    FrameInputs before = inputs;
    const double passed = inputs.sinceStepBefore > 0 ? inputs.sinceStepBefore : 1 / shared.frameRate;
    before.time = std::max(0.0, inputs.time - passed);
    for (std::int64_t& tick : before.ticks) tick = std::max<std::int64_t>(0, tick - 1);
    shared.seen.previous.clear();
    shared.seen.isTrial = true;
    run(before);
    shared.seen.isTrial = false;
    shared.seen.previous = std::move(shared.seen.cameras);
}

Interpretation::Interpretation(glib::Script script, InterpretOptions options)
    : state_(std::make_unique<State>()) {
    state_->script = std::move(script);
    state_->folders = searchFolders(state_->script.path, options);
    state_->options = std::move(options);
}
Interpretation::Interpretation(Interpretation&&) noexcept = default;
Interpretation& Interpretation::operator=(Interpretation&&) noexcept = default;
Interpretation::~Interpretation() = default;

Scene Interpretation::at(const FrameInputs& inputs) {
    SharedState& shared = state_->shared;
    const bool knewPrevious = shared.seen.readsPrevious;
    shared.found.clear();
    const auto run = [&] {
        if (shared.seen.readsPrevious) state_->runBefore(inputs);
        return state_->run(inputs);
    };
    Scene scene = run();
    const auto runAgain = [&] {
        Scene again = run();
        addMissing(again.diagnostics, std::move(scene.diagnostics));
        scene = std::move(again);
    };
    // An expression reads the projection of a camera, and the passes that the camera sees have another shape
    // than expected.
    if (shared.seen.readsShapes && shared.seen.foundAspects != shared.seen.aspects) {
        shared.seen.aspects = shared.seen.foundAspects;
        runAgain();
    }
    if (!shared.seen.readsPrevious || knewPrevious) return scene;
    // Problems of values count once the cameras of the frame before are known, so all is read anew.
    std::erase_if(scene.diagnostics, [](const Diagnostic& each) { return each.id == "expr-E06"; });
    shared.computed.expressions.clear();
    runAgain();
    return scene;
}

Diagnostics Interpretation::mistakesLeftOut(const FrameInputs& inputs) const {
    constexpr std::string_view kOfText =
        "expr-E01 expr-E02 expr-E03 expr-E04 expr-E08 expr-E09 glib-E27 glib-E34";
    InterpretOptions options = state_->options;
    options.runsAll = true;
    Diagnostics found = Interpretation(state_->script, std::move(options)).at(inputs).diagnostics;
    // Two branches may give a variable two types.
    if (std::ranges::find(found, "glib-E36", &Diagnostic::id) != found.end()) return {};
    std::erase_if(found,
                  [&](const auto& each) { return each.id.empty() || kOfText.find(each.id) == kOfText.npos; });
    return found;
}

const glib::Script& Interpretation::script() const {
    return state_->script;
}

const std::vector<NamedCamera>& Interpretation::cameras() const {
    return state_->cameras;
}

std::vector<const glib::Script*> Interpretation::scripts() const {
    std::vector<const glib::Script*> scripts{&state_->script};
    scripts.insert(scripts.end(), state_->shared.files.includedOrder.begin(),
                   state_->shared.files.includedOrder.end());
    return scripts;
}

bool Interpretation::isFixed() const {
    return !state_->script.isModern;
}

expression::Depends Interpretation::depends() const {
    return state_->shared.depends;
}

Scene interpret(const glib::Script& script, const InterpretOptions& options) {
    return Interpretation(script, options).at({});
}

// ---- The actions of all statements

std::span<const CommandAction> allActions() {
    static const std::vector<CommandAction> kActions = [] {
        const auto first = static_cast<std::size_t>(CommandId::firstPrimitive);
        std::vector<CommandAction> all(first);
        all.resize(first + geometry::primitives().size(), {.handler = doPrimitive, .draws = true});
        for (const auto& some :
             {viewActions(), drawActions(), passActions(), textureActions(), programActions()})
            for (const CommandAction& each : some) all.at(static_cast<std::size_t>(each.id)) = each;
        for (const auto& some : {structureActions(), variableActions(), tagActions(), cameraActions(),
                                 objectActions(), targetActions(), stateActions(), vertexActions(),
                                 bufferActions(), blockActions(), checkActions()})
            for (const CommandAction& each : some) {
                all.at(static_cast<std::size_t>(each.id)) = each;
                all.at(static_cast<std::size_t>(each.id)).isModern = true;
            }
        return all;
    }();
    return kActions;
}

}  // namespace glibra::scene
