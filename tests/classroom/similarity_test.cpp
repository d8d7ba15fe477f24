// Winnowing: what is found to be similar, and where.

#include "classroom/tokens.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <set>
#include <utility>

namespace glibra::classroom {
namespace {

constexpr const char* kShader = R"(#version 330 core
in vec3 vN;
uniform float uKd, uKs = 0.5;
uniform vec3 uLights[4];
out vec4 fColor;

float bump(float x, float width) {
    float inside = smoothstep(0.0, width, x) * smoothstep(0.0, width, 1.0 - x);
    return inside * inside;   // twice as steep
}

void main() {
    vec3 n = normalize(vN);
    float sum = 0.1;
    for (int i = 0; i < 4; ++i) {
        float one = dot(n, normalize(uLights[i]));
        sum += uKd * max(one, 0.0) + uKs * pow(max(one, 0.0), 8.0);
    }
    fColor = vec4(vec3(sum) * bump(vN.x, 0.25), 1.0);
}
)";

/// The same with other names, numbers, blanks and comments.
constexpr const char* kRenamed = R"(#version 330 core
in vec3 vNormal; uniform float uD, uS; uniform vec3 uL[4]; out vec4 fragColor;
float hill(float at, float w) { float inner = smoothstep(0.5, w, at) * smoothstep(.25, w, 2. - at);
  /* mine */ return inner * inner; }
void main() { vec3 nn = normalize(vNormal); float all = 0.7;
for (int k = 0; k < 8; ++k) { float d = dot(nn, normalize(uL[k])); all += uD * max(d, 0.) + uS * pow(max(d, 0.), 32.); }
fragColor = vec4(vec3(all) * hill(vNormal.x, 0.5), 1.); }
)";

constexpr const char* kOther = R"(#version 330 core
uniform sampler2D uMap;
in vec2 vST;
out vec4 fColor;
void main() {
    if (vST.s < 0.5) discard;
    ivec2 size = textureSize(uMap, 0);
    vec4 texel = texelFetch(uMap, ivec2(vST * vec2(size)), 0);
    float grey = 0.2126 * texel.r + 0.7152 * texel.g + 0.0722 * texel.b;
    while (grey > 0.25) grey -= 0.25;
    fColor = mix(vec4(grey), texel.bgra, step(0.1, grey));
}
)";

std::vector<SourceFile> fileOf(std::string_view text) {
    return {{"a.frag", comparableTokens(text)}};
}

std::vector<std::uint32_t> codesOf(std::string_view text) {
    std::vector<std::uint32_t> codes;
    for (const SourceToken& each : comparableTokens(text)) codes.push_back(each.code);
    return codes;
}

std::vector<std::vector<Fingerprint>> fingerprints(std::initializer_list<const char*> texts,
                                                   const GivenCode& given = {}) {
    std::vector<std::vector<Fingerprint>> all;
    for (const char* each : texts) all.push_back(fingerprintsOf(fileOf(each), given));
    return all;
}

TEST(ComparableTokens, NamesNumbersCommentsAndBlanksDoNotCount) {
    EXPECT_EQ(codesOf(kShader), codesOf(kRenamed));
    EXPECT_NE(codesOf(kShader), codesOf(kOther));
}

TEST(ComparableTokens, BuiltInFunctionsAndTypesCount) {
    EXPECT_NE(codesOf("void main() { a = sin(b); }"), codesOf("void main() { a = cos(b); }"));
    EXPECT_NE(codesOf("vec2 f(float x) { return x; }"), codesOf("vec3 f(float x) { return x; }"));
    EXPECT_EQ(codesOf("float f(float x) { return x; } void main() { f(1.); }"),
              codesOf("float g(float y) { return y; } void main() { g(2); }"));
}

TEST(ComparableTokens, TheInterfaceAndDirectivesAreLeftOutButMacrosStay) {
    EXPECT_TRUE(codesOf("#version 330\n#extension GL_x : enable\nuniform float a;\nin vec3 b;\nout vec4 c;\n"
                        "uniform Block { vec4 d; vec4 e; } block;\n")
                    .empty());
    EXPECT_FALSE(codesOf("#define TWICE(x) ((x) + (x))\n").empty());
    // A parameter is no interface.
    EXPECT_EQ(codesOf("void f(in float a, out float b) { b = a; }").size(), 17U);
}

