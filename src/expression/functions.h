#pragma once
// The functions of expressions: one row for each form of a function.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "expression/expression.h"

namespace glibra::expression {

enum class FunctionGroup { constructors, scalars, vectors, booleans, matrices, transforms, motion, data };

/// One form of a function. The prototype is written as in GLSL: "T mix(T a, T b, number t)", where
///
///   T     a number or a vector of 2 to 4 components        vec   a vector of 2 to 4 components
///   B     a bool or a vector of 2 to 4 of them             bvec  a vector of 2 to 4 bools
///   mat   a matrix of 2 to 4 columns and rows
///
/// In the group `data` an argument `texture`, `buffer` or `object` is a name (measures.h).
///
/// stand for the same number of components everywhere in the prototype.
struct FunctionRow {
    FunctionGroup group;
    std::string_view prototype;
    std::string_view summary;  ///< empty: that of the row before
    /// Null: a constructor, which takes any components, or a function of the group `data`.
    Apply apply;
    /// The time is appended to the arguments.
    bool readsTime = false;
    /// The arguments may be infinite or not a number.
    bool takesAll = false;

    [[nodiscard]] std::string_view name() const;
};

/// All rows; the forms of one function follow each other.
std::span<const FunctionRow> functionTable();

/// "Scalars and vectors".
std::string_view title(FunctionGroup group);

/// The rows of a name; empty if there is no such function.
std::span<const FunctionRow> functionsNamed(std::string_view name);

/// The call of a form with these arguments: its result and the instruction; nothing if the form does not take
/// them.
struct Call {
    Type result;
    Instruction instruction;
};
std::optional<Call> callOf(const FunctionRow& row, std::span<const Type> arguments);

/// The number of parameters of a form.
std::size_t parameterCount(const FunctionRow& row);

}  // namespace glibra::expression
