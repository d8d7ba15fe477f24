#include "source/syntax.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace glibra::source::test {
namespace {

/// The pieces that are not plain, as text: "keyword:in type:vec3".
std::string shown(std::string_view line, CodeLanguage language, bool& inComment) {
    constexpr std::array<const char*, 7> kNames{"plain",   "keyword",   "type",   "number",
                                                "comment", "directive", "builtin"};
    std::string all;
    for (const SyntaxPiece& each : syntaxOf(line, language, inComment))
        all += (all.empty() ? "" : " ") + std::string(kNames.at(static_cast<std::size_t>(each.kind))) + ":" +
               std::string(line.substr(each.begin, each.end - each.begin));
    return all;
}

std::string shown(std::string_view line, CodeLanguage language = CodeLanguage::glsl) {
    bool inComment = false;
    return shown(line, language, inComment);
}

TEST(Syntax, KnowsTheWordsOfShaders) {
    EXPECT_EQ(shown("  uniform vec3 uColor2; // the colour of vec3"),
              "keyword:uniform type:vec3 comment:// the colour of vec3");
    EXPECT_EQ(shown("#version 330 core // old"), "directive:#version 330 core  comment:// old");
    EXPECT_EQ(shown("float x1 = .5*gl_Vertex.x + 1e3 - 0x1Fu; vector v"),
              "type:float number:.5 builtin:gl_Vertex number:1e3 number:0x1Fu");
    EXPECT_EQ(shown("sampler2D a; samplerCube b; mat4x3 c; material d;"),
              "type:sampler2D type:samplerCube type:mat4x3");
    EXPECT_EQ(shown(""), "");
}

TEST(Syntax, FollowsCommentsOverLines) {
    bool inComment = false;
    EXPECT_EQ(shown("int a; /* one", CodeLanguage::glsl, inComment), "type:int comment:/* one");
    EXPECT_TRUE(inComment);
    EXPECT_EQ(shown("int b;", CodeLanguage::glsl, inComment), "comment:int b;");
    EXPECT_EQ(shown("two */ int c; /* three */ int", CodeLanguage::glsl, inComment),
              "comment:two */ type:int comment:/* three */ type:int");
    EXPECT_FALSE(inComment);
    EXPECT_EQ(shown("/*/ still open", CodeLanguage::glsl, inComment), "comment:/*/ still open");
    EXPECT_TRUE(inComment);
}

TEST(Syntax, KnowsTheCommandsOfScenes) {
    EXPECT_EQ(shown("Sphere 1. -2 # a Sphere", CodeLanguage::glib),
              "keyword:Sphere number:1. number:-2 comment:# a Sphere");
    EXPECT_EQ(shown("  uKd <0. .5 1.>", CodeLanguage::glib), "number:0. number:.5 number:1.");
    EXPECT_EQ(shown("Vertex Sphere.vert", CodeLanguage::glib), "keyword:Vertex");
}

TEST(Syntax, ReadsShadersInScenesAsShaders) {
    SyntaxReader reader(CodeLanguage::glib);
    const auto kinds = [&](std::string_view line) {
        std::string all;
        for (const SyntaxPiece& each : reader.next(line))
            all += (all.empty() ? "" : " ") + std::string(line.substr(each.begin, each.end - each.begin));
        return all;
    };
    EXPECT_EQ(kinds("Sphere 1 float"), "Sphere 1");
    EXPECT_EQ(kinds("  Fragment  inline  # a shader"), "Fragment # a shader");
    EXPECT_EQ(kinds("#version 330"), "#version 330");
    EXPECT_EQ(kinds("uniform float uA; /* Sphere"), "uniform float /* Sphere");
    EXPECT_EQ(kinds("Sphere */ void"), "Sphere */ void");
    EXPECT_EQ(kinds("EndVertex"), "") << "the end of another stage is no end";
    EXPECT_EQ(kinds("/* open"), "/* open");
    EXPECT_EQ(kinds("EndFragment"), "EndFragment");
    EXPECT_EQ(kinds("Sphere 2 uniform"), "Sphere 2") << "no comment stays open after the shader";
    EXPECT_EQ(kinds("Fragment inline.frag"), "Fragment") << "a file begins no shader";
    EXPECT_EQ(kinds("Torus .5 1 9 9"), "Torus .5 1 9 9");
}

}  // namespace
}  // namespace glibra::source::test
