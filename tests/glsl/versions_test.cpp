// Versions, extensions and supplied names (language, 7.2 and 7.3).

#include <gtest/gtest.h>

#include "support.h"

namespace glibra::glsl::test {
namespace {

constexpr const char* kBody = "void main() { gl_Position = vec4(0.); }\n";

Diagnostics versionMessages(const std::string& firstLine) {
    return translateSingle(Stage::vertex, firstLine + "\n" + kBody).diagnostics;
}

std::string firstLineOf(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

TEST(Version, EveryKnownVersionAndProfileIsSilent) {
    for (const char* version :
         {"110", "120", "130", "140", "150", "330", "400", "410", "420", "430", "440", "450"})
        for (const char* profile : {"", " core", " compatibility"})
            EXPECT_EQ("", ids(versionMessages("#version " + std::string(version) + profile)))
                << version << profile;
}

TEST(Version, TargetVersionIsEmittedAsCore) {
    EXPECT_EQ("#version 450 core",
              firstLineOf(sourceOf(translateSingle(Stage::vertex, kBody), Stage::vertex)));
    ProgramRequest request = single(Stage::vertex, std::string("#version 120\n") + kBody);
    request.target.version = 410;
    EXPECT_EQ("#version 410 core", firstLineOf(sourceOf(translate(request), Stage::vertex)));
}

TEST(Version, MissingVersionIsReported) {
    const TranslatedProgram translated = translate(program({{Stage::vertex, kBody}}));
    EXPECT_EQ("glsl-W01", ids(translated.diagnostics));
    EXPECT_EQ("no #version, treated as 330 compatibility", textOf(translated.diagnostics, "glsl-W01"));
}

TEST(Version, DotIsIgnored) {
    EXPECT_EQ("'#version 4.00' read as 400", textOf(versionMessages("#version 4.00"), "glsl-W02"));
    EXPECT_EQ("'#version 3.30 compatibility' read as 330 compatibility",
              textOf(versionMessages("#version 3.30 compatibility"), "glsl-W02"));
    EXPECT_EQ("'#version 4.3' read as 430", textOf(versionMessages("#version 4.3"), "glsl-W02"));
}

TEST(Version, UnknownNumberTakesTheNextLowerOne) {
    EXPECT_EQ("'#version 200' read as 150", textOf(versionMessages("#version 200"), "glsl-W02"));
    EXPECT_EQ("'#version 455' read as 450", textOf(versionMessages("#version 455"), "glsl-W02"));
}

TEST(Version, TooHighIsRefused) {
    EXPECT_EQ("#version 470 is not supported, 460 is the highest",
              textOf(versionMessages("#version 470"), "glsl-E07"));
}

TEST(Version, FourSixtyIsCompiledAsTheTarget) {
    EXPECT_EQ("#version 460 compiled as 450", textOf(versionMessages("#version 460 core"), "glsl-W18"));
}

TEST(Version, EmbeddedVersionsHaveDesktopOnes) {
    EXPECT_EQ("'#version 300 es' treated as 330", textOf(versionMessages("#version 300 es"), "glsl-W03"));
    EXPECT_EQ("'#version 100' treated as 120", textOf(versionMessages("#version 100"), "glsl-W03"));
    EXPECT_EQ("'#version 310 es' treated as 430", textOf(versionMessages("#version 310 es"), "glsl-W03"));
    EXPECT_EQ("'#version 320 es' treated as 450", textOf(versionMessages("#version 320 es"), "glsl-W03"));
}

TEST(Version, PrecisionWordsStay) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 300 es\nprecision highp float;\nin mediump vec3 v;\nout lowp vec4 o;\nvoid "
                        "main() { o = vec4(v, 1.); }\n");
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::fragment), "precision highp float;"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Version, LateVersionIsMovedToTheTop) {
    const TranslatedProgram translated =
        translateSingle(Stage::vertex, std::string("uniform float a;\n#version 130\n") + kBody);
    EXPECT_TRUE(has(translated.diagnostics, "glsl-W02"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Version, SecondVersionIsIgnored) {
    const TranslatedProgram translated = translateSingle(
        Stage::vertex, std::string("#version 130\n#version 400\n") + kBody + "int v = __VERSION__;\n");
    EXPECT_EQ("glsl-W02", ids(translated.diagnostics));
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::vertex), "int v = 130;"));
}

