#include "scene/run/statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "glib/number.h"
#include "glib/statement_table.h"
#include "scene/run/evaluate.h"
#include "scene/run/names.h"
#include "scene/run/scope.h"

namespace glibra::scene {

namespace {

/// A classic command with expressions among its arguments, with their values of this moment; nothing if one
/// has none.
std::optional<Command> evaluated(Interpreter& in, const Command& command) {
    const auto numbers = evaluatedNumbers(in, command.values);
    Command result = command;
    result.isEvaluatedLater = false;
    const glib::StatementRow& row = *glib::findCommand(glib::nameOf(command.id));
    return numbers && fillNumbers(in, row, *numbers, result) ? std::optional(std::move(result))
                                                             : std::nullopt;
}

/// Remembers the name that a faulty statement would have declared.
void noteLost(Interpreter& in, const Command& command) {
    const glib::StatementRow* row = command.isModern ? glib::statementOf(command.id) : nullptr;
    if (row == nullptr || !row->declaresName || command.values.empty()) return;
    const Value& name = command.values.front();
    in.modern.lostNames.insert(headOf(name));
}

}  // namespace

const CommandAction* actionOf(std::span<const CommandAction> actions, CommandId command) {
    const auto index = static_cast<std::size_t>(command);
    return index < actions.size() && actions[index].handler != nullptr ? &actions[index] : nullptr;
}

void execute(Interpreter& in, const Command& command) {
    const CommandAction* known = actionOf(in.actions, command.id);
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
    if (in.scene.verbose && !action.draws) in.reportAt(command, "glib-N02", textOf(command));
    const std::size_t problems = in.problems;
    action.handler(in, command);
    if (in.problems > problems) noteLost(in, command);
}

std::string textOf(const Command& command) {
    std::string text = command.word;
    const std::size_t shown = std::min(command.numbers.size(), std::size_t{16});
    for (std::size_t i = 0; i < shown; ++i) text += " " + glib::numberText(command.numbers[i]);
    const bool showsValues =
        !command.isModern || command.id == CommandId::program || command.id == CommandId::compute;
    for (const Value& each : command.values)
        if (showsValues && !isNumeric(each) && !each.text.empty()) text += fmt::format(" '{}'", each.text);
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

void runBody(Interpreter& in, std::size_t first, std::size_t last) {
    ++in.around.blocks;
    run(in, first, last);
    --in.around.blocks;
    if (in.state.stack.empty()) return;
    in.report(diagnose("glib-W31", "PushMatrix without PopMatrix at the end of the block",
                       in.state.stack.back().place));
}

std::size_t indexOf(const Interpreter& in, const Command& command) {
    return static_cast<std::size_t>(&command - in.script->commands.data());
}

void run(Interpreter& in, std::size_t first, std::size_t last) {
    if (in.modern.checks.areThere && first > 0)
        in.modern.checks.bodies.insert(&in.script->commands[first - 1]);
    for (std::size_t i = first; i < last && !in.counts.isFull;) {
        const Command& command = in.script->commands[i];
        if (in.isModern && !countStatement(in, command)) return;
        in.running = {in.script, command.position};
        execute(in, command);
        // A command that opens a block has run the block.
        const bool opens = command.partner != Command::kNoPartner && command.partner > i;
        const std::size_t end = opens ? command.partner : i;
        const bool hasElse = opens && in.script->commands[end].id == CommandId::elseBranch;
        i = (hasElse ? in.script->commands[end].partner : end) + 1;
    }
}

int fileNumber(const Interpreter& in) {
    const std::vector<const glib::Script*>& files = in.shared->files.includedOrder;
    const auto found = std::ranges::find(files, in.script);
    return found == files.end() ? 0 : static_cast<int>(found - files.begin()) + 1;
}

void expectNames(Interpreter& in) {
    for (const Command& each : in.script->commands) {
        if (each.id == CommandId::expect) in.modern.checks.areThere = true;
        if (each.id == CommandId::pass && each.key("reversed") != nullptr && !each.values.empty() &&
            isWindow(each.values.front()))
            in.scene.reversesWindow = true;
        const glib::StatementRow* row = each.isModern ? glib::statementOf(each.id) : nullptr;
        if (row == nullptr || !row->declaresName || each.values.empty()) continue;
        const Value& name = each.values.front();
        in.names().expect(headOf(name));
    }
}

void setTime(Interpreter& in) {
    Environment& names = in.names();
    names.setNumber("time", in.inputs.time);
    names.setNumber("dt", 1 / in.shared->frameRate);
    names.setNumber("frame", std::floor(in.inputs.time * in.shared->frameRate));
    const std::array mouse{in.inputs.mouseX, in.inputs.mouseY};
    names.set("mouse", mouse);
    names.setNumber("mouse.down", in.inputs.isMouseDown ? 1 : 0);
    names.forget("tick", "only Step counts ticks");
}

}  // namespace glibra::scene
