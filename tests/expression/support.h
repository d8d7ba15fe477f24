#pragma once
// Names and values that the tests of expressions use.

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "expression/expression.h"
#include "table_of_names.h"

namespace glibra::expression::test {

/// a = 2, b = 3, c = 5, x = -.5, yes, no, u = (1, 2), v = (1, 2, 3), w = (1, 2, 3, 4), m3 and m4 of small
/// numbers, the scene's names (time 2.5), pose[6] of numbers 10 to 15, color (red, green or blue; green),
/// camera `light`, cameras slice[3], texture `brick`.
NameTable sceneTable();

/// The expression; a failure if there is none.
Expression parsed(std::string_view text, const Wanted& wanted = {});
/// Its value with the names above; a failure if there is none.
Value valueOf(std::string_view text);
double numberOf(std::string_view text);

/// The problem of parsing, or else of evaluating; a failure if there is none.
Problem problemOf(std::string_view text, const Wanted& wanted = {});
/// "expr-E01 'text of the range': message".
std::string problemText(std::string_view text, const Wanted& wanted = {});

}  // namespace glibra::expression::test
