// Directives, macros and their mistakes (language, 7.11).

#include <gtest/gtest.h>

#include "preprocessed.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

std::string joined(const Tokens& tokens) {
    std::string text;
    for (const std::string& each : tokens) text += (text.empty() ? "" : " ") + each;
    return text;
}

/// The tokens of a text without #version.
std::string of(const std::string& text) {
    const Preprocessed result = preprocessed(text);
    return result.ids.empty() ? joined(result.tokens) : result.ids;
}

TEST(Macros, NoTwoTokensGrowTogether) {
    // preprocessed() reads its own output again and compares.
    static constexpr const char* kTokens[] = {"+",  "-",  "++",  "--", "&",   "&&", "|", "||", "<", "<<", ">",
                                              ">>", "=",  "==",  "!",  "/",   "*",  "%", "^",  ".", "a",  "1",
                                              "1.", ".5", "1e3", "-1", "0x1", "+=", "(", "~",  ",", "_b"};
    for (const std::string left : kTokens)
        for (const std::string right : kTokens) {
            const std::string apart = left == "/" ? " /**/" : "/**/";
            const std::string expected =
                (left == "-1" ? "- 1" : left) + std::string(" ") + (right == "-1" ? "- 1" : right);
            EXPECT_EQ(expected, of("#define L " + left + "\n#define R " + right + "\nL R"));
            EXPECT_EQ(expected, of("#define L " + left + "\nL/**/" + right));
            EXPECT_EQ(expected, of("#define R " + right + "\n" + left + apart + "R"));
            EXPECT_EQ(expected, of("#define BOTH " + left + apart + right + "\nBOTH"));
            if (left == "," || right == "," || left == "(" || right == "(") continue;
            EXPECT_EQ(expected, of("#define F(x,y) x/**/y\nF(" + left + "," + right + ")"));
            EXPECT_EQ(expected, of("#define I(x) x\nI(" + left + ")I(" + right + ")"));
        }
}

TEST(Macros, ArgumentsOfAllKinds) {
    const std::string two = "#define F(a, b) [a|b]\n#define NONE() none\n#define ONE(x) <x>\n";
    EXPECT_EQ("[ 1 | 2 ]", of(two + "F(1, 2)"));
    EXPECT_EQ("[ | ]", of(two + "F(,)"));
    EXPECT_EQ("[ ( 1 , 2 ) | 3 ]", of(two + "F((1, 2), 3)"));
    EXPECT_EQ("[ a [ 1 | 2 ] ]", of(two + "F(a[1, 2])"));  // only parentheses hold a comma
    EXPECT_EQ("none none", of(two + "NONE() NONE ( )"));
    EXPECT_EQ("< >", of(two + "ONE()"));
    EXPECT_EQ("F + ONE", of(two + "F + ONE"));
    EXPECT_EQ("[ [ 1 | 2 ] | < 3 > ]", of(two + "F(F(1, 2), ONE(3))"));
    EXPECT_EQ("[ 1 | 2 ] x", of(two + "F\n  // comment ) (\n(\n1 /* , */\n,\n2\n) x"));
    EXPECT_EQ("[ 1 | 2 ] ;", of(two + "F(1,\n#if 1\n2\n#else\n3, 4\n#endif\n);"));
}

TEST(Macros, AreReadAgainWithWhatFollows) {
    EXPECT_EQ("< 3 >", of("#define G(x) <x>\n#define F G\nF(3)"));
    EXPECT_EQ("f ( 2 * f ( 2 * y ) )", of("#define f(a) f(2 * a)\nf(f(y))"));
    EXPECT_EQ("A B", of("#define A B\n#define B A\nA B"));
    EXPECT_EQ("x + x", of("#define x x\nx + x"));
    EXPECT_EQ("2 * 9 * g", of("#define f(a) a*g\n#define g(a) f(a)\nf(2)(9)"));
}

