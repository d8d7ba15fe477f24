#pragma once
// Calls that read what a texture or buffer holds, in the text of an expression:
// `mean(glow.level(1), 0, 0, 8, 8) at 2`. Whoever answers the expression knows the value of each call, and
// gives it to the parser as the value of a name.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "expression/problem.h"

namespace glibra::expression {

/// The ranges are those of the whole text. Those of arguments begin after the parenthesis, the comma or the
/// `at` before them, and may have blanks at both ends.
struct MeasureCall {
    std::string_view function;
    Range range;                     ///< from the function's name to its closing parenthesis
    Range object;                    ///< the name of the texture or buffer, with its parts
    std::vector<Range> numbers;      ///< the other arguments
    std::optional<Range> seconds{};  ///< after `at`, which may stand after components: `sum(a).x at 2`
    std::string path;                ///< by which Names knows the call: the same for equal calls
    std::string why{};               ///< it is wrong: "sum needs ..."
};

/// True for the functions of FunctionGroup::data.
bool isMeasure(std::string_view function);

/// The call that begins at that byte; nothing if there is no call of such a function.
std::optional<MeasureCall> measureAt(std::string_view text, std::uint32_t begin);

/// All such calls of an expression, in the order of the text, without those in arguments of others.
std::vector<MeasureCall> measuresIn(std::string_view text);

/// What may be names of an expression outside of such calls: `a.b.c` gives `a`, `a.b` and `a.b.c`. Each once.
std::vector<std::string> pathsIn(std::string_view text);

}  // namespace glibra::expression
