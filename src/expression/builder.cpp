#include "expression/builder.h"

#include <algorithm>
#include <utility>

namespace glibra::expression {

void Builder::emit(Instruction instruction, Range range, std::size_t removed, std::size_t added) {
    instruction.isChecked = unchecked == 0;
    code_.instructions.push_back(instruction);
    code_.ranges.push_back(range);
    depth_ = depth_ - removed + added;
    highest_ = std::max(highest_, depth_);
    steps_ = std::max(steps_, code_.instructions.size());
}

Operand Builder::pushed(std::span<const double> values, Type type, Range range) {
    Instruction push;
    push.op = Op::push;
    push.target = static_cast<std::uint32_t>(code_.constants.size());
    push.n = static_cast<std::uint8_t>(values.size());
    code_.constants.insert(code_.constants.end(), values.begin(), values.end());
    Operand operand{.type = type, .range = range, .begin = end(), .isConstant = true};
    emit(push, range, 0, values.size());
    return operand;
}

Operand Builder::combined(std::span<const Operand> from, Instruction instruction, Type type, Range range) {
    Operand result{.type = type, .range = range, .begin = from.front().begin};
    std::size_t removed = 0;
    bool isConstant = true;
    for (const Operand& each : from) {
        removed += each.type.size();
        isConstant = isConstant && each.isConstant;
    }
    emit(instruction, range, removed, type.size());
    result.isConstant = isConstant && fold(result.begin);
    return result;
}

std::span<const double> Builder::valueOf(const Operand& operand) const {
    const Instruction& push = code_.instructions[operand.begin];
    return {code_.constants.data() + push.target, push.n};
}

void Builder::setValue(const Operand& operand, double value) {
    code_.constants[code_.instructions[operand.begin].target] = value;
}

/// Replaces the instructions from `first` on, which begin with a push, by a push of their result. False if
/// the result is a problem, which is then reported whenever the code is run.
bool Builder::fold(std::size_t first) {
    if (!isWithinLimits()) return false;
    double stack[kMostDoubles];
    if (run(code_, first, nullptr, stack)) return false;
    const std::size_t size = code_.instructions.back().n;
    const Range range = code_.ranges.back();
    Instruction push = code_.instructions[first];
    push.n = static_cast<std::uint8_t>(size);
    code_.constants.resize(push.target);
    code_.constants.insert(code_.constants.end(), stack, stack + size);
    code_.instructions.resize(first);
    code_.ranges.resize(first);
    code_.instructions.push_back(push);
    code_.ranges.push_back(range);
    return true;
}

std::size_t Builder::emitJump(Op op, Range range, std::size_t removed) {
    Instruction jump;
    jump.op = op;
    emit(jump, range, removed, 0);
    return end() - 1;
}

void Builder::jumpHere(std::size_t jump) {
    code_.instructions[jump].target = static_cast<std::uint32_t>(end() - jump - 1);
}

void Builder::erase(std::size_t first, std::size_t last, std::size_t numbers) {
    const auto from = static_cast<std::ptrdiff_t>(first);
    const auto to = static_cast<std::ptrdiff_t>(last);
    code_.instructions.erase(code_.instructions.begin() + from, code_.instructions.begin() + to);
    code_.ranges.erase(code_.ranges.begin() + from, code_.ranges.begin() + to);
    depth_ -= numbers;
}

std::size_t Builder::use(std::string_view path, Symbol symbol) {
    const auto found = std::ranges::find(code_.uses, path, &Use::path);
    if (found != code_.uses.end()) return static_cast<std::size_t>(found - code_.uses.begin());
    code_.uses.push_back({std::string(path), std::move(symbol)});
    return code_.uses.size() - 1;
}

void Builder::finishUses() {
    constexpr std::size_t kUnread = static_cast<std::size_t>(-1);
    std::vector<std::size_t> places(code_.uses.size(), kUnread);
    std::vector<Use> read;
    for (Instruction& each : code_.instructions) {
        if (each.op != Op::load && each.op != Op::loadAt) continue;
        std::size_t& place = places[each.target];
        if (place == kUnread) {
            place = read.size();
            read.push_back(std::move(code_.uses[each.target]));
            code_.depends = code_.depends | read.back().symbol.depends;
        }
        each.target = static_cast<std::uint32_t>(place);
    }
    code_.uses = std::move(read);
}

}  // namespace glibra::expression
