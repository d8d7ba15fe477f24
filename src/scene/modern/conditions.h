#pragma once
// The conditions of checks: Expect (condition) (language, 12.9).

#include <glibra/result.h>

#include <functional>
#include <string>
#include <vector>

namespace glibra::scene {

class Environment;
struct Check;

/// Whether a condition is true, and what it was found to be: "5 == 7" if it compares two values, otherwise
/// "true" or "false".
struct ConditionAnswer {
    bool holds = false;
    std::string found;
};

/// Evaluates the condition of a check with the values of `names`. `read` returns the numbers of a buffer.
/// Reports why the condition has no value.
Result<ConditionAnswer> answerCondition(
    const Check& check, Environment& names,
    const std::function<std::vector<double>(const std::string& buffer)>& read);

}  // namespace glibra::scene
