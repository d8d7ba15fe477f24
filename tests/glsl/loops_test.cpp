// The rounds of loops, counted from the text and the values of uniforms.

#include <gtest/gtest.h>

#include <map>

#include "support.h"

namespace glibra::glsl::test {
namespace {

const std::map<std::string, double, std::less<>> kValues{{"uN", 1000}, {"uM", 30}, {"uStep", .25}};
std::optional<double> valueOf(std::string_view name) {
    const auto found = kValues.find(name);
    return found == kValues.end() ? std::nullopt : std::optional(found->second);
}

std::vector<CountedLoop> loopsOfText(const std::string& functions, const std::string& body) {
    const TranslatedProgram translated = translateSingle(
        Stage::fragment,
        "#version 330\nout vec4 fColor;\nuniform int uN;\nuniform float uM, uStep;\nuniform "
        "int uUnknown;\n" +
            functions + "void main() {\n  int n = 0;\n  " + body + "\n  fColor = vec4(n);\n}\n");
    EXPECT_EQ(translated.stages.size(), 1U) << ids(translated.diagnostics);
    return translated.stages.empty() ? std::vector<CountedLoop>() : translated.stages[0].loops;
}

double rounds(const std::string& body, const std::string& functions = "") {
    double all = 0;
    for (const CountedLoop& each : loopsOfText(functions, body)) all += totalRounds(each, valueOf);
    return all;
}

TEST(Loops, AreCountedInEverySpelling) {
    EXPECT_EQ(rounds("for (int i = 0; i < uN; ++i) n++;"), 1000);
    EXPECT_EQ(rounds("for (int i = 0; i <= uN; i++) n++;"), 1001);
    EXPECT_EQ(rounds("for (int i = uN; i > 0; i -= 3) n++;"), 334);
    EXPECT_EQ(rounds("for (int i = uN; i >= 0; --i) n++;"), 1001);
    EXPECT_EQ(rounds("for (int i = 0; uN > i; i += 2) n++;"), 500);
    EXPECT_EQ(rounds("int i; for (i = 5; i < 2 * (uN - 5); i = i + 1) n++;"), 1985);
    EXPECT_EQ(rounds("for (float t = -1.; t < 99.; t += uStep) { n++; }"), 400);
    EXPECT_EQ(rounds("for (int i = 0, j = 9; i < 0x100; i++, j--) n += j;"), 256);
    EXPECT_EQ(rounds("for (int i = 0; i < min(uN, 50); ++i) n++;"), 50);
    EXPECT_EQ(rounds("for (uint i = 0u; i < uint(uM * 1.75); ++i) n++;"), 52);
}

TEST(Loops, CountTheMostRoundsThatTheyMayRun) {
    EXPECT_EQ(rounds("for (int i = 0; i < uN && n < 7; ++i) { n++; if (n > 5) break; }"), 1000);
}

TEST(Loops, WhileIsCountedByTheStepThatEveryRoundExecutes) {
    EXPECT_EQ(rounds("while (n < uN) n++;"), 1000);
    EXPECT_EQ(rounds("int i = 5; while (i <= uN) { if (n > 3) break; i += 5; }"), 200);
    EXPECT_EQ(rounds("n = uN; while (n > 0 && uM > 2.) { n = n - 1; }"), 1000);
    EXPECT_EQ(rounds("float t = 0., u = 1.; while (uM > t) { for (int k = 0; k < 2; ++k) { u *= t; } t += "
                     "uStep; n++; }"),
              120);
    EXPECT_EQ(rounds("int i = 0; if (uM > 1.) { n = 4; } while (i < uN) { if (n > 4) { n = 2; } ++i; }"),
              1000);
    EXPECT_EQ(rounds("while (n++ < uN) { }"), 1000);
    EXPECT_EQ(rounds("for (int i = uN; i-- > 0;) n++;"), 1000);
    EXPECT_EQ(rounds("for (int i = 0; i < uN; ++i) { int j = 0; while (j < 40) { j++; n++; } }"), 1000 * 41);
    EXPECT_EQ(rounds("n = sum(1);", "int sum(int k) { int i = uN; while (i >= 1) i -= 2; return i; }\n"),
              500);
}

TEST(Loops, TakeConstantsAndVariablesThatKeepTheirValue) {
    EXPECT_EQ(rounds("for (int i = 0; i < kMost; ++i) n++;", "const int kHalf = 350, kMost = 2 * kHalf;\n"),
              700);
    EXPECT_EQ(rounds("int most = int(uM) * 10; for (int i = 0; i < most; ++i) n++;"), 300);
    EXPECT_EQ(rounds("for (int i = 0; i < MOST; ++i) n++;", "#define MOST (uN + 1)\n"), 1001);
}

TEST(Loops, InsideOthersMultiply) {
    EXPECT_EQ(rounds("for (int i = 0; i < uN; ++i) for (float j = 0.; j < uM; ++j) n++;"), 1000 * 31);
    EXPECT_EQ(
        rounds("for (int i = 0; i < uN; ++i) { if (n > 2) for (int j = 0; j < 40; ++j) n++; else n++; }"),
        1000 * 41);
    EXPECT_EQ(rounds("for (int i = 0; i < uN; ++i) n++; for (int i = 0; i < uN; ++i) n++;"), 2000);
}

TEST(Loops, UnderAConditionEndBeforeItsElse) {
    EXPECT_EQ(rounds("if (uM > 1.) for (int i = 0; i < uN; ++i) n++; else for (int i = 0; i < 50; ++i) n++;"),
              1050);
    EXPECT_EQ(rounds("for (int i = 0; i < uN && n < 3 || n > 5; ++i) n++;"), 0) << "|| may go on";
}

TEST(Loops, ThatCompilersUnrollCountZero) {
    EXPECT_EQ(rounds("for (int i = 0; i < uN; ++i) for (int j = 0; j < 32; ++j) n++;"), 1000);
    EXPECT_EQ(rounds("for (int i = 0; i < uN; ++i) for (int j = 0; j < 33; ++j) n++;"), 34'000);
}

TEST(Loops, InFunctionsCountPerCall) {
    const std::string sum = "int sum(int k) { for (int i = 0; i < uN; ++i) k++; return k; }\n";
    EXPECT_EQ(rounds("n = sum(1);", sum), 1000);
    EXPECT_EQ(rounds("n = sum(sum(1));", sum), 2000);
    EXPECT_EQ(rounds("for (int i = 0; i < 100; ++i) n = sum(n);", sum), 100 * 1001);
    EXPECT_EQ(rounds("n = 1;", sum), 0);
}

TEST(Loops, WithUnknownRoundsAreLeftOut) {
    for (const char* body :
         {"for (;;) { if (n++ > 5) break; }", "for (int i = 0; i < uUnknown; ++i) n++;",
          "for (int i = 0; i < uN; ++i) { n++; i += 2; }", "for (int i = 0; i < uN; i *= 2) n++;",
          "int most = uN; most += n; for (int i = 0; i < most; ++i) n++;",
          "for (int i = 0; i < uN; --i) n++;", "for (int i = 0; i < uN; i += 0) n++;",
          "for (int i = 9; i < int(gl_FragCoord.x); ++i) n++;"})
        EXPECT_EQ(rounds(body), 0) << body;
    // The variable of a `while` is set elsewhere, or changed twice, or not in every round.
    for (const char* body :
         {"while (n < uN) { n++; n++; }", "while (n < uN) if (n > 5) n++;",
          "while (n < uN) { if (n > 5) { n++; } }", "while (n < uN) { if (n > 5) n += 2; else n += 3; }",
          "while (n < uN) { if (uM > 5.) continue; n++; }", "while (n < uN) { for (;;) n++; }",
          "if (uM > 5.) n = 7; while (n < uN) n++;", "if (uM > 5.) { n = 7; } while (n < uN) n++;",
          "int i; if (uM > 5.) i = 0; while (i < uN) i++;", "n += 9; while (n < uN) n++;",
          "for (;;) while (n < uN) n++;", "for (;;) { while (n < uN) n++; }", "while (n++ < uN) n++;",
          "while (n < uN) n--;", "while (n < uN);", "while (n < uN) { { n++; } }"})
        EXPECT_EQ(rounds(body), 0) << body;
    // Loops inside such a loop are counted.
    EXPECT_EQ(rounds("while (n < 5) for (int i = 0; i < uN; ++i) n++;"), 1000);
}

TEST(Loops, HaveThePlaceOfTheirKeyword) {
    const std::vector<CountedLoop> loops = loopsOfText("", "n++;\n    for (int i = 0; i < uN; ++i) n++;");
    ASSERT_EQ(loops.size(), 1U);
    EXPECT_EQ(loops[0].place.file, "a.frag");
    EXPECT_EQ(loops[0].place.line, 9);
    EXPECT_EQ(loops[0].place.column, 5);
}

TEST(Loops, InEndlessRecursionEndTheSearch) {
    std::string functions = "int f0(int k) { return k; }\n";
    for (int i = 1; i < 60; ++i)
        functions += "int f" + std::to_string(i) + "(int k) { return f" + std::to_string(i - 1) + "(k) + f" +
                     std::to_string(i - 1) + "(k + 1); }\n";
    EXPECT_EQ(rounds("n = f59(1);", functions), 0);
    EXPECT_EQ(rounds("n = f(1);", "int f(int k) { return f(k); }\n"), 0);
}

/// The rounds in a compute stage with images, textures and blocks, whose sizes are given by name.
double measured(const std::string& body) {
    const TranslatedProgram translated = translateSingle(
        Stage::compute,
        "#version 430\nlayout(local_size_x = 1) in;\nlayout(r32f) uniform image2D uMap;\n"
        "uniform sampler3D uVolume;\nuniform samplerBuffer uList;\nlayout(std430) buffer Data { int count; "
        "float data[]; };\nlayout(std430) buffer More { int size; vec4 all[]; } more;\nvoid main() {\n  int "
        "n "
        "= 0;\n  " +
            body + "\n  data[0] = float(n);\n}\n");
    const std::map<std::string, double, std::less<>> sizes{{"imageSize(uMap).x", 100},
                                                           {"imageSize(uMap).y", 50},
                                                           {"textureSize(uVolume, 0).z", 8},
                                                           {"textureSize(uVolume, 1).x", 16},
                                                           {"data.length()", 77},
                                                           {"more.all.length()", 33},
                                                           {"count", 12},
                                                           {"more.size", 9},
                                                           {"textureSize(uList, 0).x", 5}};
    double all = 0;
    for (const CountedLoop& each : translated.stages.at(0).loops)
        all += totalRounds(each, [&](std::string_view name) {
            const auto found = sizes.find(name);
            return found == sizes.end() ? std::nullopt : std::optional(found->second);
        });
    return all;
}

TEST(Loops, AreCountedUpToSizesOfImagesTexturesAndBuffers) {
    EXPECT_EQ(measured("for (int i = 0; i < imageSize(uMap).x; ++i) n++;"), 100);
    EXPECT_EQ(measured("ivec2 size = imageSize(uMap); for (int y = 0; y < size.y; y++) for (int x = 0; x < "
                       "size.x; x++) n++;"),
              50 * 101);
    EXPECT_EQ(measured("int w = imageSize(uMap).x; for (int i = 0; i < w - 1; ++i) n++;"), 99);
    EXPECT_EQ(measured("for (int i = 0; i < textureSize(uVolume, 0).z; ++i) n++;"), 8);
    EXPECT_EQ(measured("ivec3 s = textureSize(uVolume, 1); for (int i = 0; i < s.r; ++i) n++;"), 16);
    EXPECT_EQ(measured("for (int i = 0; i < textureSize(uList); ++i) n++;"), 5);
    EXPECT_EQ(measured("for (int i = 0; i < data.length(); ++i) n++;"), 77);
    EXPECT_EQ(measured("for (uint i = 0u; i < uint(more.all.length()); ++i) n++;"), 33);
    EXPECT_EQ(measured("for (int i = 0; i < count; ++i) n++;"), 12);
    EXPECT_EQ(measured("for (int i = 0; i < more.size * 2; ++i) n++;"), 18);
    EXPECT_EQ(measured("ivec2 size = imageSize(uMap); size.x = 3; for (int i = 0; i < size.x; ++i) n++;"), 0);
}

TEST(Loops, WithoutAConditionEndAtTheirBreak) {
    EXPECT_EQ(rounds("int i = 0; while (true) { if (i >= uN) break; i++; n++; }"), 1000);
    EXPECT_EQ(rounds("int i = 0; while (true) { n++; if (i > uN) { break; } ++i; }"), 1001);
    EXPECT_EQ(rounds("for (int i = 0;; i++) { if (i == uN) break; n++; }"), 1000);
    EXPECT_EQ(rounds("int i = uN; for (;;) { if (i <= 0 || n > 3) break; i -= 2; }"), 500);
    EXPECT_EQ(rounds("int i = 0; do { i++; } while (i < uN);"), 1000);
    EXPECT_EQ(rounds("int i = 0; do { n++; i += 4; if (uM > 2.) n = 3; } while (i != uN);"), 250);
    EXPECT_EQ(rounds("int i = 0; while (i != uN) i++;"), 1000);
    EXPECT_EQ(rounds("while (true) { if (n > 77) break; n++; }"), 78);
    EXPECT_EQ(rounds("do n++; while (n < uN);"), 1000);
    EXPECT_EQ(rounds("while (true) { if (uM > 2.) break; }"), 0);
}

/// The number of loops that main runs and that cannot be counted.
std::size_t uncounted(const std::string& body, const std::string& functions = "") {
    const TranslatedProgram translated = translateSingle(
        Stage::fragment, "#version 330\nout vec4 fColor;\nuniform int uN;\n" + functions +
                             "void main() {\n  int n = 0;\n  " + body + "\n  fColor = vec4(n);\n}\n");
    EXPECT_EQ(translated.stages.size(), 1U) << ids(translated.diagnostics);
    return translated.stages.empty() ? 0 : translated.stages[0].uncounted.size();
}

TEST(Loops, ThatCannotBeCountedAreListed) {
    const std::string row = "int row(int m) { int s = 0; for (int i = 0; i < m; i++) s++; return s; }\n";
    const std::string two =
        "int two(int m) { int s = 0; while (s < m) s += m; return s; }\n"
        "int two(float m) { return int(m); }\n";
    EXPECT_EQ(uncounted("for (int i = 0; i < uN; ++i) for (int j = 0; j < 5; ++j) n++;"), 0U);
    EXPECT_EQ(uncounted("for (uint i = 9u; i > 0u; i--) n++;"), 0U);
    EXPECT_EQ(uncounted("for (uint i = 9u; i >= 0u; i--) n++;"), 1U) << "it never is less";
    EXPECT_EQ(uncounted("for (uint i = 9u; i > 0u; i -= 2u) n++;"), 1U) << "it steps over 0";
    EXPECT_EQ(rounds("for (int i = 0; i != 5; i += 2) n++;"), 0) << "it steps over 5";
    EXPECT_EQ(uncounted("n++;", row), 0U) << "nothing calls it";
    EXPECT_EQ(uncounted("for (int i = 0; i < uN; ++i) for (int j = 0; j < i; ++j) n++;"), 1U);
    EXPECT_EQ(uncounted("n = row(9) + row(5);", row), 1U);
    EXPECT_EQ(uncounted("for (int i = 0; i < row(9); ++i) n++;", row), 1U) << "its own rounds";
    EXPECT_EQ(uncounted("int i = 0; while (i++ < row(9)) n++;", row), 1U);
    EXPECT_EQ(uncounted("n = two(9);", two), 1U);
    EXPECT_EQ(uncounted("do n += n + 1; while (n < 99);"), 1U);
    EXPECT_EQ(uncounted("while (true) { if (fract(float(n)) > 2.) break; }"), 1U);
}

/// The text of a program that records which loops a driver ends.
TEST(Loops, RecordThatTheyAreLeftWhileTheyGoOn) {
    ProgramRequest request;
    request.target.version = 450;
    request.recordsLoops = true;
    request.stages = {{Stage::fragment, "a.frag",
                       "#version 430\nout vec4 c;\nvoid main() {\nint n = 0;\n"
                       "for (int i = 0; i < 8; ++i) n++;\n"
                       "for (int i = 0; n < 80; ++i)\nfor (;;) if (n++ > i) break;\n"
                       "while (bool goes = n > 0) { switch (n) { case 1: break; } n--; }\n"
                       "do n++; while (n < 9 * n);\nc = vec4(n);\n}\n"}};
    const TranslatedProgram translated = translate(request);
    ASSERT_EQ(translated.stages.size(), 1U) << ids(translated.diagnostics);
    std::vector<int> lines;
    for (const Place& each : translated.loopSites) lines.push_back(each.line);
    EXPECT_EQ(lines, (std::vector<int>{7, 6, 8, 9})) << "inner loops first; the first one is unrolled";
    const std::string& source = translated.stages.front().source;
    for (const char* each : {"glibra_goes((true), 0)", "{ glibra_inLoop[0 + glibra_NoLoop] = 0; break; }",
                             "glibra_cutLoops[1] = 1; }", "early_fragment_tests"})
        EXPECT_NE(source.find(each), std::string::npos) << each << "\n" << source;
    EXPECT_NE(source.find("case 1: break;"), std::string::npos) << "it leaves no loop\n" << source;
    request.stages.front().text =
        "#version 430\nout vec4 c;\nvoid main() {\nif (gl_FragCoord.x > 1.) while (c.x < 9.) c++; else "
        "c--;\n}\n";
    const std::string branches = translate(request).stages.front().source;
    EXPECT_NE(branches.find("glibra_cutLoops[0] = 1; } else c--;"), std::string::npos) << branches;
    request.recordsLoops = false;
    EXPECT_EQ(translate(request).stages.front().source.find("glibra_goes"), std::string::npos);
}

}  // namespace
}  // namespace glibra::glsl::test
