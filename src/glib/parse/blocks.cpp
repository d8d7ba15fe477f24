#include "glib/parse/blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "glib/limits.h"
#include "glib/number.h"

namespace glibra::glib {
namespace {

/// True for `Let name ( ... )`, which may stand anywhere, unlike other variables.
bool isComputed(const Command& command) {
    return command.id == CommandId::let && command.values.size() > 1 && !declaresFunction(command) &&
           command.values[1].kind == Value::Kind::expression;
}

std::string_view closerOf(CommandId opener) {
    for (const StatementRow& row : statementTable())
        if (row.role == BlockRole::closes && row.opener == opener) return row.name;
    return {};
}

}  // namespace

void BlockStack::checkPlace(const StatementRow& row, const Command& command) {
    if (row.standing == Standing::anywhere || isComputed(command)) return;
    const auto hinders = [&](const Block& block) {
        if (row.standing == Standing::notInPass) return block.row->id == CommandId::pass;
        return row.standing == Standing::outermost || block.row->id != CommandId::pass;
    };
    const auto found = std::ranges::find_if(blocks_, hinders);
    if (found == blocks_.end()) return;
    const bool isNumber = command.id == CommandId::let && command.values.size() > 1 &&
                          command.values[1].kind == Value::Kind::number;
    found->misplaced.push_back({row.name, command.position,
                                fmt::format("{} cannot stand inside {} (line {}); move it out{}", row.name,
                                            found->row->name, found->position.line,
                                            isNumber ? fmt::format(", or write ({}), which may stand here",
                                                                   numberText(command.values[1].number))
                                                     : std::string())});
}

void BlockStack::follow(const StatementRow& row, Position position, bool isFaulty,
                        std::vector<Command>& commands) {
    if (row.role == BlockRole::none) return;
    if (row.role == BlockRole::opens) return open(row, position, isFaulty, commands);
    if (tooDeep_ > 0 || !unwindTo(row, position)) {
        if (!isFaulty) commands.pop_back();
        if (tooDeep_ > 0 && row.role == BlockRole::closes) --tooDeep_;
        return;
    }
    if (row.role == BlockRole::divides) return divide(row, position, isFaulty, commands);
    close(isFaulty, commands);
}

void BlockStack::open(const StatementRow& row, Position position, bool isFaulty,
                      std::vector<Command>& commands) {
    if (blocks_.size() == kDeepestBlocks) {
        if (tooDeep_++ == 0)
            log_.report("glib-E15", fmt::format("blocks are nested more than {} deep", kDeepestBlocks),
                        position);
        if (!isFaulty) commands.pop_back();
        blocks_.back().isFaulty = true;
        return;
    }
    blocks_.push_back({.row = &row,
                       .position = position,
                       .index = isFaulty ? commands.size() : commands.size() - 1,
                       .isFaulty = isFaulty});
}

/// Ends the blocks inside the one that the statement belongs to. Returns false if there is no such block.
bool BlockStack::unwindTo(const StatementRow& row, Position position) {
    const auto found = std::find_if(blocks_.rbegin(), blocks_.rend(),
                                    [&](const Block& block) { return block.row->id == row.opener; });
    if (found == blocks_.rend()) {
        const auto unwound = std::ranges::find(unwound_, row.opener);
        if (unwound != unwound_.end() && row.role == BlockRole::closes) {
            unwound_.erase(unwound);
            return false;
        }
        log_.report("glib-E21", fmt::format("{} without {}", row.name, statementOf(row.opener)->name),
                    position);
        return false;
    }
    while (blocks_.back().row->id != row.opener) {
        reportOpen(blocks_.back(), fmt::format(" before {} (line {})", row.name, position.line));
        unwound_.push_back(blocks_.back().row->id);
        blocks_.pop_back();
        blocks_.back().isFaulty = true;
    }
    return true;
}

void BlockStack::divide(const StatementRow& row, Position position, bool isFaulty,
                        std::vector<Command>& commands) {
    Block& block = blocks_.back();
    if (block.isDivided)
        log_.report(
            "glib-E21",
            fmt::format("a second {} in {} (line {})", row.name, block.row->name, block.position.line),
            position);
    if (isFaulty || block.isDivided) block.isFaulty = true;
    block.isDivided = true;
    if (!block.isFaulty) block.divider = commands.size() - 1;
}

void BlockStack::close(bool isFaulty, std::vector<Command>& commands) {
    const Block block = std::move(blocks_.back());
    blocks_.pop_back();
    for (const Misplaced& each : block.misplaced) log_.report("glib-E23", each.text, each.position);
    if (block.isFaulty || isFaulty) {
        commands.resize(std::min(commands.size(), block.index));
        return;
    }
    const std::size_t last = commands.size() - 1;
    const bool isDivided = block.divider != Command::kNoPartner;
    commands[block.index].partner = isDivided ? block.divider : last;
    if (isDivided) commands[block.divider].partner = last;
    commands[last].partner = block.index;
}

void BlockStack::reportOpen(const Block& block, const std::string& before) {
    std::string advice = fmt::format("write {}", closerOf(block.row->id));
    if (!block.misplaced.empty())
        advice += fmt::format(" before {} (line {})", block.misplaced.front().word,
                              block.misplaced.front().position.line);
    log_.report("glib-E22", fmt::format("{} is not closed{}; {}", block.row->name, before, advice),
                block.position);
}

void BlockStack::finish(std::vector<Command>& commands) {
    for (const Block& block : blocks_) reportOpen(block, "");
    if (!blocks_.empty()) commands.resize(std::min(commands.size(), blocks_.front().index));
    blocks_.clear();
}

}  // namespace glibra::glib
