// What the code of a stage does, decided by the words of its active tokens.

#include <algorithm>
#include <array>
#include <string_view>
#include <unordered_set>

#include "glsl/facts/facts.h"
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

}  // namespace glibra::glsl
