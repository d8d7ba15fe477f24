// Local variables that are read before they have a value. The check looks at the order of the text, so a
// value that only one branch assigns counts.

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "glsl/facts/facts.h"
#include "glsl/parse/types.h"
#include "glsl/parse/usage.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

/// Built-in functions that give values to their arguments.
constexpr std::array<std::string_view, 6> kWithOutputs{"modf",       "frexp",        "uaddCarry",
                                                       "usubBorrow", "umulExtended", "imulExtended"};

bool isCoreFunction(std::string_view word) {
    static const std::vector<std::string_view> kFunctions = coreFunctions();
    return std::find(kFunctions.begin(), kFunctions.end(), word) != kFunctions.end();
}

/// True if the word at `at` may be an argument through which a function returns a value.
bool mayBeOutput(const Unit& unit, std::uint32_t at) {
    const std::string_view next = unit.text(afterSuffixes(unit, at));
    if (next != ")" && next != ",") return false;
    int depth = 0;
    for (std::uint32_t i = at; i-- > 0;) {
        const std::string_view text = unit.text(i);
        if (text == ";" || text == "{" || text == "}") return false;
        if (text == ")" || text == "]") ++depth;
        if (text == "[" && depth-- == 0) return false;
        if (text != "(" || depth-- > 0) continue;
        if (i == 0 || unit.view[i - 1].kind != TokenKind::word) return false;
        const std::string_view function = unit.text(i - 1);
        if (isTypeWord(function) || isStatementWord(function)) return false;
        return std::find(kWithOutputs.begin(), kWithOutputs.end(), function) != kWithOutputs.end() ||
               !isCoreFunction(function) || unit.isDeclared(function);
    }
    return false;
}

/// True for `x += 1` and `++x`, which read what they change.
bool isChanged(const Unit& unit, std::uint32_t at) {
    const auto isStep = [](std::string_view text) { return text == "++" || text == "--"; };
    const std::string_view next = unit.text(afterSuffixes(unit, at));
    return isStep(next) || (isAssignment(next) && next != "=") || (at > 0 && isStep(unit.text(at - 1)));
}

}  // namespace

void reportUnassigned(const Unit& unit, Report& report) {
    std::unordered_map<std::uint32_t, const LocalVariable*> locals;
    for (const LocalVariable& each : unit.bodies.locals) locals.emplace(each.name, &each);
    std::unordered_map<std::string_view, bool> unassigned;
    for (std::uint32_t at = 0; at < unit.view.size(); ++at) {
        const WordRole role = unit.bodies.roles[at];
        if (role != WordRole::local && role != WordRole::localDeclaration) continue;
        const std::string_view name = unit.text(at);
        if (role == WordRole::localDeclaration) {
            const auto local = locals.find(at);
            const bool isPlain = local != locals.end() && !local->second->isParameter &&
                                 local->second->initializer.empty() && local->second->type.numeric();
            unassigned[name] = isPlain && unit.text(at + 1) != "[" && unit.text(at + 1) != "=";
            continue;
        }
        const auto known = unassigned.find(name);
        if (known == unassigned.end() || !known->second) continue;
        known->second = false;
        const bool isGiven = (isWrittenAt(unit, at) && !isChanged(unit, at)) || mayBeOutput(unit, at);
        const bool isLength = unit.text(at + 1) == "." && unit.text(at + 2) == "length";
        if (!isGiven && !isLength)
            report.report(
                "glsl-W28",
                "'" + std::string(name) + "' is read before it has a value; give it one where it is declared",
                unit.place(at));
    }
}

}  // namespace glibra::glsl
