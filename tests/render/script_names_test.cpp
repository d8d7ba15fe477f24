// Names, parameters, choices and cameras of modern scenes, by scenes whose Expect lines must hold.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "script_problems.h"

namespace glibra::test {
namespace {

TEST(Choices, BindTheTextureOrBufferThatTheirWordNames) {
    const std::string begin =
        "WindowSize 8 8\nTexture2D red 8 8 rgba8\nTexture2D green 8 8 rgba8\nLet pic <green red>\n" +
        showing("sampler2D", "vST") +
        "Program Copy\nFragment inline\n#version 330\nin vec2 vST;\nout vec4 c;\nuniform sampler2D uT;\n"
        "void main() { c = texture(uT, vST); }\nEndFragment\nProgram Tagged uT pic\n"
        "Pass red clear {1 0 0}\nEndPass\nPass green clear {0 1 0}\nEndPass\n";
    const std::string isGreen = "Expect pixel 3 3 [0 1 0]\n";
    EXPECT_EQ(problemsOf(begin + "Fill window with Copy uT pic\n" + isGreen), "");
    EXPECT_EQ(problemsOf(begin + "Fill window with Tagged\n" + isGreen), "");
    EXPECT_EQ(problemsOf(begin + "Set uT pic\nFill window with Copy\n" + isGreen), "");
    EXPECT_EQ(
        problemsOf(begin + "Repeat [red green] as op\nFill window with Copy uT op\nEndRepeat\n" + isGreen),
        "");
    EXPECT_EQ(
        problemsOf(begin + "Group g what red\nFill window with Copy uT what\nEndGroup\nDraw g what pic\n" +
                   isGreen),
        "");
    EXPECT_EQ(problemsOf("WindowSize 8 8\nTexture2D red 8 8 rgba8\nTexture2D green 8 8 rgba8\n"
                         "Let pic <red green>\nFragment inline\n#version 330\nuniform int uK;\nout vec4 c;\n"
                         "void main() { c = vec4(0, uK == 1 ? 1 : 0, 0, 1); }\nEndFragment\nProgram Number\n"
                         "Repeat [red green] as op\nFill window with Number uK op\nEndRepeat\n" +
                         isGreen),
              "")
        << "other uniforms take the number";
    EXPECT_NE(problemsOf(begin + "Let other <one two>\nFill window with Copy uT other\n")
                  .find("'one' is no variable, texture or buffer"),
              std::string::npos);
}

TEST(Buffers, HaveTheNumbersOfTheirStructureFromAnExpression) {
    const std::string shader =
        "WindowSize 8 8\nFragment inline\n#version 430\nstruct Drop { vec4 place; vec4 speed; };\n"
        "layout(std430) buffer drops { Drop all[]; };\nout vec4 c;\n"
        "void main() { c = all[1].place; }\nEndFragment\n";
    const auto problems = [&](const std::string& buffer) {
        return problemsOf(buffer + shader + "Program P\nFill window with P\n");
    };
    for (const std::string type : {"Drop ", ""})
        EXPECT_NE(
            problems("Buffer drops " + type + "3 (vec4(i + 1))\n")
                .find("buffer 'drops': an element has 8 numbers, but the expression gives 4 [memory-E04]"),
            std::string::npos)
            << type << problems("Buffer drops " + type + "3 (vec4(i + 1))\n");
    EXPECT_EQ(problems("Buffer drops Drop 3 [1 2 3 4]\n"), "") << "shorter lists leave the rest zero";
}

TEST(Messages, OfATagWithAnErrorAreNotRepeated) {
    EXPECT_EQ(problemsOf("WindowSize 8 8\nTexture2D life 8 8 rgba8\n" + showing("sampler2D", "vST") +
                         "Program Next uT life.prev\nFill window with Next\nExpect error glib-E35\n"),
              "");
    const std::string time = problemsOf(
        "WindowSize 8 8\nLet k 1\nFragment inline\n#version 330\nuniform float time;\nout vec4 c;\n"
        "void main() { c = vec4(time + .5); }\nEndFragment\nProgram P\nFill window with P\n");
    EXPECT_NE(time.find("is not set; it is 0; write 'time (time)' on the line of its Program"),
              std::string::npos)
        << time;
    const std::string elsewhere = problemsOf(
        "WindowSize 8 8\nLet k 1\nFragment inline\n#version 330\nuniform float iTime; uniform vec3 "
        "iResolution;\nout vec4 c;\n"
        "void main() { c = vec4(iTime)*iResolution.x; }\nEndFragment\nProgram P\nFill window with P\n");
    EXPECT_NE(elsewhere.find("write 'iTime (time)' on the line of its Program"), std::string::npos)
        << elsewhere;
    EXPECT_NE(elsewhere.find("write 'iResolution (vec3(window, 1))' on the line"), std::string::npos)
        << elsewhere;
}

TEST(Expressions, GoOnAfterABackslash) {
    EXPECT_EQ(
        problemsOf(
            "WindowSize 8 8\nLet pose[3] (i == 0 ? 2 \\ # (\n  : 3 \\  \r\n * pose[i - 1])  # the rest\n"
            "Let other (1 + ( \\\n 2)) \n"
            "Pass window clear \\\n (vec3(1, 0, \\\n 1))\nEndPass\n"
            "Expect (pose[2] == 18 \\\n && other == 3)\nExpect pixel 3 3 [1 0 1]\n"),
        "");
    const std::string problems = problemsOf("Let a (1 + \\\n   nonsense)\n");
    EXPECT_NE(problems.find(":2:4:"), std::string::npos) << problems;
    EXPECT_NE(problemsOf("Let a (1 + \n   2)\n").find("glib-E20"), std::string::npos);
}

// ---- Groups and files with parameters.

TEST(GroupParameters, MayBeTextures) {
    EXPECT_EQ(problemsOf(R"(WindowSize 8 8
Texture2D red 4 4 rgba8
Texture2DArray both 6 2 2 rgba8 levels 2
Texture2D out 8 8 rgba8
Texture2D outB 8 8 rgba8
Texture2D outC 8 8 rgba8
)" + showing("sampler2D", "vST") +
                         R"(Program Show
Pass red clear {1 0 0}
EndPass
Pass both.layer(1) clear {0 1 0}
EndPass
Group copy from red to out
    Set uT from
    Fill to with Show
    Draw inner from both.layer(1).level(1)
EndGroup
Group inner from red
    When (from.size.x == 3)
        Set uT from
    EndWhen
EndGroup
Draw copy
Draw copy from both.layer(1) to outB
Draw copy to outC
Fill window with Show uT red
Expect pixel 3 3 [1 0 0] of out
Expect pixel 3 3 [0 1 0] of outB
Expect pixel 3 3 [1 0 0] of outC
)"),
              "");
}

TEST(GroupParameters, MayBeVariablesByName) {
    EXPECT_EQ(problemsOf("WindowSize 8 8\nLet half .5\nGroup paint level 1\n"
                         "Pass window clear (vec3(level, 0, 0))\nEndPass\nEndGroup\n"
                         "Draw paint level half\nExpect pixel 3 3 [.5 0 0] within .01\n"),
              "");
    EXPECT_NE(problemsOf("Group paint level 1\nEndGroup\nDraw paint level lots\n"), "");
}

TEST(IncludedFiles, TakeValuesForTheirVariables) {
    const std::map<std::string, std::string> files{
        {"paint.glib",
         "Let level <0. 1. 1.>\nLet tint {0 1 0}\nPass window clear (level * tint)\nEndPass\n"}};
    EXPECT_EQ(problemsOf("WindowSize 8 8\nInclude paint.glib\nExpect pixel 3 3 [0 1 0]\n", files), "");
    EXPECT_EQ(
        problemsOf("WindowSize 8 8\nLet half (1 / 2)\nInclude paint.glib\n"
                   "Include paint.glib level half tint {1 0 1}\nExpect pixel 3 3 [.5 0 .5] within .01\n",
                   files),
        "");
    EXPECT_NE(problemsOf("Include paint.glib levle 1\n", files).find("did you mean 'level'"),
              std::string::npos);
}

TEST(MultMatrix, MultipliesTheCurrentMatrix) {
    const auto scene = [](const std::string& transforms) {
        return "WindowSize 32 32\nCamera eye LookAt 0 0 5 0 0 0 0 1 0 Perspective 50 .1 100\n" + transforms +
               "Box 1\n";
    };
    const Drawing matrix = draw(
        SceneFolder(scene("Translate 1 0 0\nMultMatrix (rotate(30, vec3(0, 0, 1)) * scale(1, 2, 1))\n")));
    const Drawing words = draw(SceneFolder(scene("Translate 1 0 0\nRotate 30 0 0 1\nScale 1 2 1\n")));
    const Drawing none = draw(SceneFolder(scene("Translate 1 0 0\n")));
    EXPECT_EQ(matrix.pixels, words.pixels);
    EXPECT_NE(matrix.pixels, none.pixels);
    EXPECT_NE(problemsOf("MultMatrix (vec3(1))\n"), "");
}

// ---- Values from the command line.

TEST(ChosenWords, SetAChoice) {
    const std::string scene =
        "WindowSize 8 8\nLet method <two_passes front_only unordered>\nLet level 1\n"
        "Pass window clear (method == unordered ? vec3(0, 1, 0) : vec3(1, 0, 0))\nEndPass\n"
        "Expect pixel 2 2 [0 1 0]\n";
    RenderOptions options;
    options.set = {"method=unordered"};
    EXPECT_EQ(problemsOf(scene, {}, options), "");
    options.set = {"method=2"};
    EXPECT_EQ(problemsOf(scene, {}, options), "");
    options.set = {"method=unorderd"};
    EXPECT_NE(problemsOf(scene, {}, options).find("did you mean 'unordered'"), std::string::npos);
    options.set = {"level=unordered"};
    EXPECT_NE(problemsOf(scene, {}, options).find("'unordered' is not a number"), std::string::npos);
    options.set = {"uKd=five"};
    EXPECT_NE(problemsOf("Sphere\n", {}, options).find("'five' is not a number"), std::string::npos);
}

// ---- Cameras of the window.

TEST(WindowTransforms, MoveTheRootOfDerivedCameras) {
    const auto scene = [](const std::string& camera) {
        return "WindowSize 32 32\nTexture2D other 32 32 rgba8\n"
               "Camera eye LookAt 0 0 5 0 0 0 0 1 0 Perspective 50 .1 100\n" +
               camera + showing("sampler2D", "vST") + R"(Program Show uT other
Vertex inline
#version 330
void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }
EndVertex
Fragment inline
#version 330
out vec4 c;
void main() { c = vec4(1.); }
EndFragment
Program White
Pass other from second
    Translate 1 0 0
    Box 1
EndPass
Pass window from eye
EndPass
Fill window with Show
)";
    };
    RenderOptions turned;
    turned.viewState.eye = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1};
    const auto pixels = [&](const std::string& camera, const RenderOptions& options) {
        return draw(SceneFolder(scene(camera)), options).pixels;
    };
    const std::string mirror = "Camera second Reflect eye 0 1 0 0\n";
    const std::string still = "Camera second LookAt 0 0 5 0 0 0 0 1 0 Perspective 50 .1 100\n";
    const std::string shifted = "Camera second Shift eye 1 0 0\n";
    EXPECT_NE(pixels(mirror, {}), pixels(mirror, turned));
    EXPECT_EQ(pixels(still, {}), pixels(still, turned));
    EXPECT_NE(pixels(shifted, {}), pixels(shifted, turned));
    // The window turns the camera before it is shifted: by half a turn the box comes from the other side.
    RenderOptions halfTurn;
    halfTurn.viewState.eye = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, -10, 1};
    const std::string behind =
        "Camera head LookAt 0 0 -5 0 0 0 0 1 0 Perspective 50 .1 100\nCamera second Shift head 1 0 0\n";
    EXPECT_EQ(pixels(shifted, halfTurn), pixels(behind, {}));
}

