// Arrays of cube maps: CubeMap ... layers (language, 12.4).

#include <gtest/gtest.h>

#include <string>

#include "modern_text.h"
#include "script_problems.h"

namespace glibra::test {
namespace {

const std::string kOneColor = R"(WindowSize 8 8
Fragment inline
#version 410 core
uniform vec4 uColor;
out vec4 c;
void main() { c = uColor; }
EndFragment
Program Flat
)";
/// Shows the direction in a layer.
std::string lookingInto(const std::string& direction, const std::string& layer) {
    return "Fragment inline\n#version 410 core\nuniform samplerCubeArray uSky;\nout vec4 c;\n"
           "void main() { c = texture(uSky, vec4(" +
           direction + ", " + layer + ")); }\nEndFragment\nProgram Look  uSky sky\nFill window with Look\n";
}

TEST(ScriptCubeArrays, EachFaceOfEachLayerIsDrawnAlone) {
    // Every face gets its numbers as a colour; +x -x +y -y +z -z.
    const std::string scene = kOneColor +
                              "CubeMap sky 4 rgba8 layers 3\n"
                              "Repeat 3 as cube\nRepeat 6 as face\n"
                              "Pass sky.layer(cube).face(face)\n"
                              "Set uColor (vec4(cube/2, face/5, .5, 1))\nFullScreen\n"
                              "EndPass\nEndRepeat\nEndRepeat\n";
    const char* directions[] = {"1, 0, 0", "-1, 0, 0", "0, 1, 0", "0, -1, 0", "0, 0, 1", "0, 0, -1"};
    for (int cube = 0; cube < 3; ++cube)
        for (int face = 0; face < 6; ++face) {
            const std::string wanted =
                "[" + std::to_string(cube / 2.) + " " + std::to_string(face / 5.) + "]";
            EXPECT_EQ(
                problemsOf(scene + lookingInto(directions[face], std::to_string(cube)) + "Expect pixel 3 3 " +
                           wanted + "\nExpect mean 0 0 4 4 " + wanted + " of sky.layer(" +
                           std::to_string(cube) + ").face(" + std::to_string(face) + ")\n"),
                "")
                << cube << " " << face;
        }
}

TEST(ScriptCubeArrays, TheGeometryStageChoosesTheFace) {
    EXPECT_EQ(problemsOf("WindowSize 8 8\nCubeMap sky 4 rgba8 layers 2\n" +
                         coveringLayers(12, "vec4(vLayer / 11., 0, 0, 1)") +
                         "Pass sky\nUse Layers\nVertices points 1\nEndPass\n"
                         "Expect mean 0 0 4 4 [.4545] of sky.layer(0).face(5) within .003\n"
                         "Expect mean 0 0 4 4 [1] of sky.layer(1).face(5)\n"),
              "");
}

TEST(ScriptCubeArrays, HaveLevelsAndDepth) {
    EXPECT_EQ(problemsOf(kOneColor +
                         "CubeMap sky 4 rgba8 layers 2 mipmap generate\n"
                         "Pass sky.layer(1).face(2) clear {1 .5 0 1}\nEndPass\n" +
                         lookingInto("0, 1, 0", "1") +
                         "Expect pixel 3 3 [1 .5 0] within .01\n"
                         "Expect pixel 0 0 [1 .5 0] of sky.layer(1).face(2).level(2) within .01\n"),
              "");
    EXPECT_EQ(problemsOf(R"(WindowSize 8 8
CubeMap far 4 depth32f layers 2
Pass far.layer(1).face(0) clear depth .5
EndPass
Fragment inline
#version 410 core
uniform samplerCubeArrayShadow far;
in vec2 vST;
out vec4 c;
void main() { c = vec4(texture(far, vec4(1, 0, 0, 1), vST.x)); }
EndFragment
Program Compare
Fill window with Compare
Expect pixel 1 1 [1]
Expect pixel 6 1 [0]
)"),
              "");
}

TEST(ScriptCubeArrays, PartsNeedBothNumbers) {
    const auto expect = [](const std::string& line, const std::string& message) {
        const std::string refused = refusalOf(kOneColor + "CubeMap sky 4 rgba8 layers 2\n" + line + "\n");
        EXPECT_NE(refused.find(message), std::string::npos) << line << refused;
    };
    expect("Pass sky.face(1)\nEndPass",
           "sky: a part of several cube maps has a layer and a face: sky.layer(0).face(0) [glib-E35]");
    expect("Pass sky.layer(1)\nEndPass", "has a layer and a face");
    expect("Pass sky.layer(2).face(0)\nEndPass", "sky.layer: 2 is not between 0 and 1");
    expect("Pass sky.layer(1).face(6)\nEndPass", "sky.face: 6 is not between 0 and 5");
    expect("Pass sky.layer(1).face(0).layer(0)\nEndPass", "'layer' given twice");
    expect("CubeMap other 4 rgba8 layers 0", "is not between 1 and 341");
    expect(
        "Fragment inline\n#version 410 core\nuniform samplerCube sky;\nout vec4 c;\n"
        "void main() { c = texture(sky, vec3(1)); }\nEndFragment\nProgram P\nFill window with P",
        "cannot read 'sky' (line 9), which is an array of cube maps of rgba8; write samplerCubeArray");
}

}  // namespace
}  // namespace glibra::test
