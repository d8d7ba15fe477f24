#include "glsl/read/words.h"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>

namespace glibra::glsl {
namespace {

struct KeywordRow {
    int since;
    std::string_view words;
};

constexpr std::string_view kQualifiers =
    " attribute varying const uniform in out inout buffer shared centroid flat smooth noperspective "
    "invariant precise "
    "patch sample coherent volatile restrict readonly writeonly highp mediump lowp subroutine layout ";
constexpr std::string_view kStatements =
    " if else for while do switch case default return break continue discard ";

constexpr std::array<KeywordRow, 17> kTypes = {{
    {110, "void float int bool vec2 vec3 vec4 ivec2 ivec3 ivec4 bvec2 bvec3 bvec4 mat2 mat3 mat4"},
    {110, "sampler1D sampler2D sampler3D samplerCube sampler1DShadow sampler2DShadow"},
    {120, "mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4"},
    {130, "uint uvec2 uvec3 uvec4 sampler1DArray sampler2DArray sampler1DArrayShadow sampler2DArrayShadow"},
    {130, "samplerCubeShadow isampler1D isampler2D isampler3D isamplerCube isampler1DArray isampler2DArray"},
    {130, "usampler1D usampler2D usampler3D usamplerCube usampler1DArray usampler2DArray"},
    {140, "sampler2DRect sampler2DRectShadow isampler2DRect usampler2DRect samplerBuffer isamplerBuffer"},
    {140, "usamplerBuffer"},
    {150, "sampler2DMS isampler2DMS usampler2DMS sampler2DMSArray isampler2DMSArray usampler2DMSArray"},
    {400, "double dvec2 dvec3 dvec4 dmat2 dmat3 dmat4 dmat2x2 dmat2x3 dmat2x4 dmat3x2 dmat3x3 dmat3x4"},
    {400,
     "dmat4x2 dmat4x3 dmat4x4 samplerCubeArray isamplerCubeArray usamplerCubeArray samplerCubeArrayShadow"},
    {420,
     "image1D image2D image3D imageCube image2DRect imageBuffer image1DArray image2DArray imageCubeArray"},
    {420,
     "image2DMS image2DMSArray iimage1D iimage2D iimage3D iimageCube iimage2DRect iimageBuffer "
     "iimage1DArray"},
    {420, "iimage2DArray iimageCubeArray iimage2DMS iimage2DMSArray uimage1D uimage2D uimage3D uimageCube"},
    {420, "uimage2DRect uimageBuffer uimage1DArray uimage2DArray uimageCubeArray uimage2DMS uimage2DMSArray"},
    {420, "atomic_uint"},
    {kReserved, "sampler3DRect"},
}};

constexpr std::array<KeywordRow, 11> kOthers = {{
    {110,
     "attribute const uniform varying break continue do for while if else in out inout true false discard"},
    {110, "return struct"},
    {120, "centroid invariant"},
    {130, "flat smooth noperspective switch case default lowp mediump highp precision"},
    {140, "layout"},
    {400, "patch sample subroutine precise"},
    {420, "coherent volatile restrict readonly writeonly"},
    {430, "buffer shared"},
    {kReserved,
     "common partition active asm class union enum typedef template this resource goto inline noinline"},
    {kReserved, "public static extern external interface long short half fixed unsigned superp input output"},
    {kReserved, "hvec2 hvec3 hvec4 fvec2 fvec3 fvec4 filter sizeof cast namespace using packed"},
}};

template <class Rows>
void addRows(std::unordered_map<std::string_view, int>& table, const Rows& rows) {
    for (const KeywordRow& row : rows) {
        std::string_view rest = row.words;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            table.emplace(rest.substr(0, end), row.since);
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
}

const std::unordered_map<std::string_view, int>& typeTable() {
    static const auto kTable = [] {
        std::unordered_map<std::string_view, int> table;
        addRows(table, kTypes);
        return table;
    }();
    return kTable;
}

const std::unordered_map<std::string_view, int>& otherTable() {
    static const auto kTable = [] {
        std::unordered_map<std::string_view, int> table;
        addRows(table, kOthers);
        return table;
    }();
    return kTable;
}

}  // namespace

bool listed(std::string_view list, std::string_view word) {
    const std::string key = " " + std::string(word) + " ";
    return list.find(key) != std::string_view::npos;
}

int keywordSince(std::string_view word) {
    if (const auto found = typeTable().find(word); found != typeTable().end()) return found->second;
    const auto found = otherTable().find(word);
    return found == otherTable().end() ? 0 : found->second;
}

std::vector<std::string_view> keywords() {
    std::vector<std::string_view> words;
    for (const auto* table : {&typeTable(), &otherTable()})
        for (const auto& [word, since] : *table) words.push_back(word);
    std::sort(words.begin(), words.end());
    return words;
}

bool isTypeWord(std::string_view word) {
    return typeTable().contains(word);
}

bool isQualifierWord(std::string_view word) {
    return otherTable().contains(word) && listed(kQualifiers, word);
}

bool isStatementWord(std::string_view word) {
    return otherTable().contains(word) && listed(kStatements, word);
}

bool isImageTypeWord(std::string_view word) {
    return isTypeWord(word) && word.find("image") != std::string_view::npos;
}

bool isOpaqueTypeWord(std::string_view word) {
    return isTypeWord(word) &&
           (isImageTypeWord(word) || word == "atomic_uint" || word.find("sampler") != std::string_view::npos);
}

}  // namespace glibra::glsl
