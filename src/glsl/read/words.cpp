#include "glsl/read/words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_map>

namespace glibra::glsl {

// ---- Versions

namespace {

constexpr std::array kKnown = {110, 120, 130, 140, 150, 330, 400, 410, 420, 430, 440, 450, 460};
constexpr int kHighest = 460;

std::string joined(std::span<const std::string_view> words) {
    std::string text = "#version";
    for (const std::string_view each : words) text += " " + std::string(each);
    return text;
}

/// The whole number at the start of `text`, -1 if there is none; `rest` is the text after it.
int leadingNumber(std::string_view text, std::string_view& rest) {
    int value = -1;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{}) {
        rest = text;
        return failure == std::errc::result_out_of_range ? 1'000'000 : -1;
    }
    rest = text.substr(static_cast<std::size_t>(end - text.data()));
    return value;
}

}  // namespace

Dialect readVersion(std::span<const std::string_view> words, const Place& place, int targetVersion,
                    Report& report) {
    Dialect dialect;
    dialect.given = true;
    dialect.place = place;
    std::string_view rest;
    int number = words.empty() ? -1 : leadingNumber(words[0], rest);
    bool tolerated = false;
    if (rest.starts_with(".") && number >= 1 && number < 10) {
        std::string_view after;
        int minor = leadingNumber(rest.substr(1), after);
        if (minor >= 0 && rest.size() == 2) minor *= 10;
        number = number * 100 + std::max(minor, 0);
        rest = after;
        tolerated = true;
    }
    if (number < 0 || !rest.empty()) tolerated = true;
    if (number < 0) number = 330;

    const std::string_view profile = words.size() > 1 ? words[1] : std::string_view{};
    if (profile == "es" || number == 100) {
        dialect.version = number <= 100 ? 120 : (number < 310 ? 330 : (number < 320 ? 430 : 450));
        dialect.written = number;
        dialect.es = true;
        report.report("glsl-W03", "'" + joined(words) + "' treated as " + std::to_string(dialect.version),
                      place);
        return dialect;
    }
    if (number > kHighest) {
        report.report("glsl-E07",
                      "#version " + std::to_string(number) + " is not supported, 460 is the highest", place);
        return dialect;
    }
    const auto* const above = std::upper_bound(kKnown.begin(), kKnown.end(), number);
    dialect.version = above == kKnown.begin() ? kKnown.front() : *(above - 1);
    dialect.written = number;
    dialect.core = profile == "core";
    if (profile == "core" || profile == "compatibility")
        dialect.profile = profile;
    else if (!profile.empty())
        tolerated = true;
    if (words.size() > 2 || dialect.version != number) tolerated = true;
    if (tolerated) {
        std::string reading = std::to_string(dialect.version);
        if (!dialect.profile.empty()) reading += " " + dialect.profile;
        report.report("glsl-W02", "'" + joined(words) + "' read as " + reading, place);
    }
    if (dialect.version == kHighest && targetVersion < kHighest)
        report.report("glsl-W18", "#version 460 compiled as " + std::to_string(targetVersion), place);
    return dialect;
}

// ---- Keywords

