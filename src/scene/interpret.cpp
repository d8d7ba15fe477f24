#include "scene/interpret.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <utility>
#include <vector>

#include "glib/arguments.h"
#include "glib/command_table.h"
#include "glib/message_log.h"
#include "glib/number.h"
#include "scene/modern/evaluate.h"
#include "scene/modern/scope.h"
#include "scene/state.h"

namespace glibra::scene {
namespace {

using glib::CommandId;

/// A classic command with expressions among its arguments, with their values of this moment; nothing if one
/// has none.
std::optional<glib::Command> evaluated(Interpreter& in, const glib::Command& command) {
    std::vector<glib::EvaluatedNumber> numbers;
    for (const glib::Value& each : command.values) {
        const auto values = numbersOf(in, {&each, 1});
        if (!values) return std::nullopt;
        const bool isLiteral = each.kind != glib::Value::Kind::expression;
        for (const double value : *values) numbers.push_back({value, each.position, isLiteral});
    }
    glib::Command result = command;
    result.isEvaluatedLater = false;
    glib::MessageLog log(in.script->path);
    glib::evaluateNumbers(*glib::findCommand(glib::nameOf(command.id)), result, numbers, log);
    const bool isFaulty = log.errorCount() > 0;
    for (Diagnostic& each : log.take()) in.report(std::move(each));
    return isFaulty ? std::nullopt : std::optional(std::move(result));
}

/// Remembers the name that a faulty statement would have declared.
void noteLost(Interpreter& in, const glib::Command& command) {
    const glib::StatementRow* row = command.isModern ? glib::statementOf(command.id) : nullptr;
    if (row == nullptr || !row->declaresName || command.values.empty()) return;
    const glib::Value& name = command.values.front();
    in.modern.lostNames.insert(name.path.empty() ? name.text : name.path.front().name);
}

/// Reports draw-N04 for the programs after the last statement that draws.
void reportIdlePrograms(Interpreter& in) {
    const std::vector<glib::Command>& commands = in.script->commands;
    const auto last = std::find_if(commands.rbegin(), commands.rend(), [](const glib::Command& each) {
        const CommandAction* action = actionOf(each.id);
        return each.id == CommandId::include || (action != nullptr && action->draws);
    });
    if (last == commands.rend()) return;
    for (auto each = last.base(); each != commands.end(); ++each)
        if (each->id == CommandId::program)
            in.reportAt(*each, "draw-N04",
                        fmt::format("Program '{}' stands after everything that is drawn, so nothing uses it; "
                                    "move it before the shapes",
                                    each->text));
}

/// The statement of a stage that no Program has taken yet.
struct PendingStage {
    const glib::Command* command;
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
    const auto report = [&](const glib::Command* before) {
        if (lost.empty()) return;
        std::sort(lost.begin(), lost.end(), [](const PendingStage& a, const PendingStage& b) {
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
    const glib::Command* replacing = nullptr;  // the first of `lost`
    for (const glib::Command& each : in.script->commands) {
        switch (each.id) {
            case CommandId::vertex:
            case CommandId::tessControl:
            case CommandId::tessEvaluation:
            case CommandId::geometry:
            case CommandId::fragment:
            case CommandId::compute: {
                const auto known = pending.find(each.id);
                const bool isAgain =
                    known != pending.end() && !each.text.empty() && known->second.file == each.text;
                if (known != pending.end() && !isAgain) {
                    if (lost.empty()) replacing = &each;
                    lost.push_back(known->second);
                }
                pending.erase(each.id);
                if (!each.text.empty() || !each.body.empty())
                    pending.emplace(each.id, PendingStage{&each, each.text});
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

/// All actions by CommandId. The element of a command without an action has no handler.
std::vector<CommandAction> allActions() {
    std::vector<CommandAction> all(static_cast<std::size_t>(CommandId::firstPrimitive));
    for (const auto& some :
         {viewActions(), drawActions(), listActions(), passActions(), textureActions(), programActions()})
        for (const CommandAction& each : some) all.at(static_cast<std::size_t>(each.id)) = each;
    for (const auto& some :
         {structureActions(), variableActions(), tagActions(), lightActions(), cameraActions(),
          objectActions(), targetActions(), stateActions(), vertexActions(), bufferActions(), meshActions(),
          blockActions(), keyActions(), checkActions()})
        for (CommandAction each : some) {
            each.isModern = true;
            all.at(static_cast<std::size_t>(each.id)) = each;
        }
    return all;
}

}  // namespace

const CommandAction* actionOf(CommandId command) {
    static const std::vector<CommandAction> kActions = allActions();
    static constexpr CommandAction kPrimitive{.handler = doPrimitive, .draws = true};
    const auto index = static_cast<std::size_t>(command);
    if (index < kActions.size()) return kActions[index].handler != nullptr ? &kActions[index] : nullptr;
    return glib::primitiveOf(command) != nullptr ? &kPrimitive : nullptr;
}

void execute(Interpreter& in, const glib::Command& command) {
    const CommandAction* known = actionOf(command.id);
    if (known == nullptr) return;
    // The handlers of modern statements rely on what the parser has checked.
    if (known->isModern && !command.isModern) return;
    if (command.isEvaluatedLater) {
        if (const auto now = evaluated(in, command)) execute(in, *now);
        return;
    }
    const CommandAction& action = *known;
    if (in.list && action.inList == InList::isWrong) {
        in.reportAt(command, "glib-E07",
                    fmt::format("{} is not allowed inside glBegin ... glEnd", command.word));
        return;
    }
    if (in.list && action.inList == InList::goesFirst)
        in.reportAt(command, "glib-W32",
                    fmt::format("{} is inside glBegin ... glEnd; it {} before the list", command.word,
                                action.draws ? "is drawn" : "takes effect"));
    if (action.inList != InList::isPart) in.isOrphan = false;
    if (in.scene.verbose && !action.draws)
        in.report(diagnose("glib-N02", textOf(command), in.place(command)));
    const std::size_t problems = in.problems;
    action.handler(in, command);
    if (in.problems > problems) noteLost(in, command);
}

std::string textOf(const glib::Command& command) {
    std::string text = command.word;
    const std::size_t shown = std::min(command.numbers.size(), std::size_t{16});
    for (std::size_t i = 0; i < shown; ++i) text += " " + glib::numberText(command.numbers[i]);
    if (!command.text.empty()) text += fmt::format(" '{}'", command.text);
    for (const std::string& file : command.files) text += fmt::format(" '{}'", file);
    return text;
}

FileIndex fileOf(Interpreter& in, const std::string& name, const Place& place) {
    return fileNamed(in, name, [&] { return findFile(name, place, in.folders, in.listings); });
}

FileIndex fileNamed(Interpreter& in, const std::string& key, const std::function<FileReference()>& make) {
    FileIndex& index = in.shared->files.indices[key];
    if (index) return index;
    in.shared->files.all.push_back(make());
    return index = in.scene.files.add(in.shared->files.all.back());
}

double windowAspect(const Interpreter& in) {
    const int width = in.inputs.width > 0 ? in.inputs.width : in.scene.width;
    const int height = in.inputs.height > 0 ? in.inputs.height : in.scene.height;
    return static_cast<double>(width) / height;
}

void setTime(Interpreter& in) {
    Environment& names = in.shared->environment;
    names.setNumber("time", in.inputs.time);
    names.setNumber("dt", 1 / in.shared->frameRate);
    names.setNumber("frame", std::floor(in.inputs.time * in.shared->frameRate));
    const std::array mouse{in.inputs.mouseX, in.inputs.mouseY};
    names.set("mouse", mouse);
    names.setNumber("mouse.down", in.inputs.isMouseDown ? 1 : 0);
    names.forget("tick", "only Step counts ticks");
}

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
    for (const glib::Command& each : script.commands) {
        if (each.id == CommandId::vertex || each.id == CommandId::fragment)
            scene.hasStages = scene.hasStages || each.isModern || !each.text.empty();
        if (each.id == CommandId::group)
            for (const glib::KeyedValues& parameter : each.tags) scene.localNames.insert(parameter.key);
        if (each.id != CommandId::repeat) continue;
        const glib::KeyedValues* as = each.key("as");
        scene.localNames.insert(as != nullptr ? as->values.front().text : "i");
    }
}

/// The values of the names that every scene has.
void setInputs(Interpreter& in) {
    Environment& names = in.shared->environment;
    names.beginFrame();
    in.shared->frameRate = kFramesPerSecond;
    setTime(in);
    for (const auto& [name, camera] : in.shared->seen.previous)
        names.setCamera(name.first + ".prev", camera, name.second);
}

/// Adds what an earlier run of the same frame has reported, and this one has not.
void addMissing(Diagnostics& diagnostics, Diagnostics earlier) {
    const auto isKnown = [&](const Diagnostic& each) {
        return std::any_of(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& other) {
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
                   .inputs = inputs,
                   .log = glib::MessageLog(script.path),
                   .folders = folders};
    in.modern.lostNames = script.lostNames;
    in.out.nodes = &in.scene.frame;
    in.scene.files = shared.files.all;  // the indices of files are those of earlier frames
    in.scene.path = script.path;
    in.scene.isModern = script.isModern;
    in.scene.verbose =
        std::any_of(script.commands.begin(), script.commands.end(),
                    [](const glib::Command& command) { return command.id == CommandId::verbose; });
    for (const glib::Command& each : script.withoutFile)
        in.scene.missingFiles.push_back(
            {std::string(glib::nameOf(each.id)), script.place(each.position), false});
    noteNames(in.scene, script);
    shared.depends = expression::Depends::nothing;
    shared.seen.foundAspects.clear();
    try {
        setInputs(in);
        addNoiseTextures(in);
        expectNames(in);
        scene::run(in, 0, script.commands.size());
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
        if (in.scene.isModern) in.scene.mayBeWritten = undecidedWrites(in);
        in.scene.idleChecks = idleChecks(in);
    } catch (const std::exception& problem) {
        in.report(diagnose("glib-E15", fmt::format("the scene cannot be run: {}", problem.what()),
                           script.place({})));
    }
    in.scene.diagnostics = in.log.take();
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
    // Problems of values count once the cameras of the frame before are known.
    std::erase_if(scene.diagnostics, [](const Diagnostic& each) { return each.id == "expr-E06"; });
    for (auto& [value, readings] : shared.computed.expressions)
        readings.forEach([](ReadExpression& each) { each.isProblemReported = false; });
    runAgain();
    return scene;
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

expression::Depends Interpretation::depends() const {
    return state_->shared.depends;
}

Scene interpret(const glib::Script& script, const InterpretOptions& options) {
    return Interpretation(script, options).at({});
}

}  // namespace glibra::scene
