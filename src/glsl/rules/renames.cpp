// Writes the renamed words of a stage into its edits.

#include "glsl/read/extensions.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

/// Macro names that drivers reserve get another spelling and a definition.
bool renameDriverMacro(Unit& unit, std::uint32_t at, std::string_view text) {
    if (!text.starts_with("GL_")) return false;
    const bool compatibility = text == "GL_compatibility_profile";
    if (!compatibility && !isInCore(text, unit.request->target.version)) return false;
    const std::string name = "glibra_" + std::string(text.substr(3));
    unit.edits.replace(at, name);
    if (!compatibility || !unit.dialect.core) unit.declare("#define " + name + " 1");
    return true;
}

}  // namespace

void applyRenames(Unit& unit, const TokenWalk& walk) {
    if (!unit.mainEnd.empty() && unit.isDeclared("main")) unit.renames["main"] = "glibra_main";
    for (const std::uint32_t each : unit.bodies.memberDeclarations)
        unit.keptSpelling.insert(unit.view[each].raw);
    for (std::uint32_t i = 0; i < unit.tokens.size(); ++i) {
        const Token& token = unit.tokens[i];
        if (token.kind != TokenKind::word || token.synthetic) continue;
        if (const Edit* edit = unit.edits.find(i); edit && edit->replaced) continue;
        if (unit.layoutWords.contains(i)) continue;
        if (const auto found = unit.wordRenames.find(token.text); found != unit.wordRenames.end()) {
            unit.edits.replace(i, found->second);
            continue;
        }
        if (token.text == "__VERSION__") {
            unit.edits.replace(i, std::to_string(unit.dialect.written));
            continue;
        }
        if (renameDriverMacro(unit, i, token.text)) continue;
        const auto found = unit.renames.find(token.text);
        if (found == unit.renames.end() || unit.keptSpelling.contains(i) || unit.macros.contains(token.text))
            continue;
        if (walk.text(walk.previous(i)) == ".") continue;
        unit.edits.replace(i, found->second);
    }
}

}  // namespace glibra::glsl
