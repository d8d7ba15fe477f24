#pragma once
// The expressions of #if and #elif (GLSL 4.60, 3.3).

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "glsl/read/macros.h"

namespace glibra::glsl {

struct Condition {
    long long value = 0;
    std::string error;          ///< what is wrong with the expression; empty if nothing is
    const Piece* at = nullptr;  ///< where that is; null: at its end
    /// The first name that is no macro and that the value depends on: it counts as 0.
    const Piece* unknown = nullptr;
};

/// The value of an expression in which macros and `defined` are already replaced. Operands that && or || do
/// not need are not evaluated.
Condition evaluateCondition(std::span<const Piece> pieces);

/// Gives `value` the value of an integer expression of the text, in which words count as 0. False if the
/// tokens are none.
bool evaluateCondition(std::span<const ViewToken> tokens, long long& value);

/// How strongly an operator of GLSL binds its two operands; 0 for all else.
int levelOf(std::string_view op);

/// Gives `value` the value of a decimal, octal or hexadecimal number; false for other text.
bool readInteger(std::string_view text, long long& value);

/// The value of a literal: "12u", "0x1F", "1.5e3", "2.lf"; nothing for other text.
std::optional<double> numberValue(std::string_view text);

}  // namespace glibra::glsl
