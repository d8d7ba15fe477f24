#pragma once
// Makes code while an expression is read: instructions are appended in the order of evaluation, and values
// that depend on nothing are computed at once.

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>

#include "expression/code.h"

namespace glibra::expression {

/// A value that the code leaves on the stack.
struct Operand {
    Type type;
    Range range;
    std::size_t begin = 0;    ///< its first instruction
    bool isConstant = false;  ///< its code is one push
    /// A word that no name hides: its index is pushed. Text of a word that is not among those wanted.
    std::string_view unknownWord = {};
    /// The symbol, if the value is one of a choice.
    std::optional<std::size_t> choice = {};
};

class Builder {
  public:
    Builder(Code& code, const Limits& limits) : code_(code), limits_(limits) {}

    /// While above 0, results need not be finite.
    int unchecked = 0;

    /// Appends an instruction that replaces `removed` numbers on the stack by `added`.
    void emit(Instruction instruction, Range range, std::size_t removed, std::size_t added);

    Operand pushed(std::span<const double> values, Type type, Range range);
    Operand pushed(double value, Type type, Range range) { return pushed({&value, 1}, type, range); }

    /// The operand that an instruction makes of operands that end the code. It is computed now if they are
    /// constant.
    Operand combined(std::initializer_list<Operand> from, Instruction instruction, Type type, Range range) {
        return combined(std::span<const Operand>(from.begin(), from.size()), instruction, type, range);
    }
    Operand combined(std::span<const Operand> from, Instruction instruction, Type type, Range range);

    /// The value of a constant operand.
    [[nodiscard]] std::span<const double> valueOf(const Operand& operand) const;
    void setValue(const Operand& operand, double value);

    /// The next instruction's index.
    [[nodiscard]] std::size_t end() const { return code_.instructions.size(); }
    /// Appends a jump; jumpHere() says where it goes. The stack changes as emit() says.
    std::size_t emitJump(Op op, Range range, std::size_t removed);
    void jumpHere(std::size_t jump);
    /// The stack is lower by that many numbers from here on: another branch begins.
    void forget(std::size_t numbers) { depth_ -= numbers; }
    /// Removes instructions [first, last), which leave `numbers` on the stack.
    void erase(std::size_t first, std::size_t last, std::size_t numbers);

    /// The index of a name among those of the code.
    std::size_t use(std::string_view path, Symbol symbol);
    /// Keeps only the names that are still read, and collects what they depend on.
    void finishUses();

    /// False after a limit was passed; the code must not be run.
    [[nodiscard]] bool isWithinLimits() const { return steps_ <= limits_.steps && highest_ <= kMostDoubles; }

  private:
    bool fold(std::size_t first);

    Code& code_;
    const Limits& limits_;
    std::size_t depth_ = 0;
    std::size_t highest_ = 0;
    std::size_t steps_ = 0;
};

}  // namespace glibra::expression