// ---- Names.

TEST(Names, MayBeWordsOfARepetitionOrAChoice) {
    EXPECT_EQ(problemsOf(R"(WindowSize 8 8
Let pick <one two>
Texture2D one 8 8 rgba8
Texture2D two 8 8 rgba8
Camera left LookAt 0 0 5 0 0 0 0 1 0 Perspective 50 .1 100
Camera right Shift left 1 0 0
Group red
    Pass pick clear {1 0 0}
    EndPass
EndGroup
Group green
    Pass two clear {0 1 0}
    EndPass
EndGroup
Repeat [red green] as what
    Draw what
EndRepeat
Repeat [left right] as side
    Pass window from side keep
        Material gold
        Clear color
    EndPass
EndRepeat
Expect pixel 3 3 [1 0 0] of one
Expect pixel 3 3 [0 1 0] of two
)"),
              "");
    EXPECT_NE(problemsOf("Repeat [left right] as side\nPass window from side\nEndPass\nEndRepeat\n")
                  .find("no camera 'left'"),
              std::string::npos);
}

TEST(Names, MayBeThoseOfKeys) {
    EXPECT_EQ(problemsOf("WindowSize 8 8\nTexture2D color 8 8 rgba8\nTexture2D depth 8 8 depth24\n"
                         "Buffer count uint [3]\n"
                         "Pass color depth clear {1 0 0} depth .5\nEndPass\n"
                         "Expect pixel 1 1 [.5] of depth within .001\nExpect buffer count [3]\n"),
              "");
    EXPECT_NE(problemsOf("Let rounds 3\nRepeat rounds\nEndRepeat\n").find("write (rounds)"),
              std::string::npos);
}

