// GLSLProgram in a context that the calling program made current.

#include <glibra/classic/glsl_program.h>
#include <glibra/classic/vertex_array.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "canvas.h"

namespace glibra::classic {
namespace {

/// A triangle over the whole canvas.
VertexArray cover() {
    VertexArray triangle;
    triangle.glBegin(GL_TRIANGLES);
    triangle.glVertex2f(-1, -1);
    triangle.glVertex2f(3, -1);
    triangle.glVertex2f(-1, 3);
    triangle.glEnd();
    return triangle;
}

constexpr const char* kOldVertex =
    "void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n";
constexpr const char* kPlainVertex = "void main() { gl_Position = aVertex; }\n";

class ClassicProgram : public Canvas {
  protected:
    static Pixel colorOf(GLSLProgram& program) {
        clear();
        program.Use();
        VertexArray triangle = cover();
        triangle.Draw();
        return pixel(kSide / 2, kSide / 2);
    }
};

TEST_F(ClassicProgram, TakesTheDialectsOfTheBook) {
    GLSLProgram program;
    ASSERT_TRUE(program.CreateFromText(
        {{"a.vert", kOldVertex},
         {"a.frag", "uniform vec3 uColor; void main() { gl_FragColor = vec4(uColor, 1.); }\n"}}))
        << toString(program.Messages());
    EXPECT_TRUE(program.IsValid());
    program.SetUniform("uColor", 1.F, .2F, 0.F);
    EXPECT_EQ(colorOf(program), (Pixel{255, 51, 0}));
    program.SetUniform("uColor", Vec3(0, 0, 1));
    EXPECT_EQ(colorOf(program), (Pixel{0, 0, 255}));
}

TEST_F(ClassicProgram, GeometryShadersOfTheOldExtensionHaveTheGivenTopologies) {
    GLSLProgram program;
    program.SetInputTopology(GL_TRIANGLES);
    program.SetOutputTopology(GL_TRIANGLE_STRIP);
    ASSERT_TRUE(program.CreateFromText(
        {{"g.vert", kPlainVertex},
         {"g.geom",
          "#version 120\n#extension GL_EXT_geometry_shader4: enable\nvoid main() { for (int i = 0; i < "
          "gl_VerticesIn; i++) {\n"
          "gl_Position = gl_PositionIn[i] * vec4(.5, .5, 1., 1.); EmitVertex(); } EndPrimitive(); }\n"},
         {"g.frag", "void main() { gl_FragColor = vec4(0., 1., 0., 1.); }\n"}}))
        << toString(program.Messages());
    EXPECT_EQ(colorOf(program), (Pixel{0, 255, 0}));
    EXPECT_EQ(pixel(1, 1), (Pixel{0, 0, 0}));  // the geometry shader made it smaller
    testing::internal::CaptureStderr();
    program.SetInputTopology(GL_TRIANGLE_STRIP);
    EXPECT_EQ(countIn(testing::internal::GetCapturedStderr(), "SetInputTopology"), 1);
}

TEST_F(ClassicProgram, MatricesThatFollowFromOthersFollow) {
    GLSLProgram program;
    ASSERT_TRUE(program.CreateFromText(
        {{"m.vert", kPlainVertex},
         {"m.frag",
          "uniform int uWhich; out vec4 fColor; bool near(vec4 a, vec4 b) { return distance(a, b) < 1e-4; }\n"
          "void main() { bool good = false; vec4 p = vec4(1., 2., 3., 1.);\n"
          "if (uWhich == 0) good = near(uModelViewMatrix * p, vec4(3., 4., 7., 1.));\n"
          "if (uWhich == 1) good = near(uModelViewProjectionMatrix * p, vec4(6., 8., 14., 1.));\n"
          "if (uWhich == 2) good = near(uModelViewMatrixInverse * vec4(3., 4., 7., 1.), p);\n"
          "if (uWhich == 3) good = near(vec4(uNormalMatrix * vec3(1.), 0.), vec4(1., 1., .5, 0.));\n"
          "if (uWhich == 4) good = near(gl_ModelViewProjectionMatrixInverse * vec4(6., 8., 14., 1.), p);\n"
          "if (uWhich == 5) good = near(uProjectionMatrix * p, vec4(2., 4., 6., 1.));\n"
          "if (uWhich == 6) good = near(gl_TextureMatrix[1] * p, p);\n"
          "fColor = vec4(good, 0., 1., 1.); }\n"}}))
        << toString(program.Messages());
    program.SetUniform("uProjectionMatrix", Matrix4().Scalef(2, 2, 2));
    program.SetUniform("gl_ModelViewMatrix", Matrix4().Scalef(1, 1, 2).Translatef(2, 2, 1));
    for (int i = 0; i < 7; ++i) {
        program.SetUniform("uWhich", i);
        EXPECT_EQ(colorOf(program), (Pixel{255, 0, 255})) << i;
    }
    program.SetUniform("uNormalMatrix", Matrix4());  // a given one stays
    program.SetUniform("uModelViewMatrix", Matrix4().Scalef(9, 9, 9));
    program.SetUniform("uWhich", 3);
    EXPECT_EQ(colorOf(program), (Pixel{0, 0, 255}));
}

TEST_F(ClassicProgram, TakesEveryKindOfValue) {
    GLSLProgram program;
    ASSERT_TRUE(program.CreateFromText(
        {{"u.vert", kPlainVertex},
         {"u.frag",
          "uniform int uInt; uniform uint uCount; uniform bool uOn; uniform float uFloats[3]; uniform vec4 "
          "uFour;\n"
          "uniform vec2 uTwo; uniform mat3 uSmall; struct Light { vec3 place; float power; }; uniform Light "
          "uLights[2];\n"
          "out vec4 fColor; void main() { bool a = uInt == -3 && uCount == 7u && uOn;\n"
          "bool b = uFloats[0] == 1. && uFloats[1] == 5. && uFloats[2] == 3. && uTwo == vec2(8., 9.);\n"
          "bool c = uFour == vec4(1., 2., 3., 1.) && uSmall[1][0] == 4. && uLights[1].place == vec3(6.) && "
          "uLights[1].power == 2.;\n"
          "fColor = vec4(a, b, c, 1.); }\n"}}))
        << toString(program.Messages());
    program.SetUniform("uInt", -3);
    program.SetUniform("uCount", 7);
    program.SetUniform("uOn", true);
    const float floats[] = {1, 2, 3};
    program.SetUniform("uFloats", floats);
    program.SetUniform("uFloats[1]", 5.);
    program.SetUniform("uFour", 1, 2, 3);
    const float two[] = {8, 9};
    program.SetUniform("uTwo", two);
    program.SetUniform("uSmall", Matrix4().SetElement(0, 1, 4));
    program.SetUniform("uLights[1].place", Vec3(6, 6, 6));
    program.SetUniform("uLights[1].power", 2.F);
    EXPECT_EQ(colorOf(program), (Pixel{255, 255, 255}));
}

TEST_F(ClassicProgram, AttributesHaveConstantsWhereNoArrayGivesThem) {
    GLSLProgram program;
    ASSERT_TRUE(program.CreateFromText(
        {{"c.vert",
          "in vec3 aMine; in float aHeat; out vec3 vColor;\n"
          "void main() { vColor = aMine * aHeat * aColor.rgb; gl_Position = aVertex; }\n"},
         {"c.frag", "in vec3 vColor; out vec4 fColor; void main() { fColor = vec4(vColor, 1.); }\n"}}))
        << toString(program.Messages());
    program.SetAttribute("aMine", Vec3(1, .4F, 0));
    program.SetAttribute("aHeat", .5F);
    EXPECT_EQ(colorOf(program), (Pixel{128, 51, 0}));  // aColor is white, as in old OpenGL
    const float mine[] = {0, 0, 1};
    program.SetAttribute("aMine", mine);
    program.SetAttribute("aHeat", 1);
    program.SetAttribute("gl_Color", 1.F, 1.F, .2F);
    EXPECT_EQ(colorOf(program), (Pixel{0, 0, 51}));
}

TEST_F(ClassicProgram, UnknownNamesAndWrongTypesAreReportedOnce) {
    GLSLProgram program;
    ASSERT_TRUE(program.CreateFromText(
        {{"n.vert", kPlainVertex},
         {"n.frag", "uniform vec3 uColor; void main() { gl_FragColor = vec4(uColor, 1.); }\n"}}));
    testing::internal::CaptureStderr();
    for (int i = 0; i < 3; ++i) {
        program.SetUniform("uColour", 1, 1, 1);
        program.SetUniform("uColor", 1);
        program.SetUniform("uColor", Matrix4());
        program.SetAttribute("aVertx", 1, 1, 1);
        program.SetUniform("uModelViewMatrix", Matrix4());  // of gstap.h: no mistake
        program.SetAttribute("aNormal", 0, 0, 1);
    }
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_EQ(countIn(text, "\n"), 3) << text;
    EXPECT_EQ(countIn(text, "no uniform 'uColour'; did you mean 'uColor'?"), 1) << text;
    EXPECT_EQ(countIn(text, "'uColor' is a vec3 and was given 1 number"), 1) << text;
    EXPECT_EQ(countIn(text, "no attribute 'aVertx'; did you mean 'aVertex'?"), 1) << text;
}

TEST_F(ClassicProgram, IntegersTakeWholeNumbersOnly) {
    GLSLProgram program;
    ASSERT_TRUE(program.CreateFromText(
        {{"i.vert",
          "#version 330\nin ivec2 aPair; flat out ivec2 vPair;\n"
          "void main() { vPair = aPair; gl_Position = aVertex; }\n"},
         {"i.frag",
          "#version 330\nuniform int uCount; uniform ivec3 uThree; uniform int uMany[2]; uniform bool uOn;\n"
          "flat in ivec2 vPair; out vec4 fColor; void main() {\n"
          "fColor = vec4(uCount == 2 && uOn, uThree == ivec3(1, 2, 3) && uMany[1] == 5, "
          "vPair == ivec2(7, 8), 1.); }\n"}}))
        << toString(program.Messages());
    const float many[] = {4, 5}, wrongMany[] = {4, 5.5F}, pair[] = {7, 8}, wrongPair[] = {7.5F, 8};
    program.SetUniform("uCount", 2.F);  // whole floats are taken
    program.SetUniform("uThree", Vec3(1, 2, 3));
    program.SetUniform("uMany", many);
    program.SetUniform("uOn", 1.F);
    program.SetAttribute("aPair", pair);
    testing::internal::CaptureStderr();
    for (int i = 0; i < 2; ++i) {
        program.SetUniform("uCount", 2.5F);
        program.SetUniform("uThree", Vec3(1, 2.25F, 3));
        program.SetUniform("uMany", wrongMany);
        program.SetUniform("uOn", 1e20F);
        program.SetAttribute("aPair", wrongPair);
    }
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_EQ(countIn(text, "\n"), 5) << text;
    EXPECT_EQ(countIn(text, "SetUniform: 'uCount' has the type int and was given 2.5"), 1) << text;
    EXPECT_EQ(countIn(text, "SetUniform: 'uThree' has the type ivec3 and was given 2.25"), 1) << text;
    EXPECT_EQ(countIn(text, "SetUniform: 'uMany' has the type int and was given 5.5"), 1) << text;
    EXPECT_EQ(countIn(text, "SetAttribute: 'aPair' has the type ivec2 and was given 7.5"), 1) << text;
    EXPECT_EQ(colorOf(program), (Pixel{255, 255, 255}));  // what was refused has changed nothing
}

TEST_F(ClassicProgram, ALetterTooManyInAShortNameIsAMistakeButAnotherLetterIsAnotherName) {
    GLSLProgram program;
    ASSERT_TRUE(program.CreateFromText(
        {{"s.vert", "in float aH; out float vH; void main() { vH = aH; gl_Position = aVertex; }\n"},
         {"s.frag",
          "uniform float uC, uKd; in float vH; void main() { gl_FragColor = vec4(uC + uKd + vH); }\n"}}))
        << toString(program.Messages());
    testing::internal::CaptureStderr();
    program.SetUniform("uCc", 1.F);
    program.SetUniform("uKs", 1.F);
    program.SetUniform("uKdd", 1.F);
    program.SetAttribute("aHh", 1.F);
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_EQ(countIn(text, "no uniform 'uCc'; did you mean 'uC'?"), 1) << text;
    EXPECT_EQ(countIn(text, "no uniform 'uKs'\n"), 1) << text;
    EXPECT_EQ(countIn(text, "no uniform 'uKdd'; did you mean 'uKd'?"), 1) << text;
    EXPECT_EQ(countIn(text, "no attribute 'aHh'; did you mean 'aH'?"), 1) << text;
}

TEST_F(ClassicProgram, ErrorsNameTheUsersFileAndLine) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("glibra_classic_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    const std::string vert = (folder / "a.vert").string();
    const std::string frag = (folder / "a.frag").string();
    std::ofstream(vert) << kOldVertex;
    std::ofstream(frag) << "uniform float uKa;\n\nvoid main()\n{\n    gl_FragColor = vec4(uKd);\n}\n";
    GLSLProgram program;
    testing::internal::CaptureStderr();
    EXPECT_FALSE(program.Create(vert.c_str(), frag.c_str()));
    EXPECT_FALSE(program.IsValid());
    program.Use();
    program.Use();
    program.SetUniform("uKa", 1.F);
    std::string text = testing::internal::GetCapturedStderr();
    EXPECT_NE(text.find(frag + ":5:"), std::string::npos) << text;
    EXPECT_EQ(countIn(text, "without a valid program"), 1) << text;

    std::ofstream(frag) << "#include \"b.glsl\"\nvoid main() { gl_FragColor = color(); }\n";
    std::ofstream(folder / "b.glsl") << "vec4 color() { return vec4(0., 1., 1., 1.); }\n";
    ASSERT_TRUE(program.Create(vert.c_str(), frag.c_str())) << toString(program.Messages());
    EXPECT_EQ(colorOf(program), (Pixel{0, 255, 255}));

    testing::internal::CaptureStderr();
    EXPECT_FALSE(program.Create(vert.c_str(), (folder / "none.frag").string().c_str()));
    EXPECT_FALSE(program.Create(vert.c_str(), (folder / "b.glsl").string().c_str()));
    EXPECT_FALSE(program.Create(vert.c_str(), vert.c_str()));
    EXPECT_FALSE(program.Create(frag.c_str()));
    text = testing::internal::GetCapturedStderr();
    for (const char* each :
         {"cannot be read", "says no stage", "two files of this stage", "no vertex shader"})
        EXPECT_EQ(countIn(text, each), 1) << text;
    std::filesystem::remove_all(folder);
}

TEST_F(ClassicProgram, LinkErrorsAreReported) {
    GLSLProgram program;
    testing::internal::CaptureStderr();
    EXPECT_FALSE(program.CreateFromText(
        {{"l.vert",
          "#version 400\nin vec4 aVertex; out vec2 vA; void main() { vA = vec2(1.); gl_Position = aVertex; "
          "}\n"},
         {"l.frag", "#version 400\nin vec3 vA; out vec4 f; void main() { f = vec4(vA, 1.); }\n"}}));
    EXPECT_NE(testing::internal::GetCapturedStderr().find("vA"), std::string::npos);
}

TEST_F(ClassicProgram, WithoutGstapOnlyCoreShadersCompile) {
    GLSLProgram program;
    program.SetGstap(false);
    testing::internal::CaptureStderr();
    EXPECT_FALSE(program.CreateFromText({{"s.vert", kPlainVertex}, {"s.frag", "void main() {}\n"}}));
    testing::internal::GetCapturedStderr();
    EXPECT_TRUE(program.CreateFromText(
        {{"s.vert", "#version 410 core\nin vec4 aVertex; void main() { gl_Position = aVertex; }\n"},
         {"s.frag", "#version 410 core\nout vec4 f; void main() { f = vec4(1., 1., 0., 1.); }\n"}}))
        << toString(program.Messages());
    EXPECT_EQ(colorOf(program), (Pixel{255, 255, 0}));
}

TEST_F(ClassicProgram, VerboseListsWhatTheProgramUses) {
    GLSLProgram program;
    program.SetVerbose(true);
    testing::internal::CaptureStderr();
    ASSERT_TRUE(program.CreateFromText(
        {{"v.vert", kOldVertex},
         {"v.frag", "uniform float uKa; void main() { gl_FragColor = vec4(uKa); }\n"}}));
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_NE(text.find("uniform float uKa"), std::string::npos) << text;
    EXPECT_NE(text.find("attribute vec4 aVertex at 0"), std::string::npos) << text;
}

TEST(ClassicProgramWithoutContext, SaysThatNoContextIsCurrent) {
    GLSLProgram program;
    testing::internal::CaptureStderr();
    EXPECT_FALSE(program.CreateFromText({{"a.vert", kOldVertex}, {"a.frag", "void main() {}\n"}}));
    program.UseFixedFunction();
    cover().Draw();
    EXPECT_EQ(countIn(testing::internal::GetCapturedStderr(), "no OpenGL context is current"), 3);
}

TEST(ClassicProgramWithoutContext, ObjectsMayEndAfterTheirContext) {
    Result<gpu::Context> context = gpu::openContext();
    ASSERT_TRUE(context);
    GLSLProgram program;
    ASSERT_TRUE(program.CreateFromText(
        {{"a.vert", kOldVertex}, {"a.frag", "void main() { gl_FragColor = vec4(1.); }\n"}}));
    VertexArray triangle = cover();
    program.Use();
    triangle.Draw();
    context.value.reset();
}

}  // namespace
}  // namespace glibra::classic
