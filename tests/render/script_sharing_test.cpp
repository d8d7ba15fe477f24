// What groups and shaders of one scene share: cameras as parameters, GLSL by name, several targets of Fill
// (language, 12.2 and 12.5).

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "modern_text.h"
#include "script_problems.h"

namespace glibra::test {
namespace {

// ---- Cameras as parameters of groups.

const std::string kSharedCameras =
    "Camera a LookAt 0 0 5  0 0 0  0 1 0  Perspective 50 .1 100\n"
    "Camera b LookAt 4 0 5  4 0 0  0 1 0  Perspective 50 .1 100\n"
    "Camera side[3] LookAt (10 + i) 0 5  (10 + i) 0 0  0 1 0  Perspective 50 .1 100\n"
    "Texture2D t 8 8 rgba32f\nBackground 0 0 0\n"
    "Vertex inline\n#version 330\nin vec4 position;\nuniform mat4 mvp;\nvoid main() { gl_Position = "
    "mvp*position; }\n"
    "EndVertex\nFragment inline\n#version 330\nuniform float uX;\nout vec4 c;\nvoid main() { c = vec4(uX, "
    "1., 0., 1.); }\n"
    "EndFragment\nProgram Show\n";

/// Draws a sphere where the camera looks, in the colour of its place; elsewhere the middle stays black.
const std::string kView =
    "Group all\nPass window from b\nEndPass\nPass window from side[0]\nEndPass\nEndGroup\n"
    "Group view cam a\nPass t from cam\nTranslate (cam.position.x) 0 0\nSet uX (cam.prev.position.x)\n"
    "Sphere 1\nEndPass\nEndGroup\n";

TEST(ScriptSharing, AGroupSeesThroughTheCameraThatItIsGiven) {
    const std::string copy = showing("sampler2D", "vST") + "Program Copy\n";
    for (const auto& [draws, x] : std::vector<std::pair<std::string, std::string>>{
             {"Draw view", "0"},
             {"Draw view cam b", "4"},
             {"Draw view cam side[2]", "12"},
             {"Repeat 2 as i\nDraw view cam side[i]\nEndRepeat", "11"},
             {"Repeat [a b] as c\nDraw view cam c\nEndRepeat", "4"},
             {"Group outer c a\nDraw view cam c\nEndGroup\nDraw outer c b", "4"},
             {"Group outer cam b\nDraw view cam cam\nEndGroup\nDraw outer", "4"},
             {"Group moved cam a\nCamera c Shift cam 3 0 0\nDraw view cam c\nEndGroup\nDraw moved cam b",
              "7"},
             {"Let which <a b>\nDraw view cam which", "0"},
         })
        EXPECT_EQ(problemsOf(kSharedCameras + kView + draws + "\n" + copy + "Fill window with Copy  uT t\n" +
                             "Expect pixel 4 4 [" + x + " 1 0] of t\n"),
                  "")
            << draws;
}

TEST(ScriptSharing, ACameraThatIsNoneIsReported) {
    const auto of = [](const std::string& draw) { return problemsOf(kSharedCameras + kView + draw + "\n"); };
    EXPECT_NE(of("Draw view cam t").find("no camera 'cam' is declared"), std::string::npos)
        << of("Draw view cam t");
    EXPECT_NE(of("Draw view cam side").find("'side' is an array of cameras; write side[0] to side[2]"),
              std::string::npos);
    EXPECT_NE(of("Draw view cam side[3]").find("glib-E05"), std::string::npos);
}

// ---- Glsl.

std::string filled(const std::string& before, const std::string& color, const std::string& include) {
    return before + "Texture2D t 4 4 rgba32f\nFragment inline\n#version 330\n" + include +
           "\nout vec4 c;\nvoid main() { c = " + color +
           "; }\nEndFragment\nProgram P\nFill t with P\nPass window\nEndPass\n";
}

TEST(ScriptSharing, ShadersIncludeTheGlslOfTheScene) {
    const std::string text =
        "Glsl half inline\nfloat half_(float x) { return .5*x; }\nEndGlsl\n"
        "Glsl quarter inline\n#pragma once\n#include half\nfloat quarter(float x) { return half_(half_(x)); "
        "}\nEndGlsl\n";
    for (const char* include : {"#include quarter", "#include \"quarter\"", "#include <quarter>",
                                "#include quarter\n#include quarter", "#include quarter // twice"})
        EXPECT_EQ(problemsOf(filled(text, "vec4(quarter(1.))", include) + "Expect pixel 1 1 [.25] of t\n"),
                  "")
            << include;
    // Wherever it stands, and before a file of its name.
    EXPECT_EQ(
        problemsOf(filled("", "vec4(half_(1.))", "#include half") + text + "Expect pixel 1 1 [.5] of t\n",
                   {{"half", "float half_(float x) { return 3.; }\n"}}),
        "");
}

TEST(ScriptSharing, MessagesAboutSharedGlslNameItsLine) {
    const std::string found =
        problemsOf(filled("Glsl wrong inline\n\nfloat f() { return vec2(1.); }\nEndGlsl\n", "vec4(f())",
                          "#include wrong") +
                   "Expect finite t\n");
    EXPECT_NE(found.find("scene.glib:3:"), std::string::npos) << found;
    EXPECT_EQ(found.find("scene.glib:3:1:"), std::string::npos)
        << "the mistake stands in the line: " << found;
    const std::string cycle =
        problemsOf(filled("Glsl a inline\n#include b\nEndGlsl\nGlsl b inline\n#include a\nEndGlsl\n",
                          "vec4(1.)", "#include a") +
                   "Expect finite t\n");
    EXPECT_NE(cycle.find("Glsl a (line 1), Glsl b (line 4), Glsl a (line 1) [glsl-E04]"), std::string::npos)
        << cycle;
    EXPECT_NE(problemsOf(filled("", "vec4(1.)", "#include none") + "Expect finite t\n").find("'none'"),
              std::string::npos);
    const std::string twice =
        problemsOf(filled("Glsl a inline\nEndGlsl\nGlsl a inline\nEndGlsl\n", "vec4(1.)", "#include a"));
    EXPECT_NE(twice.find("scene.glib:3:6: error: 'a' is declared on line 1 already, as Glsl [glib-E36]"),
              std::string::npos)
        << twice;
    EXPECT_NE(problemsOf("Glsl a inline\nfloat f;\nPass window\nEndPass\n").find("glib-E22"),
              std::string::npos);
}

// ---- Fill.

TEST(ScriptSharing, FillCoversSeveralTargets) {
    const std::string shader =
        "Fragment inline\n#version 330\nin vec2 vST;\nlayout(location = 0) out vec4 a;\n"
        "layout(location = 1) out vec4 b;\nvoid main() { a = vec4(vST, 0., 1.); b = vec4(0., 0., vST); }\n"
        "EndFragment\nProgram P\n";
    EXPECT_EQ(problemsOf("Texture2D s 4 4 rgba32f\nTexture2D t 4 4 rgba16f\n" + shader +
                         "Fill s t with P\nPass window\nEndPass\nExpect pixel 3 0 [.875 .125 0 1] of s\n"
                         "Expect pixel 3 0 [0 0 .875 .125] of t\n"),
              "");
    EXPECT_NE(problemsOf("Texture2D s 4 4 rgba32f\nTexture2D d 4 4 depth24\n" + shader +
                         "Fill s d with P\nPass window\nEndPass\n")
                  .find("scene.glib:11:8: error: Fill: a depth texture has no colours to fill [glib-E38]"),
              std::string::npos);
    EXPECT_NE(problemsOf("Texture2D s 4 4 rgba32f\nTexture2D t 8 4 rgba32f\n" + shader + "Fill s t with P\n")
                  .find("all must have the same size"),
              std::string::npos);
}

TEST(ScriptSharing, FillOfSeveralTargetsKeepsTheirHistories) {
    const std::string shader =
        "Fragment inline\n#version 330\nuniform sampler2D uS;\nuniform sampler2D uT;\n"
        "layout(location = 0) out vec4 a;\nlayout(location = 1) out vec4 b;\n"
        "void main() { a = texelFetch(uS, ivec2(0), 0) + 1.; b = texelFetch(uT, ivec2(0), 0) + 2.; }\n"
        "EndFragment\nProgram P\n";
    EXPECT_EQ(problemsOf("Texture2D s 4 4 rgba32f history\nTexture2D t 4 4 rgba32f history\n" + shader +
                         "Step 10\nFill s t with P  uS s.prev  uT t.prev\nEndStep\nPass window\nEndPass\n"
                         "Expect pixel 3 0 [5] of s at .5\nExpect pixel 3 0 [10] of t at .5\n"),
              "");
}

}  // namespace
}  // namespace glibra::test
