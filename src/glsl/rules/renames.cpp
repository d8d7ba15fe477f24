// Writes the renamed words of a stage into its edits.

#include "glsl/rules/rules.h"

namespace glibra::glsl {

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
        if (token.text.starts_with("GL_") && !token.directive) {
            // It is no macro of this version, but it may be one of the target.
            const auto& [name, spelling] =
                *unit.renames.emplace(token.text, "glibra_" + std::string(token.text)).first;
            unit.edits.replace(i, spelling);
            continue;
        }
        const auto found = unit.renames.find(token.text);
        if (found == unit.renames.end() || unit.keptSpelling.contains(i)) continue;
        if (walk.text(walk.previous(i)) == ".") continue;
        unit.edits.replace(i, found->second);
    }
}

}  // namespace glibra::glsl
