// Vertex inputs from parts of the elements of buffers (language, 12.6).

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>

#include "script_problems.h"

namespace glibra::test {
namespace {

const std::string kAttributeScene = "WindowSize 8 8\nBackground 0 0 0\nCamera eye (mat4(1)) (mat4(1))\n";

/// Draws a point of a colour at the middle of a pixel.
const std::string kDots =
    "Vertex inline\n#version 430\nin vec2 iPixel;\nin vec3 iTint;\nout vec3 vColor;\nvoid main() { vColor = "
    "iTint;\n"
    "gl_Position = vec4((iPixel + .5)/4. - 1., 0., 1.); }\nEndVertex\n"
    "Fragment inline\n#version 430\nin vec3 vColor;\nout vec4 c;\nvoid main() { c = vec4(vColor, 1.); "
    "}\nEndFragment\n"
    "Program Dots\n";

/// Two pixels and their colours, and no other.
const std::string kTwo = "Expect pixel 1 2 [1 .2 0]\nExpect pixel 5 6 [0 .4 1]\nExpect count [0 0 0] 62\n";

TEST(AttributeParts, AreNumbersAtAnOffsetWithAStride) {
    // As in glVertexAttribPointer: place and colour interleaved, five numbers each, after two that are not
    // meant.
    EXPECT_EQ(
        problemsOf(kAttributeScene + kDots +
                   "Buffer data float [9 9  1 2 1 .2 0  5 6 0 .4 1]\n"
                   "Attribute iPixel data offset 8 stride 20\nAttribute iTint data stride 20 offset 16\n"
                   "Vertices points 2\n" +
                   kTwo),
        "");
}

TEST(AttributeParts, AreDrawnByIndicesAndPerInstance) {
    const std::string data = "Buffer data float [7 7 1 1 1  5 6 0 .4 1  7 1 1 1 1  1 2 1 .2 0]\n";
    const std::string parts = "Attribute iPixel data stride 20\nAttribute iTint data stride 20 offset 8\n";
    EXPECT_EQ(problemsOf(kAttributeScene + kDots + data + parts +
                         "Buffer order uint [3 1]\nVertices points indices order\n" + kTwo),
              "");
    EXPECT_EQ(problemsOf(
                  kAttributeScene + kDots + data +
                  "Attribute iPixel data offset 20 stride 40 per instance\nAttribute iTint data per instance "
                  "stride 40 offset 28\nInstances 2\nVertices points 1\n" +
                  kTwo),
              "");
}

TEST(AttributeParts, HaveAsManyElementsAsFit) {
    const std::string data =
        "Buffer data float [9 9  1 2 1 .2 0  5 6 0 .4 1]\nAttribute iPixel data offset 8 stride 20\n";
    EXPECT_NE(problemsOf(kAttributeScene + kDots + data + "Attribute iTint 1 1 1\nVertices points 3\n")
                  .find("Vertices: 3 vertices are more than the 2 elements of 'data'"),
              std::string::npos)
        << problemsOf(kAttributeScene + kDots + data + "Attribute iTint 1 1 1\nVertices points 3\n");
}

const std::string kDust =
    "Compute inline\n#version 430\nlayout(local_size_x = 2) in;\nstruct Bird { vec3 tint; float age; vec2 "
    "place; };\n"
    "layout(std430) buffer Birds { Bird birds[]; };\nvoid main() { birds[gl_GlobalInvocationID.x].age += 1.; "
    "}\n"
    "EndCompute\nProgram Fly\nBuffer Birds Bird [1 .2 0 7 1 2  0 .4 1 8 5 6]\nDispatch Fly over Birds\n";

TEST(AttributeParts, AreMembersOfStructures) {
    EXPECT_EQ(
        problemsOf(kAttributeScene + kDots + kDust +
                   "Attribute iPixel Birds.place\nAttribute iTint Birds.tint\nVertices points 2\n" + kTwo),
        "");
    EXPECT_EQ(
        problemsOf(
            kAttributeScene + kDots + kDust +
            "Attribute iPixel Birds.place per instance\nAttribute iTint Birds.tint per instance\nInstances "
            "2\nVertices points 1\n" +
            kTwo),
        "");
}

TEST(AttributeParts, OfUnknownNamesAreReported) {
    const auto reported = [](const std::string& attribute) {
        return problemsOf(kAttributeScene + kDots + kDust + attribute +
                          "\nAttribute iTint Birds.tint\nVertices points 2\n");
    };
    EXPECT_NE(reported("Attribute iPixel Birds.plase")
                  .find("Vertices: an attribute reads the member 'plase' of buffer 'Birds', which "
                        "has none of "
                        "that name; did you mean 'place'?"),
              std::string::npos)
        << reported("Attribute iPixel Birds.plase");
    EXPECT_NE(reported("Attribute iPixel Birds.xyz").find("its members are tint, age, place"),
              std::string::npos);
    EXPECT_NE(reported("Attribute iPixel Birds stride 6").find("multiple of 4"), std::string::npos);
    EXPECT_NE(problemsOf(kAttributeScene + kDots +
                         "Buffer b vec2 2\nAttribute iPixel b.x\nAttribute iTint 1 1 1\nVertices points 2\n")
                  .find("'offset' and 'stride'"),
              std::string::npos);
}

TEST(AttributesOfLists, ComeBeforeThoseAroundThem) {
    const std::string begin =
        "WindowSize 8 8\nCamera eye (mat4(1)) (mat4(1))\nBuffer o float 3\nBuffer b float [30 31 32]\n"
        "Vertex inline\n#version 430\nin vec4 aVertex;\nin float w;\n"
        "layout(std430) buffer O { float o[]; };\n"
        "void main() { o[gl_VertexID] = w; gl_Position = aVertex; }\nEndVertex\n"
        "Fragment inline\n#version 330\nout vec4 c;\nvoid main() { c = vec4(1); }\nEndFragment\nProgram P\n";
    const auto list = [&](const std::string& around, const std::array<std::string, 3>& inside,
                          const std::string& expected) {
        std::string scene = begin + around + "glBegin triangles\n";
        const std::array<std::string, 3> places{"0 0 0", "1 0 0", "1 1 0"};
        for (std::size_t i = 0; i < 3; ++i) scene += inside[i] + "glVertex " + places[i] + "\n";
        return problemsOf(scene + "glEnd\n" + expected);
    };
    EXPECT_EQ(
        list("Attribute w 3\n", {"", "Attribute w 5\n", "Attribute w 7\n"}, "Expect buffer o [3 5 7]\n"), "");
    EXPECT_EQ(list("Attribute w 3\n", {"", "", "Attribute w 7\n"}, "Expect buffer o [3 3 7]\n"), "");
    EXPECT_EQ(list("", {"", "Attribute w 5\n", ""}, "Expect buffer o [0 5 5]\n"), "");
    EXPECT_EQ(
        list("Attribute w b\n", {"Attribute w 1\n", "Attribute w 5\n", ""}, "Expect buffer o [1 5 5]\n"), "");
    EXPECT_EQ(list("Attribute w b\n", {"", "", ""}, "Expect buffer o [30 31 32]\n"), "");
    EXPECT_NE(list("Attribute w b\n", {"", "Attribute w 5\n", ""}, "")
                  .find("Attribute w: the vertices before have it from line 18; state it before the first "
                        "glVertex, too [glib-E32]"),
              std::string::npos);
    EXPECT_EQ(
        list("Attribute w 3\n", {"Attribute w 5\n", "", ""}, "Vertices points 1\nExpect buffer o [3 5 5]\n"),
        "")
        << "after the list the outer one holds again";
}

}  // namespace
}  // namespace glibra::test
