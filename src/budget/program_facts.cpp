#include "budget/program_facts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "geometry/mesh.h"
#include "glsl/rules/builtins.h"

namespace glibra::budget {
namespace {

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool showsPrimitives(std::string_view source) {
    constexpr std::array kWords{"flat", "gl_PrimitiveID", "gl_VertexID"};
    return std::any_of(kWords.begin(), kWords.end(),
                       [&](const char* each) { return hasWord(source, each); }) ||
           (hasWord(source, "dFdx") && hasWord(source, "cross"));
}

/// A highlight reflects too, but what is seen in it is light that changes slowly.
bool magnifies(std::string_view source) {
    return hasWord(source, "refract") || (hasWord(source, "reflect") && hasWord(source, "samplerCube"));
}

/// Words before a parenthesis, but those that leave a value linear.
bool callsFunctions(std::string_view source) {
    constexpr std::array kHarmless{"main", "vec2",   "vec3", "vec4",      "mat2",  "mat3", "mat4",
                                   "if",   "layout", "for",  "normalize", "float", "while"};
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= source.size(); ++i) {
        if (i < source.size() && isWordCharacter(source[i])) continue;
        const std::string_view word = source.substr(begin, i - begin);
        begin = i + 1;
        if (word.empty()) continue;
        const std::size_t next = source.find_first_not_of(" \t", i);
        if (next != std::string_view::npos && source[next] == '(' &&
            std::find(kHarmless.begin(), kHarmless.end(), word) == kHarmless.end())
            return true;
    }
    return false;
}

}  // namespace

bool hasWord(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !isWordCharacter(text[at - 1])) &&
            (end == text.size() || !isWordCharacter(text[end])))
            return true;
    }
    return false;
}

ProgramFacts programFacts(const plan::ProgramInterface& program) {
    ProgramFacts facts;
    facts.isBuiltin = program.isBuiltin;
    facts.placesByMatrix = program.isBuiltin || program.facts.placement != glsl::Placement::unknown;
    bool readsNormals = false;
    for (const plan::ActiveInput& each : program.inputs)
        if (const glsl::BuiltinInput* row = glsl::findBuiltinInput(each.name); row != nullptr) {
            facts.readsTexCoord = facts.readsTexCoord || row->attribute == geometry::kTexCoord;
            readsNormals =
                readsNormals || row->attribute == geometry::kNormal || row->attribute == geometry::kTangent;
        }
    for (const glsl::TranslatedStage& each : program.facts.stages) {
        facts.worksOnPrimitives = facts.worksOnPrimitives ||
                                  (each.stage != glsl::Stage::vertex && each.stage != glsl::Stage::fragment);
        facts.hasTessellation = facts.hasTessellation || each.stage == glsl::Stage::tessEvaluation;
        facts.computesAtVertices =
            facts.computesAtVertices || (each.stage == glsl::Stage::vertex && callsFunctions(each.source));
        if (each.stage == glsl::Stage::fragment)
            facts.magnifiesNormals = readsNormals && magnifies(each.source);
        facts.showsPrimitives = facts.showsPrimitives || showsPrimitives(each.source);
    }
    return facts;
}

}  // namespace glibra::budget
