#pragma once
// Expressions as code, and their values.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "expression/known_names.h"
#include "expression/problem.h"
#include "expression/type.h"

namespace glibra::expression {

// Expressions of scenes: text becomes checked code, and code becomes a value (language, 1.8).
//
//     const auto angle = parse("2 * sin(.35 * time)", place, names);
//     if (!angle) report(angle.problem.message);
//     else if (const auto value = angle->evaluate(values)) rotate(value->number());
//
// Syntax and names are those of GLSL; every number is a double. Types are checked when the text is read. An
// evaluation throws nothing, allocates nothing unless it fails, and ends: there are no loops.

struct Code;

/// What the place where an expression stands accepts.
struct Wanted {
    std::span<const Type> types = {};  ///< empty: every number, boolean, vector and matrix
    /// The words that may be the value, as in `(inside ? front : back)`, if Type::word() is among the types.
    /// A name that the scene declares hides a word. A choice whose words are among these may be the value,
    /// too.
    std::span<const std::string_view> words = {};
};

struct Limits {
    std::size_t bytes = 16U << 10U;  ///< of the text
    std::size_t depth = 200;         ///< of nested parentheses, subscripts, signs and conditions
    std::size_t steps = 16U << 10U;  ///< of the code, each of them done at most once
    std::size_t bodies = 1U << 20U;  ///< bytes of all bodies of functions that are called
};

/// One name that an expression uses.
struct Use {
    std::string path;  ///< "light.shadow"
    Symbol symbol;
};

/// A checked expression: a value that is cheap to copy.
class Expression {
  public:
    [[nodiscard]] Type type() const;
    [[nodiscard]] const std::string& text() const;
    [[nodiscard]] const Place& origin() const;

    /// What the value can change with. An expression that depends on nothing has one value.
    [[nodiscard]] Depends depends() const;
    /// The names whose values are read, each once, in the order of the text. Branches that are never taken
    /// because their condition is constant do not count.
    [[nodiscard]] std::span<const Use> uses() const;
    /// The value, if no name is read and there is one.
    [[nodiscard]] std::optional<Value> constant() const;

    /// Computes the value. Problems are expr-E06 and expr-E07.
    [[nodiscard]] Checked<Value> evaluate(const Values& values) const;

    /// Equal text, read with the same meaning of its names. The place does not count.
    friend bool operator==(const Expression& a, const Expression& b);

  private:
    friend Checked<Expression> parse(std::string_view text, const Place& origin, const Names& names,
                                     const Wanted& wanted, const Limits& limits);
    explicit Expression(std::shared_ptr<const Code> code) : code_(std::move(code)) {}
    std::shared_ptr<const Code> code_;
};

/// Reads an expression, with or without parentheses around it. `origin` is the place of the first byte of the
/// text, which may have several lines, joined by backslashes. Problems are expr-E01 to expr-E05, expr-E08
/// and expr-E09; the first one is returned. The body of a function of the scene becomes part of the code
/// wherever it is called, so a call costs no more than the body written in its place. A problem of a body
/// stands at the call in the text, and its message names the place in the body.
Checked<Expression> parse(std::string_view text, const Place& origin, const Names& names,
                          const Wanted& wanted = {}, const Limits& limits = {});

/// The problem that the body of a function has with arguments of every type; nothing if some types suit it.
std::optional<Problem> problemOf(const Function& function, const Names& names);

// Compiled expressions: instructions for a stack of doubles. Types are known when the code is made, so no
// value has a type at run time. Jumps only go forward.

struct Instruction;

/// Replaces the arguments at `stack` (the first argument first, matrices by columns) by the result. Returns
/// null, or why there is no result. A result that is not finite is found by the caller.
using Apply = const char* (*)(double* stack, const Instruction& instruction);

enum class Op : std::uint8_t {
    push,    ///< n constants from `target` on
    load,    ///< the value of symbol `target`
    loadAt,  ///< replaces a subscript by that element of symbol `target`
    local,   ///< a parameter: n components that stand at place `target` of the stack
    leave,   ///< the end of a body: removes the `target` components below the n of the result
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

/// The body of a function that the code has taken in. Its bytes are counted on from `begin`, as if the bodies
/// followed the text.
struct CalledBody {
    std::uint32_t begin = 0;
    std::shared_ptr<const Function> function;
    Range call;  ///< of the text: the call that leads to it
};

struct Code {
    std::string text;
    Place origin;
    Type type;
    std::vector<Instruction> instructions;
    std::vector<Range> ranges;  ///< of the text or of a body, one for each instruction
    std::vector<CalledBody> bodies;
    std::vector<double> constants;
    std::vector<Use> uses;
    Depends depends = Depends::nothing;
};

/// Runs the instructions from `first` on and leaves the result at stack[0]. Returns nothing, or the problem.
/// `stack` has room for kMostDoubles. Without `values` nothing may be loaded.
std::optional<Problem> run(const Code& code, std::size_t first, const Values* values, double* stack);

/// A problem of this id in the text. In a body it stands at the call, and the place in the body ends the
/// message.
Problem problemAt(const Code& code, Range range, const char* id, std::string message);
/// The bytes of a range of the text or of a body in single quotes.
std::string quoted(const Code& code, Range range);

}  // namespace glibra::expression
