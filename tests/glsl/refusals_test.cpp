// Shaders that cannot be emulated are refused, with a hint what to write instead (language, 7.12).

#include <gtest/gtest.h>

#include "support.h"

namespace glibra::glsl::test {
namespace {

Diagnostics messages(Stage stage, const std::string& text) {
    return translateSingle(stage, text).diagnostics;
}

TEST(Refusals, VertexInputsOutsideTheVertexStage) {
    for (const char* name : {"gl_Vertex", "gl_Normal", "gl_MultiTexCoord0", "gl_FogCoord", "aVertex",
                             "aTexCoord0", "Tangent", "FaceIndex"}) {
        const Diagnostics found =
            messages(Stage::fragment, "out vec4 o; void main() { o = vec4(" + std::string(name) + "); }");
        EXPECT_EQ("glsl-E03", ids(found)) << name;
        EXPECT_NE(std::string::npos, textOf(found, "glsl-E03").find("vertex stage")) << name;
    }
    EXPECT_TRUE(
        has(messages(Stage::geometry, "void main() { gl_Position = gl_Color; EmitVertex(); }"), "glsl-E03"));
}

TEST(Refusals, OwnVaryingOfSuchANameIsFine) {
    EXPECT_FALSE(has(messages(Stage::fragment, "in vec4 aVertex; out vec4 o; void main() { o = aVertex; }"),
                     "glsl-E03"));
}

TEST(Refusals, FaceIndexAsUniformOutsideTheVertexStage) {
    const Diagnostics found =
        messages(Stage::fragment, "uniform int FaceIndex; out vec4 o; void main() { o = vec4(FaceIndex); }");
    EXPECT_NE(std::string::npos, textOf(found, "glsl-E03").find("flat"));
}

TEST(Refusals, BuiltinRedeclaredWithAnotherType) {
    EXPECT_TRUE(has(messages(Stage::vertex,
                             "#version 120\nuniform mat3 gl_ModelViewMatrix; void main() { gl_Position = "
                             "vec4(gl_ModelViewMatrix[0], 1.); }"),
                    "glsl-E03"));
    const TranslatedProgram same = translateSingle(Stage::vertex,
                                                   "#version 120\nuniform mat4 gl_ModelViewMatrix; void "
                                                   "main() { gl_Position = gl_ModelViewMatrix[0]; }");
    EXPECT_EQ("", ids(same.diagnostics));
    EXPECT_EQ("", glslangErrors(same));
}

TEST(Refusals, MacrosThatGrowWithoutBound) {
    const auto doubling = [](int count) {
        std::string text = "#version 330\n#define M0 1.\n";
        for (int i = 1; i <= count; ++i)
            text += "#define M" + std::to_string(i) + " M" + std::to_string(i - 1) + "+M" +
                    std::to_string(i - 1) + "\n";
        return text + "out vec4 o; void main() { o = vec4(M" + std::to_string(count) + "); }";
    };
    EXPECT_EQ("", ids(messages(Stage::fragment, doubling(10))));
    EXPECT_EQ("glsl-E11", ids(messages(Stage::fragment, doubling(40))));

    // Here the macros are few, but each use of a parameter copies the argument.
    std::string copies = "#version 330\n#define F(x) ";
    for (int i = 0; i < 200; ++i) copies += "+x";
    copies += "\nout vec4 o; void main() { o = vec4(F(F(F(F(1.+2.+3.+4.))))); }";
    EXPECT_EQ("glsl-E11", ids(messages(Stage::fragment, copies)));
}

TEST(Refusals, ReservedPrefix) {
    EXPECT_EQ("names beginning with 'glibra_' are reserved",
              textOf(messages(Stage::vertex,
                              "uniform float glibra_x; void main() { gl_Position = vec4(glibra_x); }"),
                     "glsl-E05"));
}

TEST(Refusals, ComputeAndUnknownSamplers) {
    EXPECT_TRUE(has(messages(Stage::vertex, "#version 430\nlayout(local_size_x = 8) in; void main() { }"),
                    "glsl-E03"));
    EXPECT_TRUE(
        has(messages(Stage::vertex, "#version 430\nvoid main() { uint x = gl_GlobalInvocationID.x; }"),
            "glsl-E03"));
    EXPECT_TRUE(has(messages(Stage::fragment, "uniform sampler3DRect s; void main() { }"), "glsl-E03"));
}

TEST(Refusals, TargetTooOldNamesTheVersion) {
    ProgramRequest request = single(Stage::fragment,
                                    "#version 420\nlayout(rgba8) uniform image2D i; out vec4 o; void main() "
                                    "{ o = imageLoad(i, ivec2(0)); }");
    EXPECT_EQ("", glslangErrors(translate(request)));
    request.target.version = 410;
    EXPECT_EQ("image2D needs GLSL 4.20, this driver has 4.10",
              textOf(translate(request).diagnostics, "glsl-E03"));
    request.target.hasExtension = [](std::string_view name) {
        return name == "GL_ARB_shader_image_load_store";
    };
    EXPECT_EQ("", ids(translate(request).diagnostics));
    EXPECT_NE(std::string::npos, sourceOf(translate(request), Stage::fragment)
                                     .find("#extension GL_ARB_shader_image_load_store : enable"));
}

TEST(Refusals, NothingIsEmittedAfterAnError) {
    EXPECT_TRUE(translateSingle(Stage::vertex, "uniform float glibra_x; void main() { }").stages.empty());
}

TEST(Refusals, EmptyFile) {
    EXPECT_EQ("'a.vert' is empty", textOf(translateStages({{Stage::vertex, ""}}).diagnostics, "file-E02"));
}

TEST(Refusals, MessagesAreBounded) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += ";";
    EXPECT_EQ(1000U, messages(Stage::vertex, text).size());
}

TEST(Refusals, ExpressionsThatDriversCannotReadHaveAMessage) {
    const auto found = [](std::size_t operands, const std::string& joint) {
        std::string text = "#version 330\nout vec4 c;\nuniform float x;\nvoid main() {\n    float a = x";
        for (std::size_t i = 1; i < operands; ++i) text += joint;
        return translateSingle(Stage::fragment, text + ";\n    c = vec4(a);\n}\n").diagnostics;
    };
    EXPECT_EQ(ids(found(20000, "+x")), "glsl-E11");
    EXPECT_EQ(placeOf(found(20000, "+x"), "glsl-E11").line, 5);
    EXPECT_EQ(ids(found(20000, " > 0. ? x : x")), "glsl-E11");
    EXPECT_NE(ids(found(20000, ".x")).find("glsl-E11"), std::string::npos);
    EXPECT_EQ(ids(found(2000, "+x")), "");
    EXPECT_EQ(ids(found(20000, ", b = x")).find("glsl-E11"), std::string::npos);
}

}  // namespace
}  // namespace glibra::glsl::test
