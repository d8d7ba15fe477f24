// Finds out whether a fragment stage always writes 1 for alpha. Blending then gives its colour unchanged.

#include <algorithm>
#include <optional>
#include <string>

#include "glsl/facts/facts.h"
#include "glsl/parse/usage.h"

namespace glibra::glsl {
namespace {

/// The only colour that the stage writes, if it is a vec4.
std::optional<std::string> colorName(const Unit& unit) {
    if (unit.isWritten("gl_FragColor")) return "gl_FragColor";
    if (unit.isUsed("gl_FragData")) return std::nullopt;
    const Variable* color = nullptr;
    for (const Variable& each : unit.variables) {
        if (each.storage != Storage::output || each.removed || each.name.starts_with("gl_")) continue;
        if (color != nullptr) return std::nullopt;
        color = &each;
    }
    if (color == nullptr || color->isArray() || color->type != "vec4") return std::nullopt;
    return color->name;
}

/// True for the assignment `name = vec4(..., 1.);`
bool isOpaqueAssignment(const Unit& unit, std::uint32_t at) {
    if (unit.text(at + 1) != "=" || unit.text(at + 2) != "vec4" || unit.text(at + 3) != "(") return false;
    const std::uint32_t close = unit.bodies.matches[at + 3];
    if (close >= unit.view.size() || unit.text(close + 1) != ";") return false;
    const std::string_view before = unit.text(close - 2);
    return isLiteralOne(unit.text(close - 1)) && (before == "," || before == "(");
}

/// True for changes like `name.rgb = ...` and `name.xy *= ...`
bool leavesAlphaAlone(const Unit& unit, std::uint32_t at) {
    return unit.text(at + 1) == "." && unit.text(at + 2).find_first_of("awq") == std::string_view::npos &&
           afterSuffixes(unit, at) == at + 3;
}

}  // namespace

bool findOpacity(const ProgramUnits& program) {
    if (program.units.empty() || program.units.back().stage != Stage::fragment) return false;
    const Unit& unit = program.units.back();
    if (program.result->fragmentOutputs != 1 || unit.isUserName("vec4")) return false;
    const std::optional<std::string> name = colorName(unit);
    const std::optional<Range> main = bodyOfMain(unit);
    if (!name || !main) return false;
    const auto writes = unit.writes.find(*name);
    if (writes == unit.writes.end()) return false;
    const bool areOpaque = std::ranges::all_of(writes->second, [&](std::uint32_t at) {
        return isOpaqueAssignment(unit, at) || leavesAlphaAlone(unit, at);
    });
    return areOpaque && std::ranges::any_of(writes->second, [&](std::uint32_t at) {
               return isOpaqueAssignment(unit, at) && isAlwaysExecuted(unit, *main, at);
           });
}

}  // namespace glibra::glsl