TEST(Groups, EvaluateTheirDefaultsWhereTheyStand) {
    const std::string end = "Sphere 1\n";
    EXPECT_EQ(
        problemsOf("WindowSize 8 8\nCamera eye (mat4(1)) (mat4(1))\nLet base (1)\nGroup inner a (base)\nLet "
                   "got (a)\nEndGroup\n"
                   "Let base (10)\nDraw inner\nExpect (got == 1)\nDraw inner a (base)\nExpect (got == 10)\n" +
                   end),
        "");
    EXPECT_EQ(problemsOf("WindowSize 8 8\nCamera eye (mat4(1)) (mat4(1))\nTranslate 1 0 0\nGroup inner a "
                         "(model[3].x)\nLet got (a)\nEndGroup\n"
                         "Translate 3 0 0\nDraw inner\nExpect (got == 1)\n" +
                         end),
              "");
    EXPECT_EQ(
        problemsOf(
            "WindowSize 8 8\nLet which 0\nTexture2D red 8 8 rgba8\nTexture2D green 8 8 rgba8\n"
            "Let pic <red green>\nPass red clear {1 0 0}\nEndPass\nPass green clear {0 1 0}\nEndPass\n" +
            showing("sampler2D", "vST") +
            "Program Copy\nGroup show what pic\nFill window with Copy uT what\nEndGroup\n"
            "Draw show\nExpect pixel 3 3 [1 0 0]\n"),
        "");
}

