// VertexArray in a core profile: the book's cube, restarts, patches, instances, commands on the device.

#include <glibra/classic/glsl_program.h>
#include <glibra/classic/vertex_array.h>

#include <array>
#include <cstdio>

#include "canvas.h"

namespace glibra::classic {
namespace {

class ClassicArray : public Canvas {
  protected:
    /// Each fragment has the colour of the vertex.
    static GLSLProgram colored() {
        GLSLProgram program;
        EXPECT_TRUE(program.CreateFromText(
            {{"a.vert", "out vec4 vColor; void main() { vColor = aColor; gl_Position = aVertex; }\n"},
             {"a.frag", "in vec4 vColor; out vec4 fColor; void main() { fColor = vColor; }\n"}}))
            << toString(program.Messages());
        program.Use();
        return program;
    }
    static void square(VertexArray& array, float x, float y, float size) {
        array.glVertex2f(x, y);
        array.glVertex2f(x + size, y);
        array.glVertex2f(x + size, y + size);
        array.glVertex2f(x, y + size);
    }
};

/// The book's cube: 24 vertices of 6 faces are 8.
VertexArray cube() {
    VertexArray array;
    array.CollapseCommonVertices(true);
    array.SetTol(.001F);
    array.glBegin(GL_QUADS);
    constexpr std::array<std::array<int, 4>, 6> kFaces{
        {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}}};
    for (const auto& face : kFaces)
        for (const int corner : face) {
            const auto x = static_cast<float>(corner & 1);
            const auto y = static_cast<float>(corner >> 1 & 1);
            const auto z = static_cast<float>(corner >> 2 & 1);
            array.glColor3f(x, y, z);
            array.glVertex3f(x * 2 - 1, y * 2 - 1, z * 2 - 1);
        }
    array.glEnd();
    return array;
}

TEST_F(ClassicArray, TheCubeHasEightVertices) {
    const GLSLProgram program = colored();
    VertexArray array = cube();
    EXPECT_EQ(array.NumVertices(), 24U);
    EXPECT_EQ(array.NumUnique(), 8U);
    array.Draw();
    EXPECT_EQ(drawn(), kSide * kSide);
    char* text = nullptr;
    std::size_t length = 0;
    std::FILE* file = open_memstream(&text, &length);
    array.Print("cube", file);
    array.Print(file);  // as the book prints it
    std::fclose(file);
    EXPECT_NE(std::string(text).find("cube: 24 vertices, 8 unique"), std::string::npos) << text;
    std::free(text);
}

TEST_F(ClassicArray, QuadsPolygonsAndFansFillWhatTheyEnclose) {
    const GLSLProgram program = colored();
    for (const unsigned int each : std::array<unsigned int, 3>{GL_QUADS, GL_POLYGON, GL_TRIANGLE_FAN}) {
        clear();
        VertexArray array;
        array.glBegin(each);
        array.glColor3f(1, 0, 1);
        square(array, -.5F, -.5F, 1);
        array.glEnd();
        array.Draw();
        EXPECT_EQ(drawn(), kSide * kSide / 4) << each;
    }
}

TEST_F(ClassicArray, AGridIsOneStripWithRestarts) {
    GLSLProgram program = colored();
    VertexArray array;
    array.CollapseCommonVertices(true);
    array.glBegin(GL_TRIANGLE_STRIP);
    constexpr int kCells = 8;
    for (int row = 0; row < kCells; ++row) {
        array.RestartPrimitive();
        for (int column = 0; column <= kCells; ++column)
            for (const int up : {0, 1})
                array.glVertex2f(static_cast<float>(column) * 2 / kCells - 1,
                                 static_cast<float>(row + up) * 2 / kCells - 1);
    }
    array.glEnd();
    EXPECT_EQ(array.NumUnique(), static_cast<std::size_t>((kCells + 1) * (kCells + 1)));
    glEnable(GL_BLEND);  // what is drawn twice would be brighter
    glBlendFunc(GL_ONE, GL_ONE);
    array.glColor3f(1, 1, 1);
    program.SetAttribute("aColor", .2F, .2F, .2F);
    VertexArray plain = std::move(array);
    plain.Draw();
    glDisable(GL_BLEND);
    EXPECT_EQ(drawn(), kSide * kSide);
    EXPECT_EQ(glIsEnabled(GL_PRIMITIVE_RESTART), GL_FALSE);
}

TEST_F(ClassicArray, SeveralListsAndChangesAfterADraw) {
    const GLSLProgram program = colored();
    VertexArray array;
    array.glBegin(GL_QUADS);
    array.glColor3f(1, 0, 0);
    square(array, -1, -1, 1);
    array.glEnd();
    array.Draw();
    EXPECT_EQ(drawn(), kSide * kSide / 4);
    array.glBegin(GL_TRIANGLE_STRIP);
    array.glColor3f(0, 1, 0);
    array.glVertex2f(0, 0);
    array.glVertex2f(1, 0);
    array.glVertex2f(0, 1);
    array.glVertex2f(1, 1);
    array.glEnd();
    array.UseBufferObjects(false);
    clear();
    array.Draw();
    EXPECT_EQ(drawn(), kSide * kSide / 2);
    EXPECT_EQ(pixel(4, 4), (Pixel{255, 0, 0}));
    EXPECT_EQ(pixel(28, 28), (Pixel{0, 255, 0}));
    array.Clear();
    clear();
    array.Draw();
    EXPECT_EQ(drawn(), 0);
}

TEST_F(ClassicArray, TopologiesBecomePatchesOfProgramsThatTessellate) {
    const std::string tcs =
        "#version 400\nlayout(vertices = 4) out; void main() {\n"
        "gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
        "gl_TessLevelOuter = float[4](2., 2., 2., 2.); gl_TessLevelInner = float[2](2., 2.); }\n";
    const std::string tes =
        "#version 400\nlayout(quads) in; void main() {\n"
        "vec4 a = mix(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_TessCoord.x);\n"
        "vec4 b = mix(gl_in[3].gl_Position, gl_in[2].gl_Position, gl_TessCoord.x); gl_Position = mix(a, b, "
        "gl_TessCoord.y); }\n";
    // A point is a patch of one vertex, and becomes a square around it.
    const std::string pointTcs =
        "#version 400\nlayout(vertices = 1) out; void main() {\n"
        "gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
        "gl_TessLevelOuter = float[4](1., 1., 1., 1.); gl_TessLevelInner = float[2](1., 1.); }\n";
    const std::string pointTes =
        "#version 400\nlayout(quads) in; void main() {\n"
        "gl_Position = gl_in[0].gl_Position + vec4(gl_TessCoord.xy - .5, 0., 0.); }\n";
    const std::string frag = "out vec4 fColor; void main() { fColor = vec4(1.); }\n";
    const std::string vert = "void main() { gl_Position = aVertex; }\n";
    GLSLProgram quads;
    GLSLProgram points;
    ASSERT_TRUE(quads.CreateFromText({{"q.vert", vert}, {"q.tcs", tcs}, {"q.tes", tes}, {"q.frag", frag}}));
    ASSERT_TRUE(points.CreateFromText(
        {{"p.vert", vert}, {"p.tcs", pointTcs}, {"p.tes", pointTes}, {"p.frag", frag}}));
    VertexArray array;
    array.glBegin(GL_QUADS);
    square(array, -1, -1, 1);
    array.glEnd();
    quads.Use();
    array.Draw();
    EXPECT_EQ(drawn(), kSide * kSide / 4);
    VertexArray dots;
    dots.glBegin(GL_POINTS);
    dots.glVertex2f(-.5F, -.5F);
    dots.glVertex2f(.5F, .5F);
    dots.glEnd();
    clear();
    points.Use();
    dots.Draw();
    EXPECT_EQ(drawn(), kSide * kSide / 2);
    // The same array, drawn by a program without tessellation.
    const GLSLProgram plain = colored();
    clear();
    array.Draw();
    EXPECT_EQ(drawn(), kSide * kSide / 4);
    VertexArray patches;
    patches.NumPatchVertices(4);
    patches.glBegin(GL_PATCHES);
    square(patches, 0, 0, 1);
    patches.glEnd();
    testing::internal::CaptureStderr();
    clear();
    patches.Draw();
    EXPECT_EQ(countIn(testing::internal::GetCapturedStderr(), "need a program with tessellation"), 1);
    quads.Use();
    patches.Draw();
    EXPECT_EQ(drawn(), kSide * kSide / 4);
}

TEST_F(ClassicArray, GenericAttributesAreReadByTheirNames) {
    GLSLProgram program;
    ASSERT_TRUE(program.CreateFromText(
        {{"g.vert",
          "in float aHeat; in vec2 aPair; out vec3 vColor;\n"
          "void main() { vColor = vec3(aHeat, aPair); gl_Position = aVertex; }\n"},
         {"g.frag", "in vec3 vColor; out vec4 fColor; void main() { fColor = vec4(vColor, 1.); }\n"}}));
    program.Use();
    VertexArray array;
    array.glBegin(GL_QUADS);
    array.Attribute("aHeat", .2F);
    array.Attribute("aPair", .4F, .6F);
    square(array, -1, -1, 2);
    array.glEnd();
    array.Draw();
    EXPECT_EQ(pixel(9, 20), (Pixel{51, 102, 153}));
    // Another program, at whose locations other names stand.
    GLSLProgram other;
    ASSERT_TRUE(other.CreateFromText(
        {{"o.vert",
          "layout(location = 5) in vec2 aPair; layout(location = 7) in vec4 aVertex; out vec2 vPair;\n"
          "void main() { vPair = aPair; gl_Position = aVertex; }\n"},
         {"o.frag", "in vec2 vPair; out vec4 fColor; void main() { fColor = vec4(vPair, 0., 1.); }\n"}}))
        << toString(other.Messages());
    other.Use();
    array.Draw();
    EXPECT_EQ(pixel(9, 20), (Pixel{102, 153, 0}));
    program.Use();
    array.Draw();
    EXPECT_EQ(pixel(9, 20), (Pixel{51, 102, 153}));
}

TEST_F(ClassicArray, InstancesAndCommandsDrawAsOftenAsTheySay) {
    GLSLProgram program;
    ASSERT_TRUE(program.CreateFromText(
        {{"i.vert", "void main() { gl_Position = aVertex + vec4(float(gl_InstanceID) * .5, 0., 0., 0.); }\n"},
         {"i.frag", "out vec4 fColor; void main() { fColor = vec4(1.); }\n"}}));
    program.Use();
    VertexArray array;
    for (int i = 0; i < 2; ++i) {
        array.glBegin(i == 0 ? GL_QUADS : GL_TRIANGLE_STRIP);
        const auto y = static_cast<float>(i - 1);
        array.glVertex2f(-1, y);
        array.glVertex2f(-.5F, y);
        array.glVertex2f(i == 0 ? -.5F : -1, y + .5F);
        array.glVertex2f(i == 0 ? -1 : -.5F, y + .5F);
        array.glEnd();
    }
    constexpr int kSquare = kSide * kSide / 16;
    array.Draw();
    EXPECT_EQ(drawn(), 2 * kSquare);
    clear();
    array.DrawInstanced(3);
    EXPECT_EQ(drawn(), 6 * kSquare);
    clear();
    array.DrawIndirect();
    EXPECT_EQ(drawn(), 2 * kSquare);
    array.SetInstances(0, 4);
    array.SetInstances(1, 0);
    clear();
    array.DrawIndirect();
    EXPECT_EQ(drawn(), 4 * kSquare);
    // Someone else, such as a compute shader, writes the number.
    const GLuint commands = array.CommandBuffer();
    ASSERT_NE(commands, 0U);
    const GLuint two = 2;
    glBindBuffer(GL_COPY_WRITE_BUFFER, commands);
    glBufferSubData(GL_COPY_WRITE_BUFFER, 4, 4, &two);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    clear();
    array.DrawIndirect();
    EXPECT_EQ(drawn(), 2 * kSquare);
}

TEST_F(ClassicArray, LeavesTheBindingsOfTheCallingProgram) {
    const GLSLProgram program = colored();
    GLuint array = 0;
    GLuint buffer = 0;
    glGenVertexArrays(1, &array);
    glGenBuffers(1, &buffer);
    glBindVertexArray(array);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    VertexArray mine = cube();
    mine.Draw();
    mine.DrawIndirect();
    GLint bound = 0;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
    EXPECT_EQ(bound, static_cast<GLint>(array));
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &bound);
    EXPECT_EQ(bound, static_cast<GLint>(buffer));
    glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &bound);
    EXPECT_EQ(bound, 0);
    glDeleteVertexArrays(1, &array);
    glDeleteBuffers(1, &buffer);
}

