// What the code of a stage does, decided by the words of its active tokens.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <unordered_set>

#include "glsl/facts/facts.h"
#include "glsl/parse/usage.h"
#include "glsl/read/words.h"
#include "glsl/types/builtins.h"

namespace glibra::glsl {
namespace {

using Words = std::unordered_set<std::string_view>;

Words wordsOf(const Unit& unit) {
    Words words;
    for (const ViewToken& each : unit.view)
        if (each.kind == TokenKind::word) words.insert(each.text);
    return words;
}

/// Calls of these leave values linear. ftransform() is a product with a matrix.
bool isLinearCall(std::string_view word) {
    static constexpr std::array<std::string_view, 10> kLinear = {
        "vec2", "vec3", "vec4", "mat2", "mat3", "mat4", "float", "normalize", "ftransform", "main"};
    return std::ranges::find(kLinear, word) != kLinear.end();
}

bool callsFunctions(const Unit& unit) {
    for (std::uint32_t at = 0; at + 1 < unit.view.size(); ++at) {
        const std::string_view word = unit.text(at);
        if (unit.view[at].kind == TokenKind::word && unit.text(at + 1) == "(" && !isLinearCall(word) &&
            !isStatementWord(word) && word != "layout")
            return true;
    }
    return !unit.mainEnd.empty();  // the translator's own statements, which may clamp colours
}

/// True if a small change of an input may become a large one, by a decision or a factor.
bool magnifiesOrDecides(const Unit& unit) {
    static constexpr std::array<std::string_view, 16> kWords = {
        "if", "switch", "while", "?", "<", ">", "<=", ">=", "==", "!=", "*", "/", "*=", "/=", "%", "discard"};
    return std::ranges::any_of(unit.view, [](const ViewToken& each) {
        return std::ranges::find(kWords, each.text) != kWords.end();
    });
}

/// True for a flat variable or block member. Redeclarations of built-in varyings count although the rules
/// remove them, because the built-in block takes their interpolation.
bool hasFlatVariable(const Unit& unit) {
    const auto isFlat = [](const Declaration& each) { return each.qualifiers.interpolation == "flat"; };
    const auto isFlatBlock = [&](const Declaration& each) {
        return each.kind == DeclarationKind::block &&
               (isFlat(each) || std::ranges::any_of(each.members, isFlat));
    };
    return std::ranges::any_of(unit.variables,
                               [](const Variable& each) { return each.interpolation == "flat"; }) ||
           std::ranges::any_of(unit.syntax.declarations, isFlatBlock);
}

bool hasCubeMap(const Unit& unit) {
    return std::ranges::any_of(unit.variables,
                               [](const Variable& each) { return each.type == "samplerCube"; });
}

}  // namespace

StageFacts factsOf(const Unit& unit) {
    const Words words = wordsOf(unit);
    StageFacts facts;
    facts.callsFunctions = callsFunctions(unit);
    facts.writesMemory = writesMemory(unit);
    facts.fetchesTexels = words.contains("texelFetch") || words.contains("texelFetchOffset");
    // What is written to a block can depend on the number of vertices.
    facts.showsPrimitives = hasFlatVariable(unit) || hasWritableStorage(unit) ||
                            words.contains("gl_PrimitiveID") || words.contains("gl_VertexID") ||
                            (words.contains("dFdx") && words.contains("cross"));
    // A highlight is a reflection too, but the light that it shows changes slowly.
    facts.magnifiesNormals = words.contains("refract") || (words.contains("reflect") && hasCubeMap(unit));
    facts.mayPaintEdges = unit.stage == Stage::fragment && (facts.callsFunctions || magnifiesOrDecides(unit));
    facts.mayWriteDepth = words.contains("gl_FragDepth");
    facts.mayLeaveFragments = words.contains("discard") || words.contains("gl_SampleMask") ||
                              words.contains("demote") || words.contains("terminateInvocation");
    return facts;
}

bool mayReadTangents(const ProgramUnits& program) {
    if (program.units.empty() || program.units.front().stage != Stage::vertex) return false;
    const Words words = wordsOf(program.units.front());
    const auto rows = builtinInputs();
    return std::ranges::any_of(rows, [&](const BuiltinInput& each) {
        return each.attribute == "tangent" && words.contains(each.name);
    });
}

// What the stages declare: uniforms, texture bindings, vertex inputs and the names of all interfaces.

namespace {

/// DeclaredUniform::arraySize.
int declaredElements(const Unit& unit, const Declaration& declaration, const Declarator& declarator) {
    if (declaration.type.dimensions.size() + declarator.dimensions.size() != 1) return 0;
    const auto& dimension =
        declarator.dimensions.empty() ? declaration.type.dimensions.front() : declarator.dimensions.front();
    long long elements = 0;
    if (!globalIntegerValue(unit, dimension, elements) || elements < 1) return 0;
    return static_cast<int>(std::min(elements, 1LL << 20));
}

void variableFacts(const Unit& unit, const Variable& variable, TranslatedProgram& result) {
    if (variable.removed || variable.storage == Storage::none || variable.storage == Storage::constant)
        return;
    const Declaration& declaration = unit.syntax.declarations[variable.declaration];
    const Place place = unit.place(variable.nameToken);
    result.interfaceNames[variable.name].push_back(place);
    if (variable.storage == Storage::input && unit.stage == Stage::vertex)
        result.vertexInputs.emplace(variable.name, place);
    if (variable.storage != Storage::uniform) return;
    const bool initialised =
        !declaration.declarators[variable.declarator].initializer.empty() && !variable.dropInitializer;
    DeclaredUniform& uniform =
        result.uniforms.emplace(variable.name, DeclaredUniform{place, initialised}).first->second;
    uniform.hasInitializer = uniform.hasInitializer || initialised;
    uniform.arraySize = std::max(
        uniform.arraySize, declaredElements(unit, declaration, declaration.declarators[variable.declarator]));
    const LayoutItem* binding =
        isOpaqueTypeWord(variable.type) ? declaration.qualifiers.item("binding") : nullptr;
    long long textureUnit = 0;
    if (binding && integerValue(unit, binding->value, textureUnit) && textureUnit >= 0 && textureUnit < 1024)
        result.textureBindings[variable.name] = static_cast<int>(textureUnit);
}

void blockFacts(const Unit& unit, const Declaration& block, TranslatedProgram& result) {
    const std::string name(unit.text(block.name));
    result.interfaceNames[name].push_back(unit.place(block.name));
    if (block.qualifiers.storage != Storage::uniform) return;
    for (const Declaration& member : block.members)
        for (const Declarator& each : member.declarators) {
            const DeclaredUniform uniform{unit.place(each.name), false};
            const std::string own(unit.text(each.name));
            result.uniforms.emplace(own, uniform);
            result.uniforms.emplace(fmt::format("{}.{}", name, own), uniform);
        }
}

}  // namespace

void collectDeclarations(ProgramUnits& program) {
    for (const Unit& unit : program.units) {
        for (const Variable& each : unit.variables) variableFacts(unit, each, *program.result);
        for (const Declaration& each : unit.syntax.declarations)
            if (each.kind == DeclarationKind::block) blockFacts(unit, each, *program.result);
    }
}

// Finds out whether a fragment stage always writes 1 for alpha. Blending then gives its colour unchanged.

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