TEST(ComparableTokens, LinesAreThoseOfTheText) {
    const std::vector<SourceToken> tokens = comparableTokens("// a comment\n\nvoid\nmain ( )\n{ }\n");
    ASSERT_EQ(tokens.size(), 6U);
    EXPECT_EQ(tokens[0].line, 3);
    EXPECT_EQ(tokens[1].line, 4);
    EXPECT_EQ(tokens[5].line, 5);
}

TEST(ComparableTokens, AtMostAsManyAsAskedFor) {
    EXPECT_EQ(comparableTokens(kShader, 10).size(), 10U);
}

TEST(DeclaredUniforms, ListsArraysInitialisersAndBlocksAreRead) {
    const std::vector<DeclaredUniform> expected{
        {"uKd", "float"}, {"uKs", "float"}, {"uLights", "vec3"}, {"uBox", "block"}, {"uMap", "sampler2D"}};
    EXPECT_EQ(declaredUniforms("uniform float uKd, uKs = max(0.5, 1.);\nuniform vec3 uLights[4];\n"
                               "layout(std140) uniform uBox { mat4 m; float x, y; };\n"
                               "layout(binding = 3) uniform highp sampler2D uMap;\n// uniform float uNot;\n"),
              expected);
    EXPECT_TRUE(declaredUniforms("uniform").empty());
    EXPECT_TRUE(declaredUniforms("uniform float").empty());
}

TEST(IncludedNames, BothKindsOfQuotes) {
    EXPECT_EQ(
        includedNames("#include \"a/b.glsl\"\n  #  include <c.glsl>\n// #include \"no.glsl\"\n#include\n"),
        (std::vector<std::string>{"a/b.glsl", "c.glsl"}));
}

TEST(Winnowing, GramHashesAreThoseOfEachGramAlone) {
    const std::vector<SourceToken> tokens = comparableTokens(kShader);
    const std::vector<std::uint64_t> hashes = gramHashes(tokens);
    ASSERT_EQ(hashes.size(), tokens.size() - kGram + 1);
    for (std::size_t i = 0; i < hashes.size(); ++i)
        EXPECT_EQ(gramHashes(std::span(tokens).subspan(i, kGram)), std::vector{hashes[i]}) << i;
    EXPECT_TRUE(gramHashes(std::span(tokens).first(kGram - 1)).empty());
}