TEST(Groups, MayHaveDefaultsThatAreDeclaredBelow) {
    EXPECT_EQ(problemsOf("WindowSize 8 8\n" + showing("sampler2D", "vST") +
                         "Program Copy\nGroup show what pic size (pic.size.x) view cam\nLet got (size)\n"
                         "Fill window with Copy uT what\nEndGroup\nTexture2D pic 8 8 rgba8\n"
                         "Camera cam (mat4(1)) (mat4(1))\nPass pic clear {1 0 0}\nEndPass\n"
                         "Draw show\nExpect pixel 3 3 [1 0 0]\nExpect (got == 8)\n"),
              "");
    const std::string unknown = problemsOf(
        "WindowSize 8 8\nCamera eye (mat4(1)) (mat4(1))\nGroup g a nothing\n"
        "Sphere (a)\nEndGroup\nDraw g\n");
    EXPECT_EQ(std::ranges::count(unknown, '\n'), 1) << unknown;
    EXPECT_NE(unknown.find("scene.glib:3:"), std::string::npos) << unknown;
}

TEST(Groups, WithAFaultyDefaultGiveOneMessage) {
    const std::string problems = problemsOf(
        "Camera eye (mat4(1)) (mat4(1))\nLet arr [1 2 3 4 5]\n"
        "Group gg size arr\nLet got (1)\nBox\nEndGroup\nDraw gg\nDraw gg\nLet a (got)\nScale (a)\nBox\n");
    EXPECT_EQ(std::ranges::count(problems, '\n'), 1) << problems;
    EXPECT_NE(problems.find("scene.glib:3:"), std::string::npos) << problems;
}

