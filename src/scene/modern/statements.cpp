// How the statements of a script run, and how many may.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glib/modern/statement_table.h"
#include "glib/number.h"
#include "scene/modern/modern.h"
#include "scene/modern/scope.h"
#include "scene/state.h"

namespace glibra::scene {

using glib::Command;
using glib::CommandId;

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
        if (in.scene.isModern && !countStatement(in, command)) return;
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
    const auto found = std::find(files.begin(), files.end(), in.script);
    return found == files.end() ? 0 : static_cast<int>(found - files.begin()) + 1;
}

void expectNames(Interpreter& in) {
    for (const Command& each : in.script->commands) {
        if (each.id == CommandId::expect) in.modern.checks.areThere = true;
        const glib::StatementRow* row = each.isModern ? glib::statementOf(each.id) : nullptr;
        if (row == nullptr || !row->declaresName || each.values.empty()) continue;
        const glib::Value& name = each.values.front();
        in.shared->environment.expect(name.path.empty() ? name.text : name.path.front().name);
    }
}

namespace {

/// Reports once that the frame is too long. Nothing more of it runs.
bool stop(Interpreter& in, const Place& place, std::string_view what, std::size_t most) {
    if (!std::exchange(in.counts.isFull, true))
        in.report(diagnose("glib-E28",
                           fmt::format("the frame has more than {} {}",
                                       glib::groupedText(static_cast<long long>(most)), what),
                           place));
    return false;
}

}  // namespace

bool countStatement(Interpreter& in, const Command& command) {
    return ++in.counts.statements <= kMostStatements ||
           stop(in, in.place(command), "statements, with repetitions", kMostStatements);
}

bool countRound(Interpreter& in, const Command& command) {
    return ++in.counts.rounds <= kMostStatements ||
           stop(in, in.place(command), "rounds of Repeat", kMostStatements);
}

bool countElements(Interpreter& in, const glib::Value& owner, double count) {
    in.counts.elements += static_cast<std::size_t>(count);
    return in.counts.elements <= kMostElements ||
           stop(in, in.place(owner), "elements that are computed", kMostElements);
}

}  // namespace glibra::scene
