#pragma once
// How often the loops of a stage run, as far as its text tells: a number when the values of the uniforms are
// known. Some drivers end loops after so many rounds without a word.

#include <glibra/diagnostic.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace glibra::glsl {

enum class Operation { add, subtract, multiply, divide, negate, truncate, least, greatest };

/// A scalar made of constants and scalar uniforms (by the user's names), in reverse Polish order.
struct Formula {
    std::vector<std::variant<double, std::string, Operation>> steps;
};

/// The value of a scalar uniform; nothing if it is not known.
using UniformValue = std::function<std::optional<double>(std::string_view name)>;

/// Nothing if a uniform in it is unknown. Integers are divided like other numbers.
std::optional<double> valueOf(const Formula& formula, const UniformValue& uniform);

/// for (i = first; i < bound; i += step), or while (i < bound) with these before and in it, in any spelling.
/// It may end earlier by break, return or another condition.
struct CountedLoop {
    Place place;  ///< of its `for` or `while`
    Formula first, bound, step;
    bool falling = false;    ///< goes on while i is greater than the bound
    bool including = false;  ///< also while it is equal
    std::vector<CountedLoop> inside;
};

/// Rounds of this loop alone, at most; 0 if that is not known.
double roundsOf(const CountedLoop& loop, const UniformValue& uniform);

/// Rounds of the loop and of all loops in it, together. Innermost loops of so few rounds, all constants, that
/// compilers write them out count 0.
double totalRounds(const CountedLoop& loop, const UniformValue& uniform);

}  // namespace glibra::glsl
