// Storage qualifiers of older versions, and names that have become keywords or functions (language, 7.4).

#include <algorithm>
#include <array>

#include "glsl/read/words.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

bool isVertexCount(const std::string& size) {
    return size == "gl_VerticesIn" || size.empty();
}

/// The storage of a `varying` in a stage that has both inputs and outputs.
Storage storageOfVarying(Stage stage, const Variable& variable) {
    if (stage == Stage::vertex) return Storage::output;
    // `varying out` of a fragment stage is one of its outputs (EXT_gpu_shader4, 4.3.6).
    if (stage == Stage::fragment)
        return variable.storage == Storage::output ? Storage::output : Storage::input;
    if (variable.storage == Storage::input || variable.storage == Storage::output) return variable.storage;
    const std::vector<std::string> sizes = variable.sizes();
    return !sizes.empty() && isVertexCount(sizes.front()) ? Storage::input : Storage::output;
}

void modernize(Unit& unit, Variable& variable) {
    const Qualifiers& q = unit.syntax.declarations[variable.declaration].qualifiers;
    if (q.attributeWord && unit.stage == Stage::vertex) {
        variable.storage = Storage::input;
        variable.changed = true;
    }
    if (q.varyingWord) {
        variable.storage = storageOfVarying(unit.stage, variable);
        variable.changed = true;
    }
    // An input is invariant if the output of the earlier stage is. 4.50 accepts the word only for outputs.
    if (variable.invariant && variable.storage == Storage::input) {
        variable.invariant = false;
        variable.changed = true;
    }
    if (unit.stage != Stage::geometry || variable.storage != Storage::input) return;
    for (std::vector<std::string>* sizes : {&variable.nameSizes, &variable.typeSizes}) {
        if (sizes->empty() || sizes->front() != "gl_VerticesIn") continue;
        sizes->front().clear();
        (sizes == &variable.nameSizes ? variable.sizesChanged : variable.changed) = true;
    }
}

/// Removes `invariant vColor;` for inputs, where it no longer has a meaning.
void dropInvariantInputs(Unit& unit) {
    for (const Declaration& each : unit.syntax.declarations) {
        if (each.kind != DeclarationKind::requalify || unit.stage != Stage::fragment) continue;
        const bool inputs = std::ranges::all_of(each.declarators, [&](const Declarator& name) {
            const Variable* variable = unit.variable(unit.text(name.name));
            return variable && variable->storage == Storage::input;
        });
        if (inputs) unit.remove(each.tokens);
    }
}

constexpr std::array<std::string_view, 14> kEmitted = {
    "texture",       "textureProj",       "textureLod",       "textureProjLod",       "textureGrad",
    "textureOffset", "textureProjOffset", "textureLodOffset", "textureProjLodOffset", "textureGradOffset",
    "texelFetch",    "texelFetchOffset",  "textureSize",      "textureProjGrad"};

/// The view index of the word's declaration in this unit, or kNone.
std::uint32_t declarationOf(const Unit& unit, std::string_view word, bool members) {
    if (const auto found = unit.declared.find(word); found != unit.declared.end()) return found->second;
    const Bodies& bodies = unit.bodies;
    if (const auto found = bodies.localNames.find(word); found != bodies.localNames.end())
        return found->second;
    if (!members) return kNone;
    const auto found = bodies.memberNames.find(word);
    return found == bodies.memberNames.end() ? kNone : found->second;
}

bool isTaken(const Unit& unit, std::string_view word) {
    return isFreeWord(word, unit.dialect) && !unit.macros.contains(word);
}

std::set<std::string> takenWords(const Unit& unit) {
    std::set<std::string> words;
    const auto collect = [&](const auto& names) {
        for (const auto& [word, at] : names)
            if (isTaken(unit, word)) words.insert(word);
    };
    collect(unit.declared);
    collect(unit.bodies.localNames);
    collect(unit.bodies.memberNames);
    return words;
}

/// Keeps the calls of the function `texture` when a variable of that name is renamed.
void keepCalls(Unit& unit, std::string_view word, std::uint32_t declaration) {
    if (unit.text(declaration + 1) == "(") return;
    for (std::uint32_t i = 0; i < unit.view.size(); ++i)
        if (unit.text(i) == word && unit.text(i + 1) == "(") unit.keptSpelling.insert(unit.view[i].raw);
}

}  // namespace

void modernizeQualifiers(ProgramUnits& program) {
    for (Unit& unit : program.units) {
        for (Variable& variable : unit.variables) modernize(unit, variable);
        dropInvariantInputs(unit);
        // The remaining old words are in macros, whose bodies are translated like ordinary text.
        unit.wordRenames.try_emplace("attribute", "in");
        unit.wordRenames.try_emplace("varying", unit.stage == Stage::fragment ? "in" : "out");
    }
}

void makePositionsInvariant(ProgramUnits& program) {
    Unit* const vertex = program.find(Stage::vertex);
    if (vertex == nullptr || program.result->knownPlacement() == Placement::unknown) return;
    const bool isDeclared = std::ranges::any_of(vertex->syntax.declarations, [&](const Declaration& each) {
        if (each.kind == DeclarationKind::block) return vertex->text(each.name) == "gl_PerVertex";
        return std::ranges::any_of(each.declarators, [&](const Declarator& name) {
            return vertex->text(name.name) == "gl_Position";
        });
    });
    if (!isDeclared) vertex->declare("invariant gl_Position;");
}

void renameTakenWords(ProgramUnits& program) {
    std::set<std::string> words;
    for (const Unit& unit : program.units) words.merge(takenWords(unit));
    for (Unit& unit : program.units) {
        for (const std::string& word : words) {
            const std::uint32_t at = declarationOf(unit, word, true);
            if (at == kNone) continue;
            unit.wordRenames[word] = "glibra_" + word;
            program.result->userNames["glibra_" + word] = word;
            program.report.report("glsl-W05", "'" + word + "' is a reserved word, renamed", unit.place(at));
        }
        for (const std::string_view word : kEmitted) {
            // A macro of that name would replace the calls that the translation emits.
            if (unit.macros.contains(word))
                unit.wordRenames.try_emplace(std::string(word), "glibra_" + std::string(word));
            const std::uint32_t at = declarationOf(unit, word, false);
            if (at == kNone || unit.macros.contains(word)) continue;
            const std::string name(word);
            unit.renames[name] = "glibra_" + name;
            keepCalls(unit, word, at);
            program.result->userNames["glibra_" + name] = name;
            program.report.report("glsl-W05", "'" + name + "' is the name of a function, renamed",
                                  unit.place(at));
        }
    }
}

// Writes the renamed words of a stage into its edits.

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