TEST(Macros, PasteTokens) {
    EXPECT_EQ("ab", of("#version 330\n#define P(x, y) x ## y\nP(a, b)"));
    EXPECT_EQ("a3 3b 33", of("#version 330\n#define P(x, y) x##y\nP(a, 3) P(3, b) P(3, 3)"));
    EXPECT_EQ("a b ;", of("#version 330\n#define P(x, y) x##y\nP(a,) P(,b) P(,);"));
    EXPECT_EQ("<<= x", of("#version 330\n#define P(x, y) x##y\nP(<<, =) x"));
    EXPECT_EQ("A1 one", of("#version 330\n#define N 1\n#define A1 one\n#define P(x, y) x##y\n#define Q(x, y) "
                           "P(x, y)\n#undef A1\nP(A, 1)\n#define A1 one\nQ(A, N)"));
    EXPECT_EQ("AN", of("#version 330\n#define N 1\n#define P(x, y) x##y\nP(A, N)"));
    EXPECT_EQ("glsl-E15", of("#version 330\n#define P(x, y) x##y\nP(+, a)"));
    EXPECT_EQ("glsl-E15", of("#version 330\n#define P(x, y) x##y\nP(/, /)"));
    EXPECT_EQ("glsl-E14", of("#version 330\n#define P(x) x##\n"));
    EXPECT_EQ("glsl-E14", of("#version 330\n#define P(x) ## x\n"));
    for (const char* version : {"100", "110", "120", "300 es"})
        EXPECT_EQ("glsl-W25", of(std::string("#version ") + version + "\n#define P(x, y) x##y\nP(a, b)"));
}

TEST(Macros, AreDefinedOnceOrAlike) {
    EXPECT_EQ("1", of("#define A 1\n#define A 1\nA"));
    EXPECT_EQ("1 + 2", of("#define A 1 + 2\n#define A   1/**/+\t2 // same\nA"));
    EXPECT_EQ("2", of("#define A 1\n#undef A\n#undef A\n#define A 2\nA"));
    for (const char* second : {"A 2", "A", "A 1 1", "A() 1", "A(x) 1"})
        EXPECT_EQ("glsl-E14", of(std::string("#define A 1\n#define ") + second + "\n")) << second;
    EXPECT_EQ("glsl-E14", of("#define F(x) x\n#define F(y) y\n"));
}

TEST(Conditions, UnknownNamesCountAsZeroButInEs) {
    EXPECT_EQ("glsl-W24", of("#version 330\n#if SHADOWS\n#endif\n"));
    EXPECT_EQ("glsl-E14", of("#version 300 es\n#if SHADOWS\n#endif\n"));
    EXPECT_EQ("glsl-E14", of("#version 100\n#if !SHADOWS\n#endif\n"));
    for (const char* version : {"100", "120", "330", "320 es"})
        for (const char* condition :
             {"defined(SHADOWS) && SHADOWS > 1", "1 || SHADOWS", "0 && (SHADOWS + 1 / 0)"})
            EXPECT_EQ("", of(std::string("#version ") + version + "\n#if " + condition + "\n#endif\n"))
                << condition;
    EXPECT_EQ("", of("#version 330\n#if GL_EXT_no_such || 0\n#endif\n"));
}

TEST(Conditions, OnlyNeededOnesAreRead) {
    EXPECT_EQ("a", of("#if 1\na\n#elif 1 / 0\nb\n#elif (\nc\n#else\nd\n#endif"));
    EXPECT_EQ("d", of("#if 0\n#if (\n#elif )\n#else junk\n#endif\n#unknown\n#define\n#else\nd\n#endif"));
    EXPECT_EQ("ok", of("#define D defined\n#if !D(X) && !D X\nok\n#endif"));
}

