// Which stages of its program a Fill takes (language, 12.5).

#include <gtest/gtest.h>

#include <string>

#include "script_problems.h"

namespace glibra::test {
namespace {

const std::string kBegin =
    "Camera eye LookAt .75 0 3  .75 0 0  0 1 0  Perspective 60 .1 100\nTexture2D picture 8 8 rgba32f\n";

/// Draws into the left half of the target alone.
const std::string kFillVertex =
    "Vertex inline\n#version 410\nvoid main() { gl_Position = vec4(.5*aVertex.x - .5, aVertex.y, 0., 1.); }\n"
    "EndVertex\n";
const std::string kTessellation =
    "TessControl inline\n#version 410\nlayout(vertices = 3) out;\n"
    "void main() { gl_out[gl_InvocationID].gl_Position = .1 * gl_in[gl_InvocationID].gl_Position;\n"
    "gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = gl_TessLevelInner[0] = 2.; }\n"
    "EndTessControl\n"
    "TessEvaluation inline\n#version 410\nlayout(triangles) in;\n"
    "void main() { gl_Position = gl_TessCoord.x*gl_in[0].gl_Position + gl_TessCoord.y*gl_in[1].gl_Position\n"
    " + gl_TessCoord.z*gl_in[2].gl_Position; }\nEndTessEvaluation\n";
const std::string kGeometry =
    "Geometry inline\n#version 410\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\n"
    "void main() { for (int i = 0; i < 3; ++i) { gl_Position = .1*gl_in[i].gl_Position; EmitVertex(); } }\n"
    "EndGeometry\n";

std::string fragment(const std::string& declarations, const std::string& color) {
    return "Fragment inline\n#version 410\n" + declarations + "out vec4 c;\nvoid main() { c = " + color +
           "; }\nEndFragment\n";
}
const std::string kPlain = fragment("", "vec4(0., 0., 1., 1.)");

TEST(ScriptFills, StagesOfEarlierProgramsAreLeftOut) {
    for (const bool hasTessellation : {false, true})
        for (const bool hasGeometry : {false, true})
            for (const bool readsPlace : {false, true}) {
                const std::string earlier = kFillVertex + (hasTessellation ? kTessellation : "") +
                                            (hasGeometry ? kGeometry : "") + kPlain + "Program Other\n";
                const std::string own =
                    readsPlace
                        ? fragment("uniform mat4 invView;\nin vec2 vST;\n", "vec4(vST, invView[3].x, 1.)")
                        : fragment("uniform mat4 invView;\n", "vec4(.4375, .9375, invView[3].x, 1.)");
                const std::string checks =
                    "Expect pixel 3 7 [.4375 .9375 .75] of picture within .001\nExpect count [.5 .5 .5 0] 0 "
                    "of picture\n";
                EXPECT_EQ(
                    problemsOf(kBegin + earlier + own + "Program Place\nFill picture with Place\n" + checks +
                               "Expect mean 0 0 8 8 [" + (readsPlace ? ".5 .5" : ".4375 .9375") +
                               " .75 1] of picture within .001\n"),
                    "")
                    << hasTessellation << hasGeometry << readsPlace;
            }
}

TEST(ScriptFills, StagesOfTheProgramItselfAreTaken) {
    const std::string half = "Expect count [0 0 1 1] 32 of picture\nExpect pixel 7 3 [0 0 0] of picture\n";
    EXPECT_EQ(problemsOf(kBegin + kPlain + "Program Other\n" + kFillVertex + kPlain +
                         "Program Own\nBackground 0 0 0\nFill picture with Own\n" + half),
              "");
    EXPECT_EQ(problemsOf(kBegin + kFillVertex + kPlain +
                         "Program Own\nBackground 0 0 0\nFill picture with Own\n" + half),
              "");
    EXPECT_EQ(problemsOf(kBegin + kFillVertex + kTessellation + kPlain + "Program Other\n" + kFillVertex +
                         kPlain + "Program Own\nBackground 0 0 0\nFill picture with Own\n" + half),
              "")
        << "a Vertex begins a new pipeline";
}

TEST(ScriptFills, DrawsWithTheSameProgramKeepItsStages) {
    EXPECT_EQ(
        problemsOf(
            kBegin + "Texture2D half 8 8 rgba32f\n" + kFillVertex + kPlain + "Program Other\n" +
            fragment("", "vec4(1., 0., 0., 1.)") +
            "Program Both\nFill picture with Both\nPass half clear {0 0 0 0}\nUse Both\nFullScreen\nEndPass\n"
            "Expect count [1 0 0 1] 64 of picture\nExpect count [1 0 0 1] 32 of half\n"),
        "");
}

TEST(ScriptFills, AnInputOfALeftOutStageIsExplained) {
    const std::string vertex =
        "Vertex inline\n#version 410\nout vec2 vUv;\nvoid main() { gl_Position = aVertex; vUv = aVertex.xy; "
        "}\nEndVertex\n";
    const std::string reads = fragment("in vec2 vUv;\n", "vec4(vUv, 0., 1.)");
    const std::string problems =
        problemsOf(kBegin + vertex + reads + "Program First\n" + reads +
                   "Program Second\nFill picture with First\nFill window with Second\n");
    EXPECT_NE(problems.find("glsl-W11"), std::string::npos) << problems;
    EXPECT_NE(problems.find("write them again before this one"), std::string::npos) << problems;
    EXPECT_EQ(problems.find("glsl-W11"), problems.rfind("glsl-W11")) << problems;
}

}  // namespace
}  // namespace glibra::test
