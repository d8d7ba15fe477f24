#pragma once
// The operators of expressions, with GLSL's precedence and types.

#include <optional>
#include <string_view>

#include "expression/functions.h"

namespace glibra::expression {

/// Precedence of an operator between two values: 1 for || up to 11 for * / %; 0 for other signs. Operators of
/// equal precedence are evaluated from left to right.
int precedenceOf(std::string_view sign);

/// The instruction for two values; nothing if the operator does not take their types. Not for && and ||.
std::optional<Call> operationOf(std::string_view sign, const Type& left, const Type& right);
/// The instruction for - ! ~ before a value.
std::optional<Call> operationOf(std::string_view sign, const Type& operand);

}  // namespace glibra::expression
