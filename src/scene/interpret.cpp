#include "scene/interpret.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <utility>
#include <vector>

#include "glib/command_table.h"
#include "glib/number.h"
#include "scene/state.h"

namespace glibra::scene {
namespace {

using glib::CommandId;

void execute(Interpreter& in, const glib::Command& command) {
    const CommandAction* known = actionOf(command.id);
    if (known == nullptr) return;
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
    action.handler(in, command);
}

/// All actions by CommandId. The element of a command without an action has no handler.
std::vector<CommandAction> allActions() {
    std::vector<CommandAction> all(static_cast<std::size_t>(CommandId::firstPrimitive));
    for (const auto& some :
         {viewActions(), drawActions(), listActions(), passActions(), textureActions(), programActions()})
        for (const CommandAction& each : some) all.at(static_cast<std::size_t>(each.id)) = each;
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

std::string textOf(const glib::Command& command) {
    std::string text = command.word;
    const std::size_t shown = std::min(command.numbers.size(), std::size_t{16});
    for (std::size_t i = 0; i < shown; ++i) text += " " + glib::numberText(command.numbers[i]);
    if (!command.text.empty()) text += fmt::format(" '{}'", command.text);
    for (const std::string& file : command.files) text += fmt::format(" '{}'", file);
    return text;
}

FileIndex fileOf(Interpreter& in, const std::string& name, const Place& place) {
    FileIndex& index = in.files[name];
    if (!index) index = in.scene.files.add(findFile(name, place, in.folders, in.listings));
    return index;
}

Scene interpret(const glib::Script& script, const InterpretOptions& options) {
    Interpreter in{.script = script,
                   .log = glib::MessageLog(script.path),
                   .scene = {},
                   .state = {},
                   .folders = searchFolders(script.path, options),
                   .listings = {},
                   .list = {},
                   .files = {},
                   .shapes = {},
                   .listShapes = {},
                   .clearedTextures = {},
                   .depthBuffers = {},
                   .clearedDepths = {},
                   .windowSize = {}};
    in.scene.path = script.path;
    in.scene.verbose =
        std::any_of(script.commands.begin(), script.commands.end(),
                    [](const glib::Command& command) { return command.id == CommandId::verbose; });
    try {
        addNoiseTextures(in);
        for (const glib::Command& command : script.commands) execute(in, command);
        checkList(in);
        checkStack(in);
        finishPasses(in);
        finishNoise(in);
    } catch (const std::exception& problem) {
        in.report(diagnose("glib-E15", fmt::format("the scene cannot be run: {}", problem.what()),
                           script.place({})));
    }
    in.scene.diagnostics = in.log.take();
    return std::move(in.scene);
}

}  // namespace glibra::scene
