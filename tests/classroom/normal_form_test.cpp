// What hides a copy does not hide it: dead statements, swapped operands, constants in another form.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "classroom/classroom.h"
#include "classroom/tokens.h"

namespace glibra::classroom {
namespace {

std::vector<std::uint32_t> normalCodes(const std::string& text) {
    std::vector<std::uint32_t> codes;
    for (const SourceToken& each : comparableTokens(text)) codes.push_back(each.code);
    return codes;
}

/// The body of a function that reads a and b and writes the global o.
std::string body(const std::string& statements) {
    return "float count; float helper(float x) { count += x; return x; }\nvoid main() { float a = sin(o), b "
           "= cos(o);\n" +
           statements + "\n}\n";
}

struct SamePair {
    const char* one;
    const char* other;
};

TEST(NormalForm, EvasionsDoNotCount) {
    const SamePair kPairs[] = {
        // dead statements
        {"o = a * b;", "float u = 3., v = a; o = a * b;"},
        {"o = a * b;", "float unused = 3.; o = a * b;"},
        {"o = a * b;", "float u = 3.; u = u * 2. + a; u += 1.; o = a * b;"},
        {"o = a * b;", "float u = a; float v = u * 2.; float w = v + u; o = a * b;"},
        {"o = a * b;", "a = a; ; a + b; o = a * b;"},
        {"o = a * b;", "if (false) { o = 7.; } o = a * b;"},
        {"o = a * b; return;", "o = a * b; return; o = 3.; { o = 4.; }"},
        {"if (a > b) { discard; } o = b;", "if (a > b) { discard; o = a; } o = b;"},
        {"o = a * b;", "vec3 u; u.x = a; o = a * b;"},
        // order and form of operands
        {"o = a * sin(b) + b;", "o = b + sin(b) * a;"},
        {"o = a + b - sin(a);", "o = b - sin(a) + a;"},
        {"o = a * sin(b) / cos(a);", "o = sin(b) / cos(a) * a;"},
        {"o = sin(a * cos(b) + 2.);", "o = sin(2. + cos(b) * a);"},
        {"o += a * sin(b);", "o = o + sin(b) * a;"},
        {"o *= a + sin(b);", "o = (sin(b) + a) * o;"},
        {"o = (a) * (b);", "o = a * b;"},
        // parentheses
        {"o = (a + sin(b)) + (b - 2. * a);", "o = a + sin(b) + b - 2. * a;"},
        {"o = a - (b - sin(a));", "o = a - b + sin(a);"},
        {"o = (a * sin(b)) / (cos(a));", "o = a * sin(b) / cos(a);"},
        {"o = (a > b ? sin(a) : b);", "o = a > b ? sin(a) : b;"},
        // names for values that are used once, and declarations
        {"o = a * b;", "float u = a; o = u * b;"},
        {"o = sin(a * b) + cos(b);", "float u = a * b; float v = cos(b); o = sin(u) + v;"},
        {"float u = sin(a), v = cos(b); o = u * u + v * v;",
         "float u = sin(a); float v = cos(b); o = u * u + v * v;"},
        {"float u = sin(a); o = u * u;", "float u; u = sin(a); o = u * u;"},
        {"float u = sin(a), v = cos(b); o = u * u - v * v;",
         "float v = 0., u; u = sin(a); v = cos(b); o = u * u - v * v;"},
        {"float u = sin(a); o = u * u;", "const float u = sin(a); o = u * u;"},
        // order of statements
        {"float u = sin(a); float v = cos(b); o = u * u - v * v;",
         "float v = cos(b); float u = sin(a); o = u * u - v * v;"},
        {"float u = sin(a); float v = sin(b); o = u * u - v * v * a;",
         "float w = sin(b); float k = sin(a); o = k * k - w * w * a;"},
        {"if (a > b) { float u = sin(a); float v = cos(a); o = u * u - v * v; }",
         "if (a > b) { float v = cos(a); float u = sin(a); o = u * u - v * v; }"},
        {"float u = sin(a); u *= 2.; float v = cos(b); o = u * u - v * v; return;",
         "float v = cos(b); float u = sin(a); u *= 2.; o = u * u - v * v; return;"},
        // branches that choose a value
        {"o = a > b ? sin(a) : cos(b);", "if (a > b) o = sin(a); else { o = cos(b); }"},
        {"o = a > b ? sin(a) : o * b;", "if (a > b) o = sin(a); else o *= b;"},
        {"o = a > b ? o - (b - a) : o / (b + a);", "if (a > b) o -= b - a; else { o /= b + a; }"},
        {"o = a > b ? o + a : a > o ? o - b : b;", "if (a > b) o += a; else if (a > o) o -= b; else o = b;"},
        {"o = o / (a + sin(b));", "o /= sin(b) + a;"},
        {"float u = a > b ? a : a > o ? b : o; o = u * u;",
         "float u; if (a > b) u = a; else if (a > o) { u = b; } else u = o; o = u * u;"},
        // constants
        {"o = a * 6.;", "o = 2. * a * 3.;"},
        {"o = a / 2.;", "o = .5 * a;"},
        {"o = a;", "o = 1. * a + 0.;"},
        {"o = a - 0. + sin(b);", "o = sin(b) / 1. + a;"},
        {"o = a + 3.;", "o = 1. + a + 2.;"},
        {"o = smoothstep(.2, .5, a);", "o = smoothstep(.1 + .1, 1. / 2., a);"},
    };
    for (const SamePair& each : kPairs)
        EXPECT_EQ(normalCodes(body(each.one)), normalCodes(body(each.other)))
            << each.one << " | " << each.other;
}

TEST(NormalForm, HoweverMuchOfItThereIs) {
    std::string chain = "float u0 = a;", sides = "o = a * b;", deep = "o = a * b;";
    for (int i = 1; i < 100; ++i)
        chain += "float u" + std::to_string(i) + " = u" + std::to_string(i - 1) + ";";
    for (int i = 0; i < 30; ++i) sides = "o = true ? o : cos(b);" + sides;
    for (int i = 0; i < 30; ++i) deep = "if (true) { if (false) o = b; " + deep + " }";
    const std::string plain = "o = a * b;";
    EXPECT_EQ(normalCodes(body(plain)), normalCodes(body(chain + plain)));
    EXPECT_EQ(normalCodes(body(plain)), normalCodes(body(sides)));
    EXPECT_EQ(normalCodes(body(plain)), normalCodes(body(deep)));
    const std::string never = "if (" + std::string(200, '(') + "false" + std::string(200, ')') + ") o = b;";
    EXPECT_EQ(normalCodes(body(plain)), normalCodes(body(never + plain)));
    // One that nobody writes is only read to its end.
    EXPECT_FALSE(normalCodes(body("if (" + std::string(1'000'000, '!') + "true) o = b;" + plain)).empty());
}

TEST(NormalForm, WhatHasAnEffectStays) {
    const SamePair kPairs[] = {
        {"o = a * b;", "o = a + b;"},
        {"o = a - sin(b);", "o = sin(b) - a;"},
        {"o = a / sin(b);", "o = sin(b) / a;"},
        {"o = a * b;", "helper(a); o = a * b;"},
        {"o = a * b;", "float u = helper(a); o = a * b;"},
        {"o = a * b;", "float u = a; u += b; o = u * b;"},
        {"float u = a; a = b; o = u * b;", "a = b; o = a * b;"},
        {"float u = a * b; if (b > o) { a = 2.; o = u; }", "if (b > o) { a = 2.; o = a * b; }"},
        {"float u = sin(a); float v = sin(b); o = u * u - v * v * a;",
         "float u = sin(a); o = u * u; float v = sin(b); o = v * v * a;"},
        {"o = sin(a); a = b; b = cos(o);", "a = b; o = sin(a); b = cos(o);"},
        {"float u = sin(a); o = u * u; u = cos(a); o = u * u - o;",
         "float u = cos(a); o = u * u; o = u * u - o;"},
        {"if (a > b) o = a; else b = o;", "o = a > b ? a : o;"},
        {"if (a > b) o = a; else o += a;", "o = a > b ? a : a;"},
        {"o = cos(a); return; ", "return; o = cos(a);"},
        {"o = a - (b - sin(a));", "o = a - b - sin(a);"},
        {"o = a * (b + sin(a));", "o = a * b + sin(a);"},
        {"o = a * b;", "EmitVertex(); o = a * b;"},
        {"if (a > b) o = a; o = b;", "if (a > b) ; o = b;"},
        {"if (a > b) return; o = b;", "if (a > b) return;"},
        {"o = a * 2.;", "o = a;"},
        {"o = a * 0.;", "o = a;"},
        {"switch (1) { case 1: o = a; break; default: o = b; }",
         "switch (1) { case 1: break; default: o = b; }"},
    };
    for (const SamePair& each : kPairs)
        EXPECT_NE(normalCodes(body(each.one)), normalCodes(body(each.other)))
            << each.one << " | " << each.other;
}

TEST(NormalForm, EndsInTimeForWhatIsNoCode) {
    for (const char* each : {"(", ")", "{", "}", "[", "+", "*", "a=", "if(", "f(){", "+=", "case ", "-",
                             "#define x (", "float u=a;o=u;", "float a,", "if(a){"}) {
        std::string text = "void main() {";
        for (int i = 0; i < 100'000; ++i) text += each;
        (void)comparableTokens(text);
    }
    std::string sum = "void main() { o = a";
    for (int i = 0; i < 100'000; ++i) sum += "+b*a";
    EXPECT_GT(comparableTokens(sum + "; }").size(), 100'000U);
    const std::string open(100'000, '('), close(100'000, ')');
    (void)comparableTokens("void main() { o = " + open + "a" + close + "; }");
}

TEST(NormalForm, ACopyWithDeadStatementsBetweenItsOwnIsWhollySimilar) {
    const char* kOriginal =
        "void main() {\n  vec2 st = vST * 2.;\n  float d = length(st - vec2(.5));\n  float e = "
        "smoothstep(.2, .3, d);\n"
        "  vec3 c = mix(vec3(1., .5, 0.), vec3(1.), e);\n  c *= .2 + .8 * abs(normalize(vN).z);\n"
        "  if (d > .9) discard;\n  float g = pow(max(dot(c, vec3(.3, .6, .1)), 0.), 2.2);\n"
        "  f = vec4(mix(c, vec3(g), uGrey), 1.);\n}\n";
    std::string evaded;
    int line = 0;
    for (const char* at = kOriginal; *at; ++at) {
        evaded += *at;
        if (*at == ';')
            evaded += " float junk" + std::to_string(line++) + " = fract(vST.x * 7.) + cos(vST.y);";
    }
    std::vector<std::vector<Fingerprint>> prints;
    for (const std::string& each : {std::string(kOriginal), evaded})
        prints.push_back(fingerprintsOf(std::vector<SourceFile>{{"a.frag", comparableTokens(each)}}, {}));
    const std::vector<SimilarPair> pairs = similarPairs(prints);
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_EQ(pairs[0].ofA, 1);
    EXPECT_EQ(pairs[0].ofB, 1);
}

/// Code whose tokens are all different, so that only copies are similar.
SourceFile ownCode(std::uint32_t seed, std::size_t tokens) {
    SourceFile file{"own" + std::to_string(seed) + ".frag", {}};
    for (std::size_t i = 0; i < tokens; ++i)
        file.tokens.push_back({seed * 100'000 + static_cast<std::uint32_t>(i), static_cast<std::int32_t>(i)});
    return file;
}

TEST(CommonCode, ALectureFunctionMarksNobodyButACopyIsFound) {
    // 27 of a class; 21 have the function of a lecture, and two of these have copied from each other.
    Classroom room;
    for (std::uint32_t i = 0; i < 27; ++i) {
        Entry& entry = room.entries.emplace_back();
        entry.submission.name = "s" + std::to_string(i);
        SourceFile file = ownCode(i == 5 ? 4 : i + 1, 100);
        if (i < 21) {
            const SourceFile lecture = ownCode(999, 120);
            file.tokens.insert(file.tokens.end(), lecture.tokens.begin(), lecture.tokens.end());
        }
        file.path = "x" + std::to_string(i) + ".frag";
        entry.files.push_back(file);
    }
    room.entries[3].files[0].tokens = room.entries[5].files[0].tokens;
    Classroom all = room;
    compareSources(room, {}, 0);
    ASSERT_EQ(room.pairs.size(), 1U);
    EXPECT_EQ(room.pairs[0].a, 3U);
    EXPECT_EQ(room.pairs[0].b, 5U);
    EXPECT_GT(room.commonFingerprints, 10U);
    EXPECT_EQ(room.common, 9U);
    compareSources(all, {}, 1'000);
    EXPECT_EQ(all.pairs.size(), 210U) << "each pair of the 21";
}

TEST(CommonCode, SmallClassesHaveNone) {
    EXPECT_EQ(usualCommon(2), 4U);
    EXPECT_EQ(usualCommon(27), 9U);
    EXPECT_EQ(usualCommon(500), 10U);
}

}  // namespace
}  // namespace glibra::classroom
