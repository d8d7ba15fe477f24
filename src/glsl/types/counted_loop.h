#pragma once
// How many rounds the loops of a stage run, as far as its text shows. The number depends on values of
// uniforms. Some drivers end a loop after a number of rounds without reporting it.

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

/// Gives the value of a scalar uniform; nothing if it is not known.
using UniformValue = std::function<std::optional<double>(std::string_view name)>;

/// The value of a formula; nothing if one of its uniforms is unknown. Integers are divided like other
/// numbers.
std::optional<double> valueOf(const Formula& formula, const UniformValue& uniform);

/// for (i = first; i < bound; i += step) in any spelling, or a `while (i < bound)` with the initialisation
/// before it and the step in its body. A break, a return or another condition may end the loop earlier.
struct CountedLoop {
    Place place;  ///< the place of its `for` or `while`
    Formula first, bound, step;
    bool falling = false;    ///< the loop runs while i is greater than the bound
    bool including = false;  ///< the loop also runs while i is equal to the bound
    std::vector<CountedLoop> inside;
};

/// The greatest number of rounds of this loop alone; 0 if it is not known.
double roundsOf(const CountedLoop& loop, const UniformValue& uniform);

/// The number of rounds of the loop and of all loops in it together. An innermost loop that compilers unroll,
/// because its rounds are few and constant, counts 0.
double totalRounds(const CountedLoop& loop, const UniformValue& uniform);

}  // namespace glibra::glsl