namespace {

/// `es` is the version of GLSL ES in which the words became keywords; 0: none.
struct KeywordRow {
    int since;
    int es;
    std::string_view words;
};

constexpr std::string_view kQualifiers =
    " attribute varying const uniform in out inout buffer shared centroid flat smooth noperspective "
    "invariant precise "
    "patch sample coherent volatile restrict readonly writeonly highp mediump lowp subroutine layout ";
constexpr std::string_view kStatements =
    " if else for while do switch case default return break continue discard ";

constexpr auto kTypes = std::to_array<KeywordRow>({
    {110, 100,
     "void float int bool vec2 vec3 vec4 ivec2 ivec3 ivec4 bvec2 bvec3 bvec4 mat2 mat3 mat4"
     " sampler2D samplerCube"},
    {110, 300, "sampler3D sampler2DShadow"},
    {110, 0, "sampler1D sampler1DShadow"},
    {120, 300, "mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4"},
    {130, 300,
     "uint uvec2 uvec3 uvec4 sampler2DArray sampler2DArrayShadow samplerCubeShadow isampler2D"
     " isampler3D isamplerCube isampler2DArray usampler2D usampler3D usamplerCube"
     " usampler2DArray"},
    {130, 0,
     "sampler1DArray sampler1DArrayShadow isampler1D isampler1DArray usampler1D"
     " usampler1DArray"},
    {140, 0, "sampler2DRect sampler2DRectShadow isampler2DRect usampler2DRect"},
    {140, 320, "samplerBuffer isamplerBuffer usamplerBuffer"},
    {150, 310, "sampler2DMS isampler2DMS usampler2DMS"},
    {150, 320, "sampler2DMSArray isampler2DMSArray usampler2DMSArray"},
    {400, 0,
     "double dvec2 dvec3 dvec4 dmat2 dmat3 dmat4 dmat2x2 dmat2x3 dmat2x4 dmat3x2 dmat3x3"
     " dmat3x4 dmat4x2 dmat4x3 dmat4x4"},
    {400, 320, "samplerCubeArray isamplerCubeArray usamplerCubeArray samplerCubeArrayShadow"},
    {420, 310,
     "image2D image3D imageCube image2DArray iimage2D iimage3D iimageCube iimage2DArray"
     " uimage2D uimage3D uimageCube uimage2DArray atomic_uint"},
    {420, 320, "imageBuffer imageCubeArray iimageBuffer iimageCubeArray uimageBuffer uimageCubeArray"},
    {420, 0,
     "image1D image2DRect image1DArray image2DMS image2DMSArray iimage1D iimage2DRect"
     " iimage1DArray iimage2DMS iimage2DMSArray uimage1D uimage2DRect uimage1DArray uimage2DMS"
     " uimage2DMSArray"},
    {kReserved, 0, "sampler3DRect"},
});

constexpr auto kOthers = std::to_array<KeywordRow>({
    {110, 100,
     "attribute const uniform varying break continue do for while if else in out inout true"
     " false discard return struct"},
    {120, 100, "invariant"},
    {120, 300, "centroid"},
    {130, 300, "flat smooth switch case default"},
    {130, 0, "noperspective"},
    {130, 100, "lowp mediump highp precision"},
    {140, 300, "layout"},
    {400, 320, "patch sample precise"},
    {400, 0, "subroutine"},
    {420, 310, "coherent volatile restrict readonly writeonly"},
    {430, 310, "buffer shared"},
    {kReserved, 0,
     "common partition active asm class union enum typedef template this resource goto inline"
     " noinline public static extern external interface long short half fixed unsigned superp"
     " input output hvec2 hvec3 hvec4 fvec2 fvec3 fvec4 filter sizeof cast namespace using"},
    // Versions before 4.20 reserve these, and some drivers take them for keywords in every version.
    {kReserved, 0, "packed row_major image1DShadow image2DShadow image1DArrayShadow image2DArrayShadow"},
});

struct Since {
    int desktop = 0;
    int es = 0;
};
using Table = std::unordered_map<std::string_view, Since>;

template <class Rows>
Table tableOf(const Rows& rows) {
    Table table;
    for (const KeywordRow& row : rows) {
        for (const std::string_view word : splitWords(row.words))
            table.emplace(word, Since{row.since, row.es});
    }
    return table;
}

const Table& typeTable() {
    static const Table kTable = tableOf(kTypes);
    return kTable;
}

const Table& otherTable() {
    static const Table kTable = tableOf(kOthers);
    return kTable;
}

Since sinceOf(std::string_view word) {
    if (const auto found = typeTable().find(word); found != typeTable().end()) return found->second;
    const auto found = otherTable().find(word);
    return found == otherTable().end() ? Since{} : found->second;
}

}  // namespace

bool listed(std::string_view list, std::string_view word) {
    const std::string key = " " + std::string(word) + " ";
    return list.find(key) != std::string_view::npos;
}

std::vector<std::string_view> splitWords(std::string_view list) {
    std::vector<std::string_view> words;
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(' '), list.size());
        if (end > 0) words.push_back(list.substr(0, end));
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return words;
}

int keywordSince(std::string_view word) {
    return sinceOf(word).desktop;
}

bool isFreeWord(std::string_view word, const Dialect& dialect) {
    const Since since = sinceOf(word);
    if (since.desktop == 0) return false;
    return dialect.es ? since.es == 0 || since.es > dialect.written : since.desktop > dialect.version;
}

std::vector<std::string_view> keywords() {
    std::vector<std::string_view> words;
    for (const auto* table : {&typeTable(), &otherTable()})
        for (const auto& [word, since] : *table) words.push_back(word);
    std::ranges::sort(words);
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

bool isAssignment(std::string_view text) {
    static constexpr std::array<std::string_view, 11> kAssignments = {
        "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="};
    return std::ranges::find(kAssignments, text) != kAssignments.end();
}

}  // namespace glibra::glsl
