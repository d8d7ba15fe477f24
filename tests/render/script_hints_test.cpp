// Mistakes in modern scenes that would only show as a wrong picture.

#include <gtest/gtest.h>

#include <regex>
#include <sstream>
#include <string>

#include "script_problems.h"

namespace glibra::test {
namespace {

/// The messages of drawing a scene and answering its checks, without notes and folders.
std::string mistakesIn(const std::string& scene) {
    std::istringstream lines(problemsOf(scene));
    std::string found;
    for (std::string line; std::getline(lines, line);) {
        if (line.find(": note: ") != std::string::npos) continue;
        found += (found.empty() ? "" : "\n") +
                 std::regex_replace(line, std::regex("[^ (]*/scene.glib"), "scene.glib");
    }
    return found;
}

/// A program that draws in one colour, given as GLSL.
std::string painting(const std::string& name, const std::string& color) {
    return "Fragment inline\n#version 410 core\nout vec4 fColor;\nvoid main() { fColor = " + color +
           "; }\nEndFragment\nProgram " + name + "\n";
}

TEST(RasterState, IsReportedIfAPassDoesNotTakeItOver) {
    const std::string begin = "WindowSize 8 8\nTexture2D t 4 4 rgba8\n" + painting("Red", "vec4(1, 0, 0, 1)");
    EXPECT_EQ(
        mistakesIn(begin + R"(Viewport 0 0 .5 .5
Pass window
    Use Red
    FullScreen
EndPass
Expect pixel 7 7 [1 0 0]
)"),
        "scene.glib:9:1: warning: Viewport has no effect: Pass (line 10) begins with the default state; "
        "move it into the pass [glib-W39]");
    EXPECT_EQ(mistakesIn(begin + "Scissor 0 0 .5 .5\nFill t with Red\nFill window with Red\n"),
              "scene.glib:9:1: warning: Scissor has no effect: Fill (line 10) begins with the default state "
              "[glib-W39]");
    EXPECT_EQ(mistakesIn(begin + R"(State cull back
Pass t
    Use Red
    FullScreen
EndPass
Use Red
Scissor 0 0 .5 1
Fill t with Red
FullScreen
Expect pixel 1 1 [1 0 0]
Expect pixel 6 1 [0 0 0] within .2
)"),
              "")
        << "draws after the pass take it over";
}

TEST(LayeredTargets, AreReportedIfOnlyTheFirstLayerIsDrawnInto) {
    const std::string begin = "WindowSize 8 8\nCubeMap sky 8 rgba8\nTexture2DArray rows 8 8 3 rgba8\n";
    const std::string end =
        showing("samplerCube", "vec3(1)") + "Program Show uT sky\nFill window with Show\n";
    EXPECT_NE(mistakesIn(begin + painting("Red", "vec4(1, 0, 0, 1)") + "Fill sky with Red\n" + end)
                  .find("scene.glib:10:1: warning: 'sky' has 6 faces, but only face 0 is drawn into: name "
                        "one, such as 'sky.face(0)', or write gl_Layer in a geometry stage [draw-W14]"),
              std::string::npos);
    const auto layers = [&](const std::string& target) {
        return mistakesIn(begin + coveringLayers(3, "vec4(1, 0, 0, 1)") + painting("Red", "vec4(1)") +
                          "Pass " + target + R"(
    Use Layers
    Vertices points 1
EndPass
Fill rows.layer(1) with Red
)" + showing("sampler2DArray", "vec3(vST, 2)") +
                          "Program Show uT rows\nFill window with Show\nExpect pixel 1 1 [1 0 0]\n");
    };
    EXPECT_EQ(layers("rows").find("draw-W14"), std::string::npos);
}

TEST(Attributes, ThatResembleAnInputOfTheShapeAreReported) {
    const std::string shaders = R"(WindowSize 8 8
Vertex inline
#version 410 core
in vec3 position, normal;
out vec3 vN;
void main() { vN = normal; gl_Position = vec4(position.xy, 0, 1); }
EndVertex
Fragment inline
#version 410 core
in vec3 vN;
out vec4 fColor;
void main() { fColor = vec4(vN, 1); }
EndFragment
Program Show
Pass window
    Use Show
)";
    EXPECT_EQ(
        mistakesIn(shaders + "    Attribute normall 0 1 0\n    Sphere 3\nEndPass\n"),
        "scene.glib:17:5: warning: Attribute: program 'Show' has no vertex input 'normall'; did you mean "
        "'normal'? [draw-W15]");
    EXPECT_EQ(mistakesIn(shaders + "    Attribute normal 0 1 0\n    Attribute heat 1\n    Sphere 3\nEndPass\n"
                                   "Expect pixel 4 4 [0 1 0]\n"),
              "")
        << "other programs may read it";
}