TEST(Names, ThatAreSetBelowSayWhere) {
    const std::string problems =
        problemsOf("WindowSize 8 8\nCamera eye (mat4(1)) (mat4(1))\nTranslate (k) 0 0\nBox\nLet k 5\n");
    EXPECT_NE(problems.find("unknown name 'k'; line 5 sets it, which is below [expr-E02]"), std::string::npos)
        << problems;
}

TEST(Names, ThatAreSetAboveInVainAreNotSetBelow) {
    const std::string problems = problemsOf(
        "WindowSize 8 8\nCamera eye (mat4(1)) (mat4(1))\nGroup g\nLet k (5)\nEndGroup\nTranslate (k) 0 "
        "0\nBox\n");
    EXPECT_EQ(problems.find("below"), std::string::npos) << problems;
}

TEST(Cameras, HaveThePlanesAndTheAngleOfTheirProjection) {
    const auto holds = [](const std::string& camera, const std::string& condition) {
        return problemsOf("WindowSize 40 20\nCamera eye LookAt 1 2 5  0 .5 0  0 1 0  Perspective 40 .5 50\n" +
                          camera + "\nExpect (" + condition + ")\nBox\n");
    };
    const std::string frustum = "Camera c LookAt 1 2 5  0 .5 0  0 1 0  Frustum -1 1 -.5 .5 1 10";
    EXPECT_EQ(holds(frustum, "abs(c.fov - 2*degrees(atan(.5))) < 1e-9"), "");
    EXPECT_EQ(holds(frustum, "c.near == 1 && c.far == 10"), "");
    EXPECT_EQ(holds("Camera c LookAt 1 2 5  0 .5 0  0 1 0  Frustum -1 1 .5 2 1 10",
                    "abs(c.fov - degrees(atan(2.) - atan(.5))) < 1e-9"),
              "");
    EXPECT_EQ(holds("Camera c LookAt 1 2 5  0 .5 0  0 1 0  Ortho -1 1 -1 1 0 10",
                    "c.fov == 0 && c.near == 0 && c.far == 10"),
              "");
    const std::string made = "Camera c (mat4(1)) (perspective(30, 1.5, 1, 9))";
    EXPECT_EQ(holds(made, "abs(c.fov - 30) < 1e-9 && abs(c.near - 1) < 1e-9 && abs(c.far - 9) < 1e-9"), "");
    EXPECT_EQ(holds("Camera c (mat4(1)) (ortho(-1, 1, -1, 1, 2, 7))",
                    "c.fov == 0 && abs(c.near - 2) < 1e-9 && abs(c.far - 7) < 1e-9"),
              "");
    EXPECT_EQ(holds(made + "\nCamera d Shift c 1 0 0", "abs(d.fov - 30) < 1e-9 && abs(d.near - 1) < 1e-9"),
              "");
    EXPECT_EQ(holds("Camera c (mat4(1)) (mat4(0))", "c.fov == 0 && c.near == 0 && c.far == 0"), "");
}

}  // namespace
}  // namespace glibra::test