TEST_F(ClassicArray, TakesProgramsOfTheCallingProgram) {
    const char* vert =
        "#version 410\nin vec4 aVertex; in vec3 aColor; out vec3 c; void main() { c = aColor; gl_Position = "
        "aVertex; }";
    const char* frag = "#version 410\nin vec3 c; out vec4 f; void main() { f = vec4(c, 1.); }";
    const GLuint program = glCreateProgram();
    for (const auto& [type, text] :
         {std::pair(GL_VERTEX_SHADER, vert), std::pair(GL_FRAGMENT_SHADER, frag)}) {
        const GLuint shader = glCreateShader(static_cast<GLenum>(type));
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    glUseProgram(program);
    VertexArray array;
    array.glBegin(GL_QUADS);
    array.glColor3f(0, 1, 1);
    square(array, -1, -1, 2);
    array.glEnd();
    array.Draw();
    EXPECT_EQ(pixel(5, 5), (Pixel{0, 255, 255}));
    glUseProgram(0);
    glDeleteProgram(program);
}

TEST_F(ClassicArray, MistakesAreReportedOnceAndDrawNothing) {
    glUseProgram(0);
    testing::internal::CaptureStderr();
    for (int i = 0; i < 2; ++i) {
        const VertexArray ended;
        VertexArray array;
        for (int j = 0; j < 2; ++j) {
            array.glVertex2f(0, 0);
            array.glEnd();
            array.RestartPrimitive();
            array.glBegin(99);
            array.NumPatchVertices(0);
            array.SetTol(-1);
            array.SetInstances(3, 1);
        }
        array.glBegin(GL_QUADS);
        array.glBegin(GL_QUADS);
        square(array, -1, -1, 2);
        array.Draw();
        array.glEnd();
        array.Draw();
        array.Draw();
    }
    EXPECT_EQ(countIn(testing::internal::GetCapturedStderr(), "\n"), 2 * 10);
    EXPECT_EQ(drawn(), 0);
}

}  // namespace
}  // namespace glibra::classic
