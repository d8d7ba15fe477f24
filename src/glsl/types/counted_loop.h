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

/// A scalar made of constants and of names, in reverse Polish order. A name is a scalar uniform (by the
/// user's name), a member of a block ("count", "info.count"), or a size: "imageSize(uMap).x",
/// "textureSize(uMap, 2).y", "particles.length()".
struct Formula {
    std::vector<std::variant<double, std::string, Operation>> steps;
};

/// Gives the value of a name of a formula; nothing if it is not known.
using UniformValue = std::function<std::optional<double>(std::string_view name)>;

/// The value of a formula; nothing if one of its uniforms is unknown. Integers are divided like other
/// numbers.
std::optional<double> valueOf(const Formula& formula, const UniformValue& uniform);

/// for (i = first; i < bound; i += step) in any spelling, or a `while (i < bound)` or `do ... while` with the
/// initialisation before it and the step in its body. A loop without a condition counts by its
/// `if (i >= bound) break;`. A break, a return or another condition may end the loop earlier.
struct CountedLoop {
    Place place;  ///< the place of its `for` or `while`
    Formula first, bound, step;
    bool falling = false;     ///< the loop runs while i is greater than the bound
    bool including = false;   ///< the loop also runs while i is equal to the bound
    bool untilEqual = false;  ///< the loop ends when i is equal to the bound, from either side
    double emits = 0;         ///< EmitVertex() calls of each round, outside of conditions and inner loops
    bool isSure = true;       ///< the loop stands outside of conditions, and nothing ends it earlier
    std::vector<CountedLoop> inside;
};

/// The greatest number of rounds of this loop alone; 0 if it is not known.
double roundsOf(const CountedLoop& loop, const UniformValue& uniform);

/// True if the number of rounds of the loop, or of one in it, is not known.
bool isOpen(const CountedLoop& loop, const UniformValue& uniform);

/// True if compilers unroll the loop, because its rounds are few and constant, and no other loop is in it.
bool isUnrolled(const CountedLoop& loop);

/// The number of rounds of the loop and of all loops in it together. A loop that isUnrolled() counts 0.
double totalRounds(const CountedLoop& loop, const UniformValue& uniform);

/// The number of vertices that the loop emits as far as that is sure; a lower bound.
double emittedBy(const CountedLoop& loop, const UniformValue& uniform);

}  // namespace glibra::glsl