/// Copies the storage block `Items` into the buffer `sums`.
std::string copying(const std::string& declarations, const std::string& items, const std::string& value) {
    return "WindowSize 8 8\n" + declarations + R"(
Compute inline
#version 430 core
layout(local_size_x = 1) in;
)" + items +
           R"(
buffer sums { float sum[]; };
void main() { sum[0] = )" +
           value + ";  }\nEndCompute\nProgram Copy\nDispatch Copy 1 1 1\nExpect buffer sums at 0 [3]\n";
}

TEST(BufferTypes, ThatABlockContradictsAreReported) {
    const std::string sums = "Buffer sums float 4\n";
    EXPECT_EQ(mistakesIn(copying(sums + "Buffer Items float [3 4]", "buffer Items { float v[]; };", "v[0]")),
              "");
    EXPECT_EQ(
        mistakesIn(copying(sums + "Buffer Items float [3 4 5 6]", "buffer Items { vec2 v[]; };", "v[0].x")),
        "")
        << "the numbers of the elements";
    EXPECT_EQ(
        mistakesIn(copying(sums + "Buffer Items uint [3 4]", "buffer Items { int v[]; };", "float(v[0])")),
        "");
    EXPECT_EQ(
        mistakesIn(copying(sums + "Buffer Items uint [3 4]", "buffer Items { float v[]; };", "v[0]")),
        "scene.glib:3:1: warning: buffer 'Items' is declared with the type uint, but the elements of "
        "storage block 'Items' (scene.glib:7) differ from it and decide; leave out the type, or make them "
        "the same [memory-W03]");
    EXPECT_NE(
        mistakesIn(copying(sums + "Buffer Items vec4 [3 4 5 6]", "buffer Items { vec3 v[]; };", "v[0].x"))
            .find("memory-W03"),
        std::string::npos);
}

TEST(MissingBuffers, AreComparedWithTheNamesOfTheScene) {
    EXPECT_NE(mistakesIn(copying("Buffer sums float 4\nBuffer item float [3]", "buffer items { float v[]; };",
                                 "v[0]"))
                  .find("or give the tag 'items' a buffer; did you mean 'item'? [memory-E02]"),
              std::string::npos);
}

TEST(Uniforms, OfASetWhoseScopeHasEndedAreExplained) {
    EXPECT_NE(
        mistakesIn(R"(WindowSize 8 8
Fragment inline
#version 410 core
uniform float uHeights[3];
out vec4 fColor;
void main() { fColor = vec4(uHeights[0], uHeights[1], uHeights[2], 1); }
EndFragment
Program Show
Pass window
    Use Show
    Repeat 3 as k
        Set uHeights[k] (k/2)
    EndRepeat
    FullScreen
EndPass
)")
            .find("uniform 'uHeights' of 'Show' is not set; it is 0; the Set of 'uHeights[0]' in line 12 "
                  "ends with its scope (a round of Repeat, a Pass or a Group) [glib-W37]"),
        std::string::npos);
}

TEST(ArraysOfUniforms, MayHaveANamedConstantAsTheirSize) {
    EXPECT_EQ(mistakesIn(R"(WindowSize 8 8
Fragment inline
#version 410 core
const int kRows = 2, kCount = 2 * kRows;
uniform float uHeights[kCount];
out vec4 fColor;
void main() { fColor = vec4(uHeights[0], uHeights[1], 0, 1); }
EndFragment
Program Show uHeights [1 .5 .25 .125]
Fill window with Show
Expect pixel 1 1 [1 .5 0] within .01
)"),
              "");
}