TEST(Version, MacroGivesTheUsersNumber) {
    const auto emitted = [](const std::string& text) {
        return userPart(translate(program({{Stage::vertex, text}})), Stage::vertex);
    };
    EXPECT_TRUE(hasTokens(emitted("#version 120\nint v = __VERSION__;\n"), "int v = 120;"));
    EXPECT_TRUE(hasTokens(emitted("int v = __VERSION__;\n"), "int v = 330;"));
    EXPECT_TRUE(
        hasTokens(emitted("#version 120\n#if __VERSION__ == 120\nint v = 1;\n#endif\n"), "int v = 1;"));
}

TEST(Version, CompatibilityMacroFollowsTheProfile) {
    const std::string text =
        "\n#ifdef GL_compatibility_profile\nattribute vec4 p;\n#else\nin vec4 q;\n#endif\nvoid main() { "
        "gl_Position = vec4(0.); }\n";
    const TranslatedProgram compatible = translateSingle(Stage::vertex, "#version 330" + text);
    EXPECT_TRUE(compatible.vertexInputs.contains("p"));
    const TranslatedProgram core = translateSingle(Stage::vertex, "#version 330 core" + text);
    EXPECT_TRUE(core.vertexInputs.contains("q"));
    EXPECT_EQ("", glslangErrors(compatible));
    EXPECT_EQ("", glslangErrors(core));
}