// Schleimer, Wilkerson and Aiken, section 3.1: every window of w hashes has one that is kept.
TEST(Winnowing, EveryWindowHasAFingerprintAndFewAreKept) {
    std::mt19937 random(7);
    std::vector<SourceFile> files{{"random.frag", {}}};
    for (int i = 0; i < 20'000; ++i) files[0].tokens.push_back({static_cast<std::uint32_t>(random()), i + 1});
    const std::vector<Fingerprint> kept = fingerprintsOf(files, {});
    std::size_t next = 0;
    for (const Fingerprint& each : kept) {
        EXPECT_LE(each.place.token, next + kWindow - 1);
        next = each.place.token + 1;
    }
    EXPECT_GE(next + kWindow - 1, files[0].tokens.size() - kGram + 1);
    // Their density is 2 / (w + 1) (section 3.3).
    const double density = static_cast<double>(kept.size()) / static_cast<double>(files[0].tokens.size());
    EXPECT_NEAR(density, 2.0 / (kWindow + 1), 0.01);
}

TEST(Winnowing, EverySharedPassageOfThatLengthIsFoundWhereverItStands) {
    std::mt19937 random(3);
    const auto randomTokens = [&](std::size_t count) {
        std::vector<SourceToken> tokens(count);
        for (SourceToken& each : tokens) each.code = static_cast<std::uint32_t>(random());
        return tokens;
    };
    for (int trial = 0; trial < 200; ++trial) {
        const std::vector<SourceToken> shared = randomTokens(kLongestUnseen + 1);
        const auto around = [&](std::size_t before, std::size_t after) {
            std::vector<SourceFile> files{{"x.frag", randomTokens(before)}};
            std::vector<SourceToken>& tokens = files[0].tokens;
            tokens.insert(tokens.end(), shared.begin(), shared.end());
            for (const SourceToken& each : randomTokens(after)) tokens.push_back(each);
            return files;
        };
        const std::vector<SourceFile> a = around(random() % 60, random() % 60),
                                      b = around(random() % 60, random() % 60);
        const std::vector<SharedPassage> found =
            sharedPassages(a, fingerprintsOf(a, {}), b, fingerprintsOf(b, {}), 10);
        ASSERT_EQ(found.size(), 1U) << trial;
        EXPECT_EQ(found[0].tokens, kLongestUnseen + 1);
    }
}

TEST(Similarity, ARenamedCopyIsWhollySimilarAndAnotherShaderIsNot) {
    const std::vector<SimilarPair> pairs = similarPairs(fingerprints({kOther, kShader, kRenamed}));
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_EQ(pairs[0].a, 1U);
    EXPECT_EQ(pairs[0].b, 2U);
    EXPECT_EQ(pairs[0].ofA, 1);
    EXPECT_EQ(pairs[0].ofB, 1);
}

TEST(Similarity, CodeThatWasGivenToAllIsLeftOut) {
    GivenCode given;
    addGivenCode(given, comparableTokens(kRenamed));
    EXPECT_TRUE(similarPairs(fingerprints({kShader, kShader}, given)).empty());
    // What was added to it counts.
    const std::string longer = std::string(kShader) + std::string(kOther);
    const std::vector<SimilarPair> pairs =
        similarPairs(fingerprints({longer.c_str(), longer.c_str()}, given));
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_EQ(pairs[0].figure(), 1);
}

TEST(Similarity, AFunctionThatWasCopiedIsAPartOfEach) {
    const std::string both = std::string(kOther) + std::string(kShader);
    const std::vector<SimilarPair> pairs = similarPairs(fingerprints({kShader, both.c_str()}));
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_GT(pairs[0].ofA, 0.8);
    EXPECT_LT(pairs[0].ofB, 0.75);
    EXPECT_EQ(pairs[0].figure(), pairs[0].ofA);
}

TEST(Similarity, AFileIsNoCopyOfItselfButOneOfEveryOther) {
    // 0 and 1 have copied; 2 uses their two files, 3 that of 0 and a copy of its own.
    const std::vector<std::vector<Fingerprint>> one = fingerprints({kShader});
    std::vector<Fingerprint> both = one[0];
    for (Fingerprint each : one[0]) {
        each.place.file = 1;
        both.push_back(each);
    }
    const std::vector<std::vector<Fingerprint>> prints{one[0], one[0], both, both, one[0]};
    const std::vector<std::vector<std::string>> files{
        {"ana.frag"}, {"bob.frag"}, {"ana.frag", "bob.frag"}, {"ana.frag", "own.frag"}, {"ana.frag"}};
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (const SimilarPair& each : similarPairs(prints, files)) found.emplace_back(each.a, each.b);
    std::ranges::sort(found);
    // Only 0 and 4 have nothing but one and the same file.
    EXPECT_EQ(found, (std::vector<std::pair<std::size_t, std::size_t>>{
                         {0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {1, 4}, {2, 3}, {2, 4}, {3, 4}}));
}

TEST(Similarity, PairsAreInTheOrderOfTheirFigures) {
    const std::string half = std::string(kOther) + std::string(kShader);
    const std::vector<SimilarPair> pairs =
        similarPairs(fingerprints({half.c_str(), kShader, kRenamed, kOther}));
    ASSERT_GE(pairs.size(), 3U);
    EXPECT_EQ(pairs[0].a, 1U);
    EXPECT_EQ(pairs[0].b, 2U);
    for (std::size_t i = 1; i < pairs.size(); ++i) EXPECT_GE(pairs[i - 1].figure(), pairs[i].figure());
}

TEST(Similarity, PassagesDoNotOverlapAndHaveTheirLines) {
    const std::string moved = "void first() { discard; }\n\n" + std::string(kShader);
    const std::vector<SourceFile> a = fileOf(kShader), b = fileOf(moved);
    const std::vector<SharedPassage> passages =
        sharedPassages(a, fingerprintsOf(a, {}), b, fingerprintsOf(b, {}), 10);
    ASSERT_EQ(passages.size(), 1U);
    EXPECT_EQ(passages[0].a.token, 0U);
    EXPECT_EQ(passages[0].tokens, a[0].tokens.size());
    EXPECT_EQ(b[0].tokens[passages[0].b.token].line, a[0].tokens[0].line + 2);
    EXPECT_TRUE(sharedPassages(a, fingerprintsOf(a, {}), b, fingerprintsOf(b, {}), 0).empty());
}

TEST(Similarity, CodeThatRepeatsItselfEndsInTime) {
    std::string text = "void main() {\n";
    for (int i = 0; i < 12'000; ++i) text += "a = b;\n";
    const std::vector<SourceFile> a = fileOf(text), b = fileOf(text + "}");
    const std::vector<SharedPassage> passages =
        sharedPassages(a, fingerprintsOf(a, {}), b, fingerprintsOf(b, {}), 3);
    EXPECT_FALSE(passages.empty());
}

}  // namespace
}  // namespace glibra::classroom