TEST(WriteMasks, CanBeThoseOfOneTarget) {
    const std::string scene = R"(WindowSize 8 8
Texture2D a 4 4 rgba8
Texture2D b 4 4 rgba8
Fragment inline
#version 410 core
layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;
void main() { first = second = vec4(1); }
EndFragment
Program Both
Pass a b clear {0 0 0 0}
    Use Both
    State write.1 g
    FullScreen
EndPass
)";
    EXPECT_EQ(mistakesIn(scene + "Expect pixel 1 1 [1 1 1 1] of a\nExpect pixel 1 1 [0 1 0 0] of b\n"), "");
    EXPECT_EQ(mistakesIn("WindowSize 8 8\nPass window\n    State write.8 rgb\n    Sphere 1\nEndPass\n"),
              "scene.glib:3:11: error: State: write.8: colour targets are 0 to 7 [glib-E05]");
}

TEST(Counts, MayBeExpectedWithinATolerance) {
    const std::string scene = "WindowSize 8 8\nPass window\n    Vertices triangles 30\nEndPass\n";
    EXPECT_EQ(mistakesIn(scene + "Expect primitives 12 within 2\n").find("check-"), std::string::npos);
    EXPECT_NE(
        mistakesIn(scene + "Expect primitives 12 within 1\n")
            .find("Expect primitives 12 within 1: expected 12 primitives within 1, found 10 [check-E01]"),
        std::string::npos);
}

TEST(UnknownNames, ThatAnEarlierStageDeliversAreExplainedOnce) {
    const std::string found = mistakesIn(R"(WindowSize 8 8
Vertex inline
#version 410 core
in vec3 position, normal;
out vec3 vN;
void main() { vN = normal; gl_Position = vec4(position, 1); }
EndVertex
Fragment inline
#version 410 core
out vec4 fColor;
void main() { fColor = vec4(vN * 2., dot(vN, vN)); }
EndFragment
Program Show
Pass window
    Use Show
    Sphere 1
EndPass
)");
    EXPECT_NE(found.find("; declare 'in vec3 vN;' in this stage [glsl-E01]"), std::string::npos) << found;
    EXPECT_EQ(found.find("error"), found.rfind("error")) << found;
}

TEST(Hints, NeverProposeTheWordItself) {
    for (const char* state : {"blend src_alpha", "blend one", "stencilop keep keep",
                              "blend one one alpha one", "BLEND SRC_ALPHA"}) {
        const std::string problems =
            problemsOf(std::string("Camera eye (mat4(1)) (mat4(1))\nState ") + state + "\nBox\n");
        EXPECT_EQ(problems.find("did you mean"), std::string::npos) << problems;
        EXPECT_NE(problems.find("scene.glib:2:"), std::string::npos) << problems;
    }
    const std::string bracket = problemsOf("Camera eye (mat4(1)) (mat4(1))\nTranslate (1 -2) 0 0\nBox\n");
    EXPECT_EQ(bracket.find("write (-2))"), std::string::npos) << bracket;
    const std::string type =
        problemsOf("Buffer bb flot 4\nCamera eye (mat4(1)) (mat4(1))\nBox\nExpect (bb.count == 4)\n");
    EXPECT_NE(type.find("did you mean 'float'?"), std::string::npos) << type;
}

TEST(Hints, AnIntegerBufferSaysWhatItCuts) {
    EXPECT_NE(problemsOf("Buffer p uint [1 2 3.5]\nCamera eye (mat4(1)) (mat4(1))\nBox\n")
                  .find("1:15: warning: 3.5 is cut to 3 [glib-W27]"),
              std::string::npos);
    EXPECT_EQ(problemsOf("Buffer p int [1 2 3.]\nBuffer q float [.5]\nCamera eye (mat4(1)) (mat4(1))\nBox\n"),
              "");
}

TEST(Hints, ALoopThatNeverEndsIsNamedInsteadOfWhatFollows) {
    for (const char* loop : {"while (true) { s += .1; }", "for (int i = 0; i < 3; ) s += 1.;"}) {
        const SceneFolder folder(
            std::string(
                "WindowSize 8 8\nFragment inline\n#version 330\nout vec4 c;\nvoid main() { float s = 0.;\n") +
            loop + "\nc = vec4(s);\n}\nEndFragment\nProgram P\nFill window with P\n");
        render::Stats stats;
        // It is not drawn: some drivers keep the loop.
        const auto scene = render::SceneRenderer::load(sharedContext(), folder / "scene.glib", {}, stats);
        const std::string found = text(scene.diagnostics);
        EXPECT_EQ(found.find("draw-W10"), std::string::npos) << found;
        EXPECT_TRUE(found.empty() || found.find("6:1: warning: this loop never ends") != std::string::npos)
            << found;
    }
}

}  // namespace
}  // namespace glibra::test