TEST(Directives, MistakesAreReportedAtTheirPlace) {
    struct Case {
        const char* text;
        const char* message;
    };
    for (const Case& each : {
             Case{"x\n#if\n#endif\n", "a.frag:2:2: error: #if: the condition is missing [glsl-E14]"},
             Case{"#if 1 +\n#endif\n", "a.frag:1:7: error: #if: a value is missing at the end [glsl-E14]"},
             Case{"#if (1\n#endif\n", "a.frag:1:6: error: #if: a ')' is missing [glsl-E14]"},
             Case{"#if 1)\n#endif\n", "a.frag:1:6: error: #if: a ')' has no '(' [glsl-E14]"},
             Case{"#if 1 2\n#endif\n", "a.frag:1:7: error: #if: expected an operator before '2' [glsl-E14]"},
             Case{"#if 1.5\n#endif\n", "a.frag:1:5: error: #if: '1.5' is no whole number [glsl-E14]"},
             Case{"#if 0\n#elif 1 / 0\n#endif\n", "a.frag:2:11: error: #elif: division by 0 [glsl-E14]"},
             Case{"#if defined\n#endif\n",
                  "a.frag:1:1: error: #if: expected 'defined NAME' or 'defined(NAME)' [glsl-E14]"},
             Case{"#if 1\n\n", "a.frag:1:1: error: this branch has no '#endif' [glsl-E14]"},
             Case{"x\n  #endif\n", "a.frag:2:3: error: '#endif' without '#if' [glsl-E14]"},
             Case{"#else\n", "a.frag:1:1: error: '#else' without '#if' [glsl-E14]"},
             Case{"#if 1\n#else\n#elif 1\n#endif\n", "a.frag:3:1: error: '#elif' after '#else' [glsl-E14]"},
             Case{"#ifdef\n#endif\n", "a.frag:1:2: error: expected a name after '#ifdef' [glsl-E14]"},
             Case{"#define 3\n", "a.frag:1:9: error: expected a name after '#define' [glsl-E14]"},
             Case{"#define F(3) 1\n",
                  "a.frag:1:11: error: expected the name of a parameter, found '3' [glsl-E14]"},
             Case{"#define F(a, a) a\n", "a.frag:1:14: error: two parameters have the name 'a' [glsl-E14]"},
             Case{"#define F(a b) a\n",
                  "a.frag:1:13: error: expected ',' or ')' after the parameter 'a' [glsl-E14]"},
             Case{"#define A 1\n\n#define A 2\n",
                  "a.frag:3:9: error: 'A' is already defined with another text in line 1; write '#undef A' "
                  "first "
                  "[glsl-E14]"},
             Case{"#elsif\n",
                  "a.frag:1:2: error: there is no directive '#elsif'; did you mean '#elif'? [glsl-E14]"},
             Case{"#line x\n",
                  "a.frag:1:1: error: expected '#line NUMBER' or '#line NUMBER NUMBER' [glsl-E14]"},
             Case{"x # y\n",
                  "a.frag:1:3: error: '#' stands only at the start of a directive's line [glsl-E14]"},
             Case{"#define H #\nH version 120\n",
                  "a.frag:2:1: error: '#' stands only at the start of a directive's line [glsl-E14]"},
             Case{"#define F(a, b) a\n  F(1)\n",
                  "a.frag:2:3: error: macro 'F' takes 2 arguments, found 1 [glsl-E15]"},
             Case{"#define F(a) a\nF(1, 2)\n",
                  "a.frag:2:1: error: macro 'F' takes 1 argument, found 2 [glsl-E15]"},
             Case{"#define F() a\nF(1)\n",
                  "a.frag:2:1: error: macro 'F' takes 0 arguments, found 1 [glsl-E15]"},
             Case{"#define F(a) a\n\n F(1, (2)\n\n",
                  "a.frag:3:2: error: the call of the macro 'F' has no closing ')' [glsl-E15]"},
             Case{"a /* b\n c *\n",
                  "a.frag:1:3: error: this comment has no end; write '*/' after it [glsl-E16]"},
             Case{"/*/\n", "a.frag:1:1: error: this comment has no end; write '*/' after it [glsl-E16]"},
         }) {
        const Preprocessed found = preprocessed(each.text);
        ASSERT_FALSE(found.messages.empty()) << each.text;
        EXPECT_EQ(each.message, toString(found.messages.front())) << each.text;
        EXPECT_EQ(8U, found.ids.size()) << each.text << found.ids;  // one message
    }
}

