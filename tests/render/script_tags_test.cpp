// Tags with members and subscripts, values of Repeat, and messages about programs and their targets
// (language, 12.1 to 12.6).

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "script_problems.h"

namespace glibra::test {
namespace {

/// A scene of one program, whose fragment stage has these declarations and gives this colour.
std::string sceneOf(const std::string& declarations, const std::string& color, const std::string& after) {
    return "WindowSize 8 8\nFragment inline\n#version 330\nin vec2 vST; out vec4 c;\n" + declarations +
           "\nvoid main() { c = " + color + "; }\nEndFragment\n" + after;
}

const std::string kBlocks =
    "layout(std140) uniform Light { vec4 c; vec4 d[2]; } lights[4];\n"
    "layout(std140) uniform One { vec4 e; } one;";
const std::string kSumOfBlocks = "lights[2].c + lights[1].d[1] + one.e + lights[3].c";

const std::string kStructures =
    "struct Inner { vec3 p; float q[2]; };\nstruct Material { vec4 ambient; Inner inner; Inner more[2]; };\n"
    "uniform Material material, lights[2];";
const std::string kSumOfStructures =
    "material.ambient + vec4(material.inner.p, 0.)*material.inner.q[1] + lights[1].more[1].q[0] + "
    "lights[0].ambient";

/// The messages without those about members that are not set.
std::string withoutUnset(const std::string& problems) {
    std::string rest;
    for (std::size_t at = 0; at < problems.size();) {
        const std::size_t end = std::min(problems.find('\n', at), problems.size());
        const std::string line = problems.substr(at, end - at);
        if (line.find("glib-W37") == std::string::npos) rest += line + "\n";
        at = end + 1;
    }
    return rest;
}

void expectContains(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
}

TEST(Tags, NameMembersOfArraysOfBlocks) {
    const std::string check = "Fill window with P\nExpect pixel 5 5 [.25 .5 .75 1]\n";
    EXPECT_EQ(
        withoutUnset(problemsOf(sceneOf(
            kBlocks, kSumOfBlocks,
            "Program P  lights[2].c [.25 0 0 1]  lights[1].d[1] [0 .5 0 0]  one.e [0 0 .75 0]\n" + check))),
        "");
    EXPECT_EQ(
        withoutUnset(problemsOf(sceneOf(kBlocks, kSumOfBlocks,
                                        "Program P\nSet lights[2].c [.25 0 0 1]  lights[1].d[1] [0 .5 0 0]\n"
                                        "Set one.e [0 0 .75 0]\n" +
                                            check))),
        "");
}

TEST(Tags, BindABufferToOneBlockOfAnArray) {
    EXPECT_EQ(withoutUnset(problemsOf(sceneOf(
                  kBlocks, kSumOfBlocks,
                  "Buffer values vec4 3 [0 .5 0 1  0 0 0 0  0 0 0 0]\nProgram P  lights[2].c [.25 0 0 0]\n"
                  "Set lights[3] values\nFill window with P\nExpect pixel 5 5 [.25 .5 0 1]\n"))),
              "");
}

TEST(Tags, NameMembersOfStructuresInEveryModernScene) {
    const std::string tags =
        "material.ambient [.25 0 0 1]  material.inner.q[1] 1  lights[1].more[1].q[0] <0 .25 1>  "
        "lights[0].ambient {0 0 .5}  material.inner.p [0 .25 0]\n";
    const std::string check = "Fill window with P\nExpect pixel 5 5 [.5 .5 .75 1]\n";
    EXPECT_EQ(withoutUnset(problemsOf(sceneOf(kStructures, kSumOfStructures, "Program P  " + tags + check))),
              "")
        << "nothing that declares a name stands before the Program";
    EXPECT_EQ(
        withoutUnset(problemsOf(sceneOf(kStructures, kSumOfStructures, "Program P\nSet " + tags + check))),
        "");
    EXPECT_EQ(withoutUnset(problemsOf(
                  sceneOf(kStructures, kSumOfStructures,
                          "Program P\nFill window with P  " + tags + "Expect pixel 5 5 [.5 .5 .75 1]\n"))),
              "");
}

TEST(Tags, TakeExpressionsAsSubscripts) {
    EXPECT_EQ(withoutUnset(problemsOf(sceneOf(
                  kStructures, "material.more[0].q[0] + lights[0].ambient + lights[1].ambient",
                  "Let one 1\nProgram P  lights[one - 1].ambient [0 0 .25 0]\nRepeat 2 as k\nUse P\n"
                  "Viewport (k/2) 0 .5 1\nSet lights[k].ambient [(1 - k) (k) 0 1]\nFullScreen\nEndRepeat\n"
                  "Expect pixel 1 5 [1 0 0 1]\nExpect pixel 6 5 [0 1 .25 1]\n"))),
              "");
    expectContains(
        problemsOf(sceneOf(kStructures, kSumOfStructures,
                           "Program P\nSet lights[0 - 2].ambient [1 1 1 1]\nFill window with P\n")),
        "subscript -2 is not between 0 and");
}

TEST(Tags, TakeAChoiceOfTexturesInParentheses) {
    EXPECT_EQ(problemsOf("Texture2D red 8 8 rgba8\nTexture2D blue 8 8 rgba8\nLet shown <red blue>\n"
                         "Pass red clear {1 0 0}\nEndPass\nPass blue clear {0 0 1}\nEndPass\n" +
                         sceneOf("uniform sampler2D uMap;", "texture(uMap, vST)",
                                 "Program P  uMap (shown)\nFill window with P\nExpect pixel 5 5 [1 0 0]\n")),
              "");
}

TEST(Tags, WithSeveralNumbersShowTheirBrackets) {
    expectContains(problemsOf(sceneOf("uniform vec3 uColor;", "vec4(uColor, 1.)",
                                      "Let k 1\nProgram P  uColor 1 .5 0\nFill window with P\n")),
                   "surplus argument '.5'; write uColor [1 .5 0]");
}

TEST(Tags, WithWrongMembersGetASuggestion) {
    const auto found = [](const std::string& tag) {
        return problemsOf(sceneOf(kStructures, kSumOfStructures,
                                  "Let k 1\nProgram P  " + tag + " 3\nFill window with P\n"));
    };
    expectContains(found("material.ambint"), "did you mean 'material.ambient'?");
    expectContains(found("material.innr.p"), "did you mean 'material.inner.p'?");
    expectContains(found("material.inner.r"), "the members of 'material.inner' are p, q");
    expectContains(found("lights[7].ambient"), "'lights' has 2 elements");
    expectContains(found("lights.ambient"), "'lights' is an array, so write 'lights[0].'");
    expectContains(found("material.ambient.x"), "'material.ambient' is of type vec4, which has no members");
    const std::string set = problemsOf(sceneOf(kStructures, kSumOfStructures,
                                               "Program P\nSet material.ambent [1 1 1 1]\n"
                                               "Set materal.ambient [1 1 1 1]\nFill window with P\n"));
    expectContains(
        set, "no program of the scene has a uniform 'material.ambent'; did you mean 'material.ambient'?");
    expectContains(
        set, "no program of the scene has a uniform 'materal.ambient'; did you mean 'material.ambient'?");
}

TEST(Tags, ThatAreMissingForManyMembersAreReportedOnce) {
    const std::string problems =
        problemsOf(sceneOf(kStructures, kSumOfStructures, "Program P\nFill window with P\n"));
    expectContains(problems, "members of 'lights' of 'P' are not set; they are 0. The first is 'lights[0].");
    EXPECT_EQ(problems.find("'lights[1]."), std::string::npos) << problems;
}

TEST(Tags, GiveAMat3TheUpperLeftPartOfAMat4) {
    EXPECT_EQ(problemsOf(sceneOf("uniform mat3 uM, turn;", "vec4(uM * vec3(0., 0., .5) + turn[1], 1.)",
                                 "Let turn (translate(7, 8, 9))\n"
                                 "Program P  uM (translate(1, 2, 3) * scale(1, 1, 2))\nFill window with P\n"
                                 "Expect pixel 5 5 [0 1 1 1]\n")),
              "");
}

TEST(Repeat, RunsOverValues) {
    const std::string colors =
        "Let red {1 0 0}\nLet blue {0 0 1}\nProgram P\nRepeat [red (vec3(0, 1, 0)) blue] as c\n"
        "Viewport (c.index/4) 0 .25 1\nSet uColor (c)\nFullScreen\nEndRepeat\n"
        "Expect pixel 1 5 [1 0 0]\nExpect pixel 3 5 [0 1 0]\nExpect pixel 5 5 [0 0 1]\n";
    EXPECT_EQ(problemsOf(sceneOf("uniform vec3 uColor;", "vec4(uColor, 1.)", colors)), "");
    EXPECT_EQ(problemsOf(sceneOf("uniform float uValue;", "vec4(vec3(uValue), 1.)",
                                 "Program P\nRepeat [.25 .75] as v\nViewport (v.index/2) 0 .5 1\n"
                                 "Set uValue (v)\nFullScreen\nEndRepeat\nExpect pixel 1 5 [.25]\n"
                                 "Expect pixel 6 5 [.75]\n")),
              "");
    expectContains(problemsOf("Let red {1 0 0}\nRepeat [red 2] as c\nEndRepeat\n"),
                   "Repeat: the first value is vec3, but this one is number");
    expectContains(problemsOf("Repeat [{1 0 0} {0 1 0}] as c\nEndRepeat\n"),
                   "write a vector as (vec3(1, 0, 0))");
}

/// Two targets, the second of them blue, and a program that writes the first `outputs` ones.
std::string twoTargets(const std::string& outputs, const std::string& main) {
    return "WindowSize 8 8\nTexture2D a 8 8 rgba8\nTexture2D b 8 8 rgba8\nFragment inline\n#version 330\n" +
           outputs + "\nvoid main() { " + main +
           " }\nEndFragment\nProgram P\nPass a b clear {0 0 0 0} {0 0 1 1}\nUse P\nFullScreen\nEndPass\n"
           "Expect pixel 5 5 [0 0 1 1] of b\n";
}

TEST(Outputs, ThatAreMissingLeaveTheTargetAsItIs) {
    const std::string one =
        problemsOf(twoTargets("out vec4 c;", "c = vec4(1.);") + "Expect pixel 1 1 [1 1] of a\n");
    expectContains(
        one,
        "program 'P' has no output for target 'b' (line 3), so the draw leaves it as it is; declare "
        "'layout(location = 1) out vec4 ...'");
    EXPECT_EQ(one.find("error"), std::string::npos) << one;
    const std::string none = problemsOf(twoTargets("in vec2 vST;", "if (vST.x > 2.) discard;"));
    expectContains(none, "the fragment stage of program 'P' has no output");
    EXPECT_EQ(none.find("error"), std::string::npos) << none;
    EXPECT_EQ(
        problemsOf("WindowSize 8 8\nFragment inline\n#version 330\nvoid main() {}\nEndFragment\nProgram P\n"
                   "Pass window clear {0 0 1}\nState write none\nUse P\nFullScreen\nEndPass\n"
                   "Expect pixel 5 5 [0 0 1]\n"),
        "");
}

TEST(ScriptChecks, CountPrimitivesThatAreOutOfSight) {
    EXPECT_EQ(
        problemsOf("WindowSize 8 8\nCamera eye LookAt 0 0 5 0 0 0 0 1 0 Perspective 40 1 20\n"
                   "Vertex inline\n#version 330\nin vec4 aVertex; uniform mat4 uModelViewProjectionMatrix;\n"
                   "void main() { gl_Position = uModelViewProjectionMatrix*aVertex; }\nEndVertex\n"
                   "Fragment inline\n#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); }\nEndFragment\n"
                   "Program P\nQuadXY 1 1 1 1\nPushMatrix\nTranslate 100 0 0\nQuadXY 1 1 1 1\nPopMatrix\n"
                   "Expect primitives 4\n"),
        "");
}

TEST(Clearing, TakesOneNumberForAllComponents) {
    EXPECT_EQ(
        problemsOf(
            "WindowSize 8 8\nTexture2D t 8 8 r32ui\nTexture2D u 8 8 rgba32i\nPass t clear {7}\nEndPass\n"
            "Pass u clear {5}\nEndPass\nExpect pixel 1 1 [7] of t\nExpect pixel 1 1 [5 5 5 5] of u\n"),
        "");
    expectContains(problemsOf("Let x {0}\n"), "a colour has 3 or 4 components, not 1");
}

TEST(Textures, ThatNothingWritesAreReported) {
    const std::string reads = sceneOf("uniform sampler2D never;", "texture(never, vST)", "Program P\n");
    const std::string found = problemsOf("Texture2D never 8 8 rgba8\n" + reads + "Fill window with P\n");
    expectContains(found, "texture 'never' (line 1) is read here, but nothing draws or writes into it");
    EXPECT_EQ(problemsOf("Texture2D never 8 8 rgba8\n" + reads + "Clear never\nFill window with P\n"), "");
    EXPECT_EQ(problemsOf("Texture2D never 8 8 rgba8\n" + reads +
                         "When (time > 1)\nPass never\nEndPass\nEndWhen\nFill window with P\n"),
              "")
        << "another frame may write it";
}

TEST(Tags, OfArraysMayHaveAllDeclaredElements) {
    const auto found = [](const std::string& values) {
        return problemsOf(
            "WindowSize 8 8\nFragment inline\n#version 330\nuniform float w[4];\n"
            "out vec4 c;\nvoid main() { c = vec4(w[1]); }\nEndFragment\nProgram P w " +
            values + "\nFill window with P\n");
    };
    EXPECT_EQ(found("[0 .5 .25 1]"), "");
    expectContains(found("[0 .5]"), "2 values in [ ]; float[4] takes 4, so the rest is 0");
    expectContains(found("[0 .5 .25 1 2]"), "5 values in [ ]; float[4] takes 4, so the surplus is ignored");
}

TEST(Textures, WithoutTheirLevelsAreReported) {
    const std::string show = showing("sampler2D", "vST") + "Program Show uT g\n";
    const auto found = [&](const std::string& options, const std::string& text = {}) {
        return problemsOf("WindowSize 8 8\nTexture2D g 64 64 rgba8 " + options + "\n" + show +
                          "Pass g clear {1 0 0}\nEndPass\n" + text + "Fill window with Show\n");
    };
    expectContains(found("mipmap"),
                   "warning: only level 0 of 'g' (line 2) is written, but it is read with mipmaps; write "
                   "'generate' or 'levels 1' [draw-W13]");
    EXPECT_EQ(found("mipmap generate"), "");
    EXPECT_EQ(found("mipmap levels 1"), "");
    EXPECT_EQ(found(""), "");
    EXPECT_EQ(found("mipmap levels 2", "Pass g.level(1) clear {1 0 0}\nEndPass\n"), "");
}

TEST(Textures, ThatTheFrameReadsBeforeItWritesThemAreReported) {
    const std::string begin = "Texture2D pic 8 8 rgba8\nTexture2D other 8 8 rgba8\n" +
                              showing("sampler2D", "vST") + "Program Copy uT pic\nProgram Back uT other\n";
    const auto found = [&](const std::string& text) { return problemsOf(begin + text); };
    const std::string write = "Pass pic clear {1 0 0}\nEndPass\n";
    const std::string show = "Fill window with Copy\n";
    EXPECT_EQ(found(write + show), "");
    expectContains(found(show + write),
                   "12:1: warning: texture 'pic' is read here, but written only below (line 13), so it is "
                   "zero; write it before this line [draw-W11]");
    EXPECT_EQ(found("Once\n" + write + "EndOnce\n" + show + write), "");
    EXPECT_EQ(found("Step 5\n" + write + "EndStep\n" + show + write), "");
    EXPECT_EQ(found("Repeat 2\n" + show + write + "EndRepeat\n"), "") << "later rounds read it";
    EXPECT_EQ(found("Fill other with Copy\nFill pic with Back\n" + show), "") << "they take turns";
    expectContains(found("Fill other with Copy\n" + write + "Fill window with Back\n"),
                   "texture 'pic' is read here, but written only below (line 13)");
}

TEST(Textures, WhosePreviousCopyIsZeroAreReported) {
    const std::string begin =
        "WindowSize 8 8\nTexture2D acc 8 8 rgba16f history\nFragment inline\n#version 330\nin vec2 vST;\n"
        "out vec4 c;\nuniform sampler2D uLast;\nvoid main() { c = texture(uLast, vST) + .25; }\n"
        "EndFragment\nProgram Acc\n";
    const std::string add = "Fill acc with Acc uLast acc.prev\n";
    expectContains(problemsOf(begin + add + "Expect pixel 4 4 [.25] of acc\n"),
                   "11:1: warning: 'acc.prev' is read here, but only the frame writes 'acc', so it is zero; "
                   "write 'acc' in Step [draw-W11]");
    EXPECT_EQ(problemsOf(begin + add + add + "Expect pixel 4 4 [.5] of acc\n"), "");
    EXPECT_EQ(problemsOf(begin + "Step 1\n" + add + "EndStep\nFill window with Acc uLast acc.prev\n"), "");
}

TEST(Textures, AreNotReportedWhereTheProgramThatWritesThemDoesNotCompile) {
    const std::string found = problemsOf(
        "Texture2D pic 8 8 rgba8\nCompute inline\n#version 430\nlayout(local_size_x = 8, local_size_y = 8) "
        "in;\n"
        "layout(rgba8) writeonly uniform image2D pic;\n"
        "void main() { imageStore(pic, ivec2(gl_GlobalInvocationID.xy), missing); }\nEndCompute\n"
        "Program Trace\nDispatch Trace over pic\n" +
        showing("sampler2D", "vST") + "Program Show uT pic\nFill window with Show\n");
    expectContains(found, "missing");
    EXPECT_EQ(found.find("nothing draws or writes"), std::string::npos) << found;
}

TEST(Messages, ThatFollowFromErrorsAreLeftOut) {
    const std::string problems = problemsOf(
        "Texture2D pic 8 8 rgba8\nCamera light LookAt 0 0 5 0 0 0 0 1 0 Perspective 40 1 20\nLet gain (1 + "
        "foo)\n" +
        sceneOf("uniform sampler2D pic; uniform float gain;", "texture(pic, vST)*gain",
                "Program P\nPass pic frm light\nEndPass\nFill window with P\n"));
    expectContains(problems, "did you mean 'from'?");
    expectContains(problems, "unknown name 'foo'");
    EXPECT_EQ(problems.find("warning"), std::string::npos) << problems;
    EXPECT_EQ(problems.find("note"), std::string::npos) << problems;
}

TEST(Messages, SuggestKeysOfStateAndTheWindow) {
    expectContains(problemsOf("Camera eye LookAt 0 0 5 0 0 0 0 1 0 Perspective 40 1 20\nBlend add\n"),
                   "unknown command 'Blend'; write 'State blend'");
    expectContains(problemsOf(sceneOf("", "vec4(1.)", "Program P\nFill windw with P\n")),
                   "did you mean 'window'?");
    expectContains(problemsOf("State pointsize 4\n"), "; PointSize is a statement of its own");
    expectContains(problemsOf("Camera LookAt 0 0 5 0 0 0 0 1 0\n"), "; write a name before 'LookAt'");
    expectContains(problemsOf("Let pressed (mouse.dwn)\n"), "'dwn'; did you mean 'down'?");
}

TEST(GeometryWords, OfAnEarlierProgramGiveWayInSilence) {
    const auto scene = [](const std::string& between) {
        return "WindowSize 8 8\nLet z 1\nVertex inline\n#version 330\nin vec3 aPosition;\n"
               "void main() { gl_Position = vec4(aPosition, 1.); }\nEndVertex\nGeometry inline\n#version "
               "330\n"
               "void main() { for (int i = 0; i < 2; i++) { gl_Position = gl_in[i].gl_Position; "
               "EmitVertex(); } }\n"
               "EndGeometry\nFragment inline\n#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); "
               "}\nEndFragment\n"
               "GeometryInput lines\nGeometryOutput line_strip\nGeometryVerticesOut 2\nProgram A\n"
               "glBegin gl_lines\nglVertex 0 0 0\nglVertex 1 1 0\nglEnd\nGeometry inline\n#version 330\n"
               "layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n"
               "void main() { for (int i = 0; i < 3; i++) { gl_Position = gl_in[i].gl_Position; "
               "EmitVertex(); } }\n"
               "EndGeometry\n" +
               between +
               "Program B\nglBegin gl_triangles\nglVertex 0 0 0\nglVertex 1 1 0\nglVertex 0 1 0\nglEnd\n";
    };
    EXPECT_EQ(problemsOf(scene("")).find("glsl-W16"), std::string::npos) << problemsOf(scene(""));
    expectContains(problemsOf(scene("GeometryInput lines\n")), "glsl-W16");
}

TEST(Fill, CoversTheTargetDespiteAGeometryStageForOtherShapes) {
    EXPECT_EQ(
        problemsOf(
            "WindowSize 8 8\nTexture2D pic 8 8 rgba8\nCamera eye LookAt 0 0 5 0 0 0 0 1 0 "
            "Perspective 40 1 20\nVertex inline\n#version 330\nin vec3 aPosition;\n"
            "void main() { gl_Position = vec4(.1*aPosition, 1.); }\nEndVertex\nGeometry inline\n"
            "#version 330\nlayout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n"
            "void main() { for (int i = 0; i < 3; i++) { gl_Position = gl_in[i].gl_Position; "
            "EmitVertex(); } }\nEndGeometry\nFragment inline\n#version 330\nout vec4 c;\n"
            "void main() { c = vec4(1.); }\nEndFragment\nProgram Shapes\nPass pic\nQuadXY 1 1\nEndPass\n" +
            sceneOf("uniform sampler2D pic;", "vec4(vST, 0., 1.) + 0.*texture(pic, vST)",
                    "Program P\nFill window with P\nExpect pixel 7 7 [.9375 .9375 0 1] within .01\n")),
        "");
}

}  // namespace
}  // namespace glibra::test
