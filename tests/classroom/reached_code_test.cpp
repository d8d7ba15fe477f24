// What a stage runs: what is no part of it hides no copy and earns no points.

#include "classroom/reached_code.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <set>
#include <string>
#include <vector>

#include "classroom/tokens.h"

namespace glibra::classroom {
namespace {

using Names = std::vector<std::string>;

ReachedCode codeOf(const std::string& text, const glsl::IncludeReader& include = {}) {
    return reachedCode({glsl::Stage::fragment, "a.frag", text}, include);
}

Names callsOf(const std::string& text, const glsl::IncludeReader& include = {}) {
    return codeOf(text, include).calls;
}

bool callsSmoothstep(const std::string& text) {
    const Names calls = callsOf("#version 330\nin vec2 vST;\nout vec4 f;\nuniform float uA;\n" + text);
    return std::ranges::find(calls, "smoothstep") != calls.end();
}

TEST(Calls, AreThoseThatAreCompiled) {
    const std::string end = "void main() { f = vec4(SS(0., 1., x)); }\n";
    EXPECT_EQ(callsOf("#version 330\n#define SS smoothstep\n" + end), (Names{"smoothstep", "vec4"}))
        << "a macro stands for its text";
    EXPECT_EQ(callsOf("#version 330\n#define SS(a, b, x) mix(a, b, step(.5, x))\n" + end),
              (Names{"mix", "step", "vec4"}));
    EXPECT_EQ(callsOf("#version 330\n#if 0\nfloat a = noise1(x);\n#else\nfloat b = sin(x);\n#endif\n"
                      "#ifdef NEVER\nfloat c = cos(x);\n#endif\n#define UNUSED tan(1.)\n"),
              Names{"sin"});
    const auto include = [](std::string_view name, std::string_view) -> std::optional<glsl::IncludedFile> {
        if (name != "more.glsl") return std::nullopt;
        return glsl::IncludedFile{"more.glsl", "#define SS fract\nfloat g(float x) { return exp(x); }\n"};
    };
    EXPECT_EQ(callsOf("#version 330\n#include \"more.glsl\"\nvoid main() { y = SS(g(x)); }\n", include),
              (Names{"exp", "fract", "g"}));
}

TEST(Calls, AreThoseThatRun) {
    const char* const kUse = "f = vec4(smoothstep(0., 1., vST.x));";
    const std::string use = kUse;
    const std::string red = "f = vec4(1., 0., 0., 1.);";
    for (const std::string& each : std::initializer_list<std::string>{
             "void main() { " + use + " }",
             "float s(float x) { return smoothstep(0., 1., x); }\nvoid main() { f = vec4(s(vST.x)); }",
             "void main() { if (uA > .5) { " + use + " } else " + red + " }",
             "void main() { if (vST.x > 2.) discard; " + use + " }",
             "void main() { for (int i = 0; i < 2; ++i) " + use + " }",
             "#define S smoothstep\nvoid main() { f = vec4(S(0., 1., vST.x)); }",
             "const float k = smoothstep(0., 1., .5);\nvoid main() { f = vec4(k); }",
             "void s(inout vec4 c) { c *= smoothstep(0., 1., vST.x); }\nvoid main() { " + red + " s(f); }",
             "float smoothstep(float a) { return a; }\nvoid main() { f = vec4(smoothstep(0., 1., "
             "smoothstep(1.))); }",
             "void main() { switch (int(uA)) { case 0: " + use + " break; default: " + red + " } }",
             "void main() { switch (0) { case 0: " + red + " case 1: " + use + " } }",
             "void main() { switch (5) { case 0: " + red + " default: " + use + " } }",
             "void main() { switch (1) { case 1: if (uA > 0.) break; " + use + " } }",
             "void main() { switch (1) { case 1: for (int i = 0; i < 2; ++i) { break; } " + use + " } }",
             "void main() { for (int i = 0; i < 9; ++i) { switch (1) { case 1: if (uA > 0.) continue; } " +
                 use + " } }",
             "void main() { do { if (uA > 0.) break; " + use + " } while (false); }",
             "void main() { do { if (uA > 0.) return; } while (false); " + use + " }",
             "void main() { while (true) { if (uA > 0.) break; return; } " + use + " }",
             "void main() { if (uA > .5) return; else f.x = 1.; " + use + " }",
             // what a condition that has a value does besides
             "bool g() { " + use + " return true; }\nvoid main() { if (g() && false) discard; }",
             "bool g() { " + use + " return true; }\nvoid main() { for (g(); false; ) discard; }",
             "int g() { " + use + " return 1; }\nvoid main() { switch (g()) { default: } }",
             "subroutine float Way();\nsubroutine uniform Way uWay;\n"
             "subroutine(Way) float one() { return smoothstep(0., 1., vST.x); }\nvoid main() { f = "
             "vec4(uWay()); }",
         })
        EXPECT_TRUE(callsSmoothstep(each)) << each;
    for (const std::string& each : std::initializer_list<std::string>{
             "float s(float x) { return smoothstep(0., 1., x); }\nvoid main() { " + red + " }",
             "float s(float x) { return smoothstep(0., 1., x); }\nfloat t() { return s(1.); }\nvoid main() "
             "{ " +
                 red + " }",
             "float s(float x) { return smoothstep(0., 1., x); }\nvoid main() { float s = 1.; f = vec4(s); }",
             "void main() { " + red + " if (false) " + use + " }",
             "void main() { " + red + " if (false) { " + use + " } }",
             "void main() { if (true) { " + red + " } else { " + use + " } }",
             "void main() { if (1 > 2) { " + use + " } else { " + red + " } }",
             "void main() { " + red + " if (!true || false && uA > 0.) { " + use + " } }",
             "const bool kNever = false;\nvoid main() { " + red + " if (kNever) { " + use + " } }",
             "void main() { bool never = false; " + red + " if (never) " + use + " }",
             "#define false true\nvoid main() { if (false) { " + red + " } else { " + use + " } }",
             "void main() { " + red + " while (false) { " + use + " } }",
             "void main() { " + red + " for (int i = 0; i < 0; ++i) { " + use + " } }",
             "void main() { " + red + " return; " + use + " }",
             "void main() { " + red + " { return; } " + use + " }",
             "void main() { " + red + " if (true) return; " + use + " }",
             "void main() { for (int i = 0; i < 2; ++i) { " + red + " break; " + use + " } }",
             "void main() { " + red + " float a = smoothstep(0., 1., vST.x); }",
             "void main() { " + red + " smoothstep(0., 1., vST.x); }",
             // a switch of a constant value, whose parts fall through up to a break
             "void main() { switch (1) { case 0: " + use + " break; default: " + red + " } }",
             "void main() { switch (0) { case 0: " + red + " break; case 1: " + use + " default: " + use +
                 " } }",
             "void main() { switch (0) { case 0: { " + red + " break; } default: " + use + " } }",
             "void main() { switch (2) { case 0: " + use + " case 1: " + use + " break; case 2: " + red +
                 " } }",
             "void main() { " + red + " switch (3) { case 0: " + use + " } }",
             "void main() { " + red + " switch (3) { case 0: " + use + " break; case 1: " + use + " } }",
             "void main() { " + red + " switch (1) { case 1: if (true) break; " + use + " } }",
             "void main() { " + red + " switch (1) { case 1: if (uA > 0.) break; else break; " + use + " } }",
             "void main() { switch (1) { case 1: if (uA > 0.) break; " + red + " break; case 2: " + use +
                 " } }",
             "const int kWay = 1;\nvoid main() { switch (kWay) { case 0: " + use + " break; case 1: " + red +
                 " } }",
             "void main() { switch (1) { default: " + use + " break; case 1: " + red + " } }",
             "void main() { switch (0) { default: switch (1) { case 0: " + use + " break; case 1: " + red +
                 " } } }",
             // parts of a switch that the value may choose
             "void main() { switch (int(uA)) { case 0: " + red + " break; default: if (false) " + use +
                 " } }",
             "void main() { switch (int(uA)) { case 0: " + red + " break; " + use + " default: " + red +
                 " } }",
             // loops that run once, and what always leaves
             "void main() { do { " + red + " break; " + use + " } while (true); }",
             "void main() { do { " + red + " return; } while (false); " + use + " }",
             "void main() { while (true) { " + red + " return; } " + use + " }",
             "void main() { for (int i = 0; i < 1; ++i) { " + red + " return; } " + use + " }",
             "void main() { " + red + " if (uA > .5) return; else { return; } " + use + " }",
             "void main() { " + red + " if (uA > .5) discard; else if (uA > .4) return; else return; " + use +
                 " }",
             "void main() { " + red + " for (f.x = 0.; false; ) { " + use + " } }",
             "void main() { f = vec4(false ? smoothstep(0., 1., vST.x) : 1.); }",
             "float junk;\nvoid main() { junk = smoothstep(0., 1., vST.x); " + red + " }",
             "const float k = smoothstep(0., 1., .5);\nvoid main() { " + red + " }",
             "float smoothstep(float a) { return a; }\nvoid main() { f = vec4(smoothstep(1.)); }",
             "float smoothstep(float a, float b, float c) { return a; }\nvoid main() { f = "
             "vec4(smoothstep(1., 2., 3.)); }",
             "#if 0\n" + use + "\n#endif\nvoid main() { " + red + " }",
             "// smoothstep(1.)\nvoid main() { " + red + " }",
         })
        EXPECT_FALSE(callsSmoothstep(each)) << each;
}

/// How much of `a` is in `b`, as the page of a class says it.
double similarity(const std::string& a, const std::string& b, const glsl::IncludeReader& include = {}) {
    std::vector<std::vector<Fingerprint>> prints;
    for (const std::string& each : {a, b}) prints.push_back(fingerprintsOf(codeOf(each, include).runs, {}));
    const std::vector<SimilarPair> pairs = similarPairs(prints);
    return pairs.empty() ? 0 : pairs[0].ofA;
}

constexpr const char* kBlend =
    "float blend(float a, float b, float x) {\n  float t = clamp((x - a) / (b - a), 0., 1.);\n"
    "  return t * t * (3. - 2. * t);\n}\n";
const std::vector<std::string> kLines{
    "float Ar = uAd / 2., Br = uBd / 2.;",
    "int numins = int(vST.s / uAd);",
    "float sc = float(numins) * uAd + Ar;",
    "float ds = (vST.s - sc) / Ar;",
    "float t = blend(1. - uTol, 1. + uTol, ds * ds);",
    "vec3 color = mix(vec3(1., .5, 0.), vec3(.2, .2, 1.), t);",
    "float light = .3 + .7 * max(0., dot(normalize(vN), vec3(0., 0., 1.)));",
    "f = vec4(color * light, 1.);"};
constexpr const char* kHead =
    "#version 330\nuniform float uAd, uBd, uTol;\nin vec2 vST; in vec3 vN;\nout vec4 f;\n";

std::string shaderOf(const std::string& first, const std::string& between = "",
                     const std::string& head = "") {
    std::string text = std::string(kHead) + head + kBlend + "void main() {\n" + first;
    for (const std::string& each : kLines) text += "  " + each + "\n" + between;
    return text + "}\n";
}

TEST(Copies, AreFoundBehindThePreprocessor) {
    const std::string own = shaderOf("");
    std::string macros = std::string(kHead) + kBlend, body = "void main() {";
    for (std::size_t i = 0; i < kLines.size(); ++i) {
        macros += "#define M" + std::to_string(i) + " " + kLines[i] + "\n";
        body += " M" + std::to_string(i);
    }
    std::string spliced = own;
    for (std::size_t at = spliced.find("color"); at != std::string::npos; at = spliced.find("color", at + 7))
        spliced.insert(at + 2, "\\\n");
    std::string hiddenNames = own;
    for (std::size_t at = hiddenNames.find("color"); at != std::string::npos;
         at = hiddenNames.find("color", at))
        hiddenNames.replace(at, 5, "C");
    for (const std::string& each : std::initializer_list<std::string>{
             shaderOf("#ifdef NEVER\n  return;\n#endif\n"),
             shaderOf("#if 0\n  return;\n#endif\n"),
             shaderOf("#if 0\n  discard;\n#endif\n"),
             shaderOf("#ifndef ALWAYS\n#else\n  return;\n#endif\n"),
             shaderOf("", "#if 0\n  return;\n#endif\n"),
             shaderOf("#if 0\n  if (false)\n#endif\n"),
             shaderOf("#if GL_NO_such_thing\n  return;\n#endif\n"),
             shaderOf("#ifdef GL_NV_gpu_shader5\n#else\n  return;\n#endif\n"),
             shaderOf("  if (false) {\n", "", "#define false true\n") + "}\n",
             shaderOf("  if (true) {\n") + "}\n",
             shaderOf("  while (true) {\n", "") + "}\n",
             shaderOf("", "  float junk = fract(vST.x);\n"),
             shaderOf("", "  hide();\n", "void hide() { float a = sin(1.); }\n"),
             shaderOf("", "  float x = hide(vST.x);\n", "float hide(float a) { a += 1.; return a * 2.; }\n"),
             shaderOf("", "  if (2 < 1) { f.x = 3.; }\n"),
             shaderOf("", "  { ; }\n"),
             shaderOf("", "",
                      "float junk(float a) { return sin(a) * cos(a) + tan(a) * exp(a) / log(a) - a; }\n"),
             macros + body + "}\n",
             "#define C color\n" + hiddenNames,
             spliced,
         })
        EXPECT_GE(similarity(own, each), .8) << each;
    const auto include = [&](std::string_view name, std::string_view) -> std::optional<glsl::IncludedFile> {
        const std::size_t line = static_cast<std::size_t>(name[0] - '0');
        return glsl::IncludedFile{std::string(name), kLines.at(line) + "\n"};
    };
    std::string included = std::string(kHead) + kBlend + "void main() {\n";
    for (std::size_t i = 0; i < kLines.size(); ++i)
        included += "#include \"" + std::to_string(i) + ".glsl\"\n";
    EXPECT_GE(similarity(own, included + "}\n", include), .8) << "each line in a file of its own";
}

struct SurroundedBy {
    const char* before;
    const char* after;
};

/// The same with functions written out, as for a student's own file.
double ownSimilarity(const std::string& a, const std::string& b, const std::set<std::uint64_t>& given = {}) {
    const InlineRule rule{.isOwn = [](const std::string&) { return true; }, .given = given};
    std::vector<std::vector<Fingerprint>> prints;
    for (const std::string& each : {a, b})
        prints.push_back(
            fingerprintsOf(reachedCode({glsl::Stage::fragment, "a.frag", each}, {}, rule).runs, {}));
    const std::vector<SimilarPair> pairs = similarPairs(prints);
    return pairs.empty() ? 0 : std::min(pairs[0].ofA, pairs[0].ofB);
}

TEST(Copies, AreFoundWithFunctionsWrittenOutAndStatementsInAnotherOrder) {
    const std::string own = shaderOf("");
    const std::string inlined =
        std::string(kHead) +
        "void main() {\n  float q = uAd / 2.;\n  int many = int(vST.s / uAd);\n"
        "  float middle = float(many) * uAd + q;\n  float far = (vST.s - middle) / q;\n"
        "  float x = clamp((far * far - (1. - uTol)) / (1. + uTol - (1. - uTol)), 0., 1.);\n"
        "  float k = (3. - 2. * x) * x * x;\n  vec3 paint = mix(vec3(1., .5, 0.), vec3(.2, .2, 1.), k);\n"
        "  f = vec4((.7 * max(dot(normalize(vN), vec3(0., 0., 1.)), 0.) + .3) * paint, 1.);\n}\n";
    EXPECT_GE(ownSimilarity(own, inlined), .7);
    std::string reordered = std::string(kHead) + "void main() {\n";
    for (const std::size_t line : {6U, 1U, 0U, 2U, 3U, 4U, 5U, 7U}) reordered += kLines[line] + "\n";
    reordered += "}\n";
    const std::string swapped = reordered + kBlend;
    EXPECT_EQ(ownSimilarity(own, std::string(kHead) + "float blend(float a, float b, float x);\n" +
                                     swapped.substr(std::string(kHead).size())),
              1);
    // What all have is not written out: it would differ by its arguments.
    const std::string other = std::string(kHead) + kBlend +
                              "void main() { f = vec4(blend(uAd, uBd, vN.x) + blend(0., 1., vST.t)); }\n";
    const ReachedCode given = codeOf("#version 330\n" + std::string(kBlend));
    const InlineRule rule{.isOwn = [](const std::string&) { return true; },
                          .given = {given.functions.begin(), given.functions.end()}};
    EXPECT_EQ(reachedCode({glsl::Stage::fragment, "a.frag", other}, {}, rule).runs.size(), 2U);
    EXPECT_EQ(reachedCode({glsl::Stage::fragment, "a.frag", other}, {}, {.isOwn = rule.isOwn}).runs.size(),
              1U);
}

TEST(Copies, AreFoundInStatementsThatRunOnce) {
    const std::string own = shaderOf("");
    const SurroundedBy kAround[] = {
        {"switch (0) { default:", "}"},
        {"switch (0) { default:", "break; }"},
        {"switch (0) { default: {", "break; } }"},
        {"switch (int(uAd)) { default:", "}"},
        {"switch (3) { case 1: f.x = 1.; break; case 3:", "break; case 4: f = vec4(2.); }"},
        {"switch (1 + 1) { case 2: case 3:", "}"},
        {"switch (2) { case 2: case 3: if (vST.s > 2.) break;", "}"},
        {"switch (int(uAd)) { case 77: discard; default:", "}"},
        {"do {", "} while (false);"},
        {"do {", "} while (1 > 2);"},
        {"do {", "break; } while (true);"},
        {"{ {", "} }"},
        {"while (true) {", "break; }"},
        {"for (;;) {", "break; }"},
        {"for (int k = 0; k < 1; ++k) {", "}"},
        {"for (int k = 1; k > 0; k--) {", "}"},
        {"for (int k = 2; k <= 2; k += 1) {", "}"},
        {"for (float k = 0.; k < 1.; k = k + 1.) {", "}"},
        {"if (vST.s > -9.) {", "}"},
        // conditions that another arithmetic decides otherwise
        {"if (2147483647 + 1 < 0) {", "}"},
        {"if (.1 + .2 == .3) {", "}"},
        {"if (16777216. + 1. == 16777216.) {", "}"},
        {"if (0u - 1u > 5u) {", "}"},
        {"if (-1u > 5u) {", "}"},
        {"if (.1lf != .1) {", "}"},
        {"if (!(1e-45 > 0.)) {", "}"},
        {"bool go = false; (go) = true; if (go) {", "}"},
        {"bool go = false; ((go)) = true; if (go) {", "}"},
        {"do { switch (0) { default: for (int k = 0; k < 1; ++k) { {", "} } } } while (false);"},
        {"switch (0) { default: switch (1) { case 1: do {", "} while (false); } }"},
    };
    for (const SurroundedBy& each : kAround) {
        EXPECT_GE(ownSimilarity(own, shaderOf(std::string(each.before) + "\n") + each.after + "}\n"), .8)
            << each.before;
        // Around each part, too, unless the condition stays.
        if (std::string(each.before).find("if (") != std::string::npos) continue;
        std::string parts = std::string(kHead) + kBlend + "void main() {\n";
        for (const std::string& line : kLines)
            parts += line.starts_with("vec3") || line.starts_with("f =")
                         ? std::string(each.before) + line + each.after + "\n"
                         : line + "\n";
        const bool isDecided = std::string(each.before).find("77") == std::string::npos;
        EXPECT_TRUE(!isDecided || ownSimilarity(own, parts) >= .8) << parts;
    }
}

TEST(Copies, AreFoundInConditionsThatActBesidesTheirValue) {
    const std::string own = shaderOf("");
    EXPECT_GE(ownSimilarity(own, shaderOf("bool go = false; start((go)); if (go) {\n", "",
                                          "void start(out bool b) { b = true; }\n") +
                                     "}\n"),
              .8);
    for (const char* each :
         {"if (g() && false) discard;", "if (g() || true) ;", "for (g(); false; ) discard;",
          "switch (int(g())) { default: }", "switch (int(g())) { }", "f *= g() || true ? 1. : 2.;"}) {
        std::string hidden = std::string(kHead) + kBlend + "bool g() {\n";
        for (const std::string& line : kLines) hidden += line + "\n";
        EXPECT_GE(ownSimilarity(own, hidden + "return true; }\nvoid main() { " + each + " }\n"), .7) << each;
    }
}

TEST(Copies, AreFoundWithVariablesOutsideOfFunctions) {
    const std::string own = shaderOf("");
    std::string statements, declared;
    for (std::string each : kLines) {
        for (const char* type : {"float ", "int ", "vec3 "})
            if (each.starts_with(type)) {
                each.erase(0, std::string(type).size());
                const std::size_t second = each.find("Br");
                declared += type + each.substr(0, each.find(' ')) + (second < each.size() ? ", Br" : "") +
                            (declared.empty() ? ";\n" : "; ");
                if (second < each.size()) each.replace(second - 2, 1, ";");
            }
        statements += each + "\n";
    }
    const std::string blend =
        "float t0;\nfloat blend(float a, float b, float x) { t0 = clamp((x - a) / (b - "
        "a), 0., 1.);\n  return t0 * t0 * (3. - 2. * t0);\n}\n";
    for (const std::string& each : {std::string(kBlend), blend})
        EXPECT_GE(ownSimilarity(own, kHead + declared + each + "void main() {\n" + statements + "}\n"), .8)
            << declared << each << statements;
    // Those that functions share, or that the task gives, stay.
    EXPECT_EQ(
        codeOf("#version 330\nout vec4 f;\nfloat a;\nvoid g() { a = f.x; }\nvoid main() { g(); f.y = a; "
               "}\n")
            .runs.size(),
        3U);
}

TEST(Copies, AreFoundBehindWordsThatSayHowExactlyIsComputed) {
    const std::string own = shaderOf("");
    for (const char* word : {"highp ", "mediump ", "lowp ", "precise ", "precise highp "}) {
        std::string statements;
        for (const std::string& each : kLines) {
            const bool declares =
                each.starts_with("float ") || each.starts_with("vec3 ") || each.starts_with("int ");
            statements += (declares ? word + each : each) + "\n";
        }
        const std::string other =
            kHead + std::string("precision highp float;\n") + kBlend + "void main() {\n" + statements + "}\n";
        EXPECT_GE(ownSimilarity(own, other), .9) << other;
    }
}

TEST(Copies, AreNotCodeThatNeverRuns) {
    const std::string own = shaderOf("");
    const std::string other =
        "#version 330\nin vec3 vN;\nout vec4 f;\nvoid main() { f = vec4(.5 + .5 * vN, 1.); }\n";
    std::string unused = std::string(kHead) + kBlend + "void never() {\n";
    for (const std::string& each : kLines) unused += each + "\n";
    EXPECT_EQ(similarity(own, unused + "}\n" + other.substr(other.find("void"))), 0);
}

TEST(ReachedCode, LinesAreThoseThatAReaderLooksFor) {
    const ReachedCode code = codeOf("#version 330\n#define BODY f = vec4(1.);\n\nvoid main() {\n  BODY\n}\n");
    ASSERT_EQ(code.runs.size(), 1U);
    std::vector<std::int32_t> lines;
    for (const SourceToken& each : code.runs[0].tokens) lines.push_back(each.line);
    std::ranges::sort(lines);
    EXPECT_EQ(lines.front(), 2) << "the text of a macro is where it is defined";
    EXPECT_EQ(lines.back(), 6);
    EXPECT_EQ(code.runs[0].path, "a.frag");
}

TEST(ReachedCode, EachFunctionThatIsReachedStandsAlone) {
    const std::string text =
        "#version 330\nout vec4 f;\nconst float k = 2.;\nvec4 a() { return vec4(1.); }\nvec4 b() { return "
        "vec4(2.); }\nvec4 c() { return k * vec4(3.); }\nconst float l = 3.;\nvoid main() { f = a() + c() * "
        "l; "
        "}\n";
    EXPECT_EQ(codeOf(text).runs.size(), 4U) << "a, c, main, and the constants together";
    EXPECT_EQ(codeOf(text).functions.size(), 4U) << "also of the one that is not reached";
    EXPECT_EQ(codeOf("#version 330\nfloat a() { return 1.; }\nfloat b() { return 2.; }\n").runs.size(), 2U)
        << "without a main all of them count";
}

TEST(ReachedCode, EndsInTimeForWhatIsNoCode) {
    for (const char* each :
         {"(", ")", "{", "}", "[", "+", "a=", "if(", "f(){", "if(1)", "a?", "while(0)", "else ", "do ", "do{",
          "switch(0){default:", "for(int i=0;i<1;++i){", "case 1:"}) {
        std::string text = "void main() {";
        for (int i = 0; i < 20'000; ++i) text += each;
        (void)codeOf(text);
    }
    const InlineRule all{.isOwn = [](const std::string&) { return true; }};
    const auto endsInTime = [&](const std::string& text) {
        return reachedCode({glsl::Stage::fragment, "a.frag", "#version 330\nout float o;\n" + text}, {}, all);
    };
    std::string twice = "float f0(float x) { return x + 1.; }\n", chain = twice, circle;
    for (int i = 1; i < 500; ++i) {
        const std::string name = std::to_string(i), last = "f" + std::to_string(i - 1);
        twice += "float f" + name + "(float x) { return " + last + "(x * 2.) + " + last + "(x); }\n";
        chain += "float f" + name + "(float x) { float y = x; y += " + last + "(y); return y; }\n";
        circle += "float f" + name + "(float x) { return f" + std::to_string((i + 1) % 500) + "(x); }\n";
    }
    for (const std::string& each : {twice, chain, circle}) {
        std::size_t tokens = 0;
        for (const SourceFile& run : endsInTime(each + "void main() { o = f499(o); }\n").runs)
            tokens += run.tokens.size();
        EXPECT_LT(tokens, 200'000U);
    }
    std::string calls = "float f(float x) { float y = x * x; return y * y; }\nvoid main() { o = ", ends;
    for (int i = 0; i < 10'000; ++i) {
        calls += "f(";
        ends += ")";
    }
    (void)endsInTime(calls + "1." + ends + "; }\n");
}

}  // namespace
}  // namespace glibra::classroom