TEST(Lines, BackslashesJoinThemEverywhere) {
    EXPECT_EQ("++ abc 12.5 <<= x", of("+\\\n+ a\\\nb\\\nc 1\\\n2.\\\n5 <\\\n<\\\n= /\\\n* gone *\\\n/ x"));
    EXPECT_EQ("1", of("#def\\\nine A \\\n  1\nA"));
    EXPECT_EQ("< 1 >", of("#define F\\\n(x) \\\n <x>\nF(1)"));
    EXPECT_EQ("x", of("/\\\n/ comment\nx"));
}

TEST(Lines, CommentsGoOnFrom420) {
    const auto text = [](const std::string& version) {
        return "#version " + version + "\n// comment \\\na\nb\n__LINE__\n";
    };
    for (const char* version : {"110", "120", "330", "410", "100"})
        EXPECT_EQ("a b 5", joined(preprocessed(text(version)).tokens)) << version;
    for (const char* version : {"420", "430", "460 core", "300 es", "320 es"}) {
        EXPECT_EQ("b 5", joined(preprocessed(text(version)).tokens)) << version;
        EXPECT_EQ(glslangTokens(text(version)), preprocessed(text(version)).tokens) << version;
        EXPECT_EQ("glsl-W26", preprocessed(text(version)).ids) << version;
    }
    EXPECT_EQ("1 1", of("#version 420\n/* a \\\n b */ 1\n#define A 1 /* \\\n */\nA"));
}

TEST(Lines, EveryKindOfEndCountsOnce) {
    for (const char* end : {"\n", "\r\n", "\r", "\n\r"}) {
        std::string text;
        for (const char* line :
             {"__LINE__", "#if 0", "x", "#else", "__LINE__ /* a", "b */ __LINE__", "#endif", "__LINE__"})
            text += std::string(line) + end;
        EXPECT_EQ("1 5 6 8", of(text));
    }
}

TEST(Lines, OddBytesDoNoHarm) {
    for (int byte = 0; byte < 256; ++byte) {
        std::string text = "a // ";
        text += static_cast<char>(byte);
        text += "\n#define F(x) <x>\nF(";
        text += static_cast<char>(byte);
        text += ") b\n";
        const Preprocessed found = preprocessed(text);
        ASSERT_GE(found.tokens.size() + found.messages.size(), 2U) << byte;
    }
}

TEST(Expansion, IsBounded) {
    std::string doubling = "#version 330\n#define A0 x x\n";
    for (int i = 1; i < 40; ++i)
        doubling += "#define A" + std::to_string(i) + " A" + std::to_string(i - 1) + " A" +
                    std::to_string(i - 1) + "\n";
    EXPECT_EQ("glsl-E11", preprocessed(doubling + "A39\n").ids);
    std::string emptying = "#version 330\n#define E0\n";
    for (int i = 1; i < 40; ++i)
        emptying += "#define E" + std::to_string(i) + " E" + std::to_string(i - 1) + " E" +
                    std::to_string(i - 1) + "\n";
    EXPECT_EQ("glsl-E11", preprocessed(emptying + "E39\n").ids);
    EXPECT_NE(std::string::npos, preprocessed(doubling + "#if A39\n#endif\n").ids.find("glsl-E11"));
    std::string nested = "1";
    std::string deep = "F(";
    for (int i = 0; i < 150; ++i) nested = "F(" + nested + ")";
    EXPECT_EQ("1", of("#define F(x) x\n" + nested));
    for (int i = 0; i < 100; ++i) nested = "F(" + nested + ")";
    EXPECT_EQ("glsl-E15", of("#define F(x) x\n" + nested));
    for (int i = 0; i < 13; ++i) deep += deep;
    EXPECT_EQ("glsl-E15", of("#define F(x) x\n" + deep));
    std::string chain = "#define C0 end\n";
    for (int i = 1; i < 20'000; ++i)
        chain += "#define C" + std::to_string(i) + " C" + std::to_string(i - 1) + "\n";
    EXPECT_EQ("end", of(chain + "C19999"));
}

}  // namespace
}  // namespace glibra::glsl::test
