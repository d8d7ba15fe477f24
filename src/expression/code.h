#pragma once
// Compiled expressions: instructions for a stack of doubles. Types are known when the code is made, so no
// value has a type at run time. Jumps only go forward.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "expression/expression.h"

namespace glibra::expression {

struct Instruction;

/// Replaces the arguments at `stack` (the first argument first, matrices by columns) by the result. Returns
/// null, or why there is no result. A result that is not finite is found by the caller.
using Apply = const char* (*)(double* stack, const Instruction& instruction);

enum class Op : std::uint8_t {
    push,    ///< n constants from `target` on
    load,    ///< the value of symbol `target`
    loadAt,  ///< replaces a subscript by that element of symbol `target`
    negate,  ///< n components
    add,     ///< a components and b components give n; 1 component is used for all
    subtract,
    multiply,
    divide,
    less,  ///< two numbers give a boolean
    lessEqual,
    greater,
    greaterEqual,
    equal,  ///< a components each give a boolean
    notEqual,
    logicalNot,
    logicalXor,
    swizzle,        ///< n components of a; 2 bits of `target` each say which
    element,        ///< a value with b elements of n components and a subscript give the element
    word,           ///< replaces a choice by word number constants[target + choice]
    call,           ///< apply(); arguments have a + b + c + d components, the result n
    jump,           ///< by `target` instructions
    jumpIfFalse,    ///< removes a boolean; jumps by `target` if it is false
    jumpKeepFalse,  ///< jumps by `target` if the boolean is false; otherwise removes it
    jumpKeepTrue,
};

struct Instruction {
    Apply apply = nullptr;
    std::uint32_t target = 0;
    Op op = Op::push;
    bool isChecked = true;  ///< false inside isnan() and isinf(): the result need not be finite
    std::uint8_t n = 1;
    std::uint8_t a = 0, b = 0, c = 0, d = 0;

    friend bool operator==(const Instruction&, const Instruction&) = default;
};

inline constexpr std::size_t kMostDoubles = 512;  ///< on the stack

struct Code {
    std::string text;
    Place origin;
    Type type;
    std::vector<Instruction> instructions;
    std::vector<Range> ranges;  ///< of the text, one for each instruction
    std::vector<double> constants;
    std::vector<Use> uses;
    Depends depends = Depends::nothing;
};

/// Runs the instructions from `first` on and leaves the result at stack[0]. Returns nothing, or the problem.
/// `stack` has room for kMostDoubles. Without `values` nothing may be loaded.
std::optional<Problem> run(const Code& code, std::size_t first, const Values* values, double* stack);

/// A problem of this id in a text that begins at `origin`.
Problem problemAt(const Code& code, Range range, const char* id, std::string message);

}  // namespace glibra::expression