TEST(Extension, KnownOnesAreBlankedAndDefined) {
    const TranslatedProgram translated = translateSingle(
        Stage::vertex,
        std::string("#version 120\n#extension GL_EXT_gpu_shader4 : require\n#extension GL_ARB_gpu_shader5: "
                    "enable\n#if GL_EXT_gpu_shader4\nuniform float yes;\n#endif\n") +
            kBody);
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ(std::string::npos, sourceOf(translated, Stage::vertex).find("#extension"));
    EXPECT_TRUE(translated.uniforms.contains("yes"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Extension, UnknownOnesAreIgnoredOrRefused) {
    EXPECT_EQ("extension GL_XYZ_foo is unknown, ignored",
              textOf(versionMessages("#version 330\n#extension GL_XYZ_foo : enable"), "glsl-W06"));
    EXPECT_TRUE(has(versionMessages("#version 330\n#extension GL_XYZ_foo : require"), "glsl-E03"));
}

TEST(Extension, WhatTheDriverHasIsPassedOn) {
    ProgramRequest request =
        single(Stage::vertex,
               std::string("#version 330\nuniform float a;\n#extension GL_XYZ_foo : require\n") + kBody);
    request.target.hasExtension = [](std::string_view name) { return name == "GL_XYZ_foo"; };
    const TranslatedProgram translated = translate(request);
    EXPECT_EQ("", ids(translated.diagnostics));
    const std::string source = sourceOf(translated, Stage::vertex);
    EXPECT_LT(source.find("#extension GL_XYZ_foo : require"), source.find("#line"));
}

TEST(Extension, InactiveBranchDoesNotCount) {
    EXPECT_EQ("", ids(versionMessages("#version 330\n#if 0\n#extension GL_XYZ_foo : require\n#endif")));
}

TEST(Supply, UsedNamesAreDeclaredOnce) {
    const std::string source = sourceOf(
        translateSingle(Stage::vertex,
                        "void main() { gl_Position = uModelViewProjectionMatrix * aVertex + aVertex; }"),
        Stage::vertex);
    EXPECT_TRUE(hasTokens(source, "uniform mat4 uModelViewProjectionMatrix;"));
    EXPECT_TRUE(hasTokens(source, "in vec4 aVertex;"));
    EXPECT_EQ(source.find("in vec4 aVertex"), source.rfind("in vec4 aVertex"));
    EXPECT_EQ(std::string::npos, source.find("aNormal"));
}

TEST(Supply, DeclaredNamesKeepTheirDeclaration) {
    const std::string source =
        sourceOf(translateSingle(Stage::vertex,
                                 "layout(location = 3) in vec3 aVertex; uniform mat4 uModelViewMatrix;\nvoid "
                                 "main() { gl_Position = uModelViewMatrix * vec4(aVertex, 1.); }"),
                 Stage::vertex);
    EXPECT_TRUE(hasTokens(source, "layout(location = 3) in vec3 aVertex;"));
    EXPECT_EQ(source.find("uniform"), source.rfind("uniform"));
}

TEST(Supply, CompatibilityNamesGetAnotherSpelling) {
    const TranslatedProgram translated =
        translateSingle(Stage::vertex,
                        "#version 110\nvoid main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex "
                        "+ vec4(gl_NormalMatrix * gl_Normal, 0.); }");
    const std::string source = sourceOf(translated, Stage::vertex);
    EXPECT_TRUE(hasTokens(source, "uniform mat4 glibra_ModelViewProjectionMatrix;"));
    EXPECT_TRUE(hasTokens(source, "in vec3 glibra_Normal;"));
    EXPECT_TRUE(hasTokens(source, "gl_Position = glibra_ModelViewProjectionMatrix * glibra_Vertex"));
    EXPECT_EQ("gl_Vertex", translated.userNames.at("glibra_Vertex"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Supply, LocalNamesAreNotBuiltins) {
    const std::string source =
        sourceOf(translateSingle(Stage::fragment,
                                 "out vec4 o; float f(float Timer) { return Timer; }\nvoid main() { float "
                                 "Noise2 = 1.; o = vec4(f(Noise2)); }"),
                 Stage::fragment);
    EXPECT_EQ(std::string::npos, source.find("uniform"));
}

TEST(Supply, MemberNamesAreNotBuiltins) {
    const std::string source = sourceOf(
        translateSingle(
            Stage::fragment,
            "out vec4 o; struct S { float Timer; };\nvoid main() { S s; s.Timer = 1.; o = vec4(s.Timer); }"),
        Stage::fragment);
    EXPECT_EQ(std::string::npos, source.find("uniform"));
}

TEST(Supply, UseAfterALocalScopeIsABuiltin) {
    const std::string source =
        sourceOf(translateSingle(
                     Stage::fragment,
                     "out vec4 o; void main() { { float Timer = 1.; o = vec4(Timer); } o += vec4(Timer); }"),
                 Stage::fragment);
    EXPECT_TRUE(hasTokens(source, "uniform float Timer;"));
}

TEST(Supply, RuntimeValuesAreDeclared) {
    const std::string source = sourceOf(
        translateSingle(
            Stage::fragment,
            "out vec4 o; void main() { o = texture(Noise3, vec3(Timer)) + texture(Noise2, vec2(0.)); }"),
        Stage::fragment);
    EXPECT_TRUE(hasTokens(source, "uniform float Timer;"));
    EXPECT_TRUE(hasTokens(source, "uniform sampler2D Noise2;"));
    EXPECT_TRUE(hasTokens(source, "uniform sampler3D Noise3;"));
}

TEST(Supply, ImpossibleTypeIsAnOrdinaryUniform) {
    const TranslatedProgram translated = translateSingle(
        Stage::fragment, "out vec4 o; uniform float Noise3; void main() { o = vec4(Noise3); }");
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::fragment), "uniform float Noise3;"));
}

TEST(Supply, MeshValuesDeclaredUniformBecomeInputs) {
    const TranslatedProgram translated =
        translateSingle(Stage::vertex,
                        "uniform int FaceIndex; uniform vec3 Tangent;\nvoid main() { gl_Position = "
                        "vec4(Tangent, FaceIndex); }");
    EXPECT_EQ("glsl-W15 glsl-W15", ids(translated.diagnostics));
    EXPECT_EQ("'FaceIndex' declared uniform, treated as vertex input", translated.diagnostics[1].text);
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::vertex), "in int FaceIndex; in vec3 Tangent;"));
}

TEST(Supply, TextureMatrixIsAnArray) {
    const TranslatedProgram translated = translateSingle(
        Stage::vertex, "#version 120\nvoid main() { gl_Position = gl_TextureMatrix[0] * gl_Vertex; }");
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::vertex), "uniform mat4 glibra_TextureMatrix[8];"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Supply, WrittenBuiltinInputIsCopied) {
    const TranslatedProgram translated = translateSingle(
        Stage::vertex, "#version 120\nvoid main() { gl_Vertex.x += 1.; gl_Position = gl_Vertex; }");
    EXPECT_EQ("glsl-W22", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Supply, GstapHeaderIsEmpty) {
    const TranslatedProgram translated = translateSingle(
        Stage::vertex, "#version 330\n#include \"../lib/gstap.h\"\nvoid main() { gl_Position = aVertex; }");
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

}  // namespace
}  // namespace glibra::glsl::test
