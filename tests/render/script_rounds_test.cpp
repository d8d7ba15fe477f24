// `Repeat n until (condition)` (language, 12.2): rounds that the content of buffers ends.

#include <gtest/gtest.h>

#include <string>

#include "modern_text.h"
#include "script_problems.h"

namespace glibra::test {
namespace {

/// Halves `residual` from 1 on, and counts in `rounds` how often.
const std::string kHalving =
    "Buffer residual float 1 (1)\nBuffer rounds uint 1 (0)\n"
    "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
    "layout(std430) buffer residual { float r[]; };\nlayout(std430) buffer rounds { uint n[]; };\n"
    "void main() { r[0] *= .5; n[0] += 1u; }\nEndCompute\nProgram Halve\n";

std::string once(const std::string& repeat) {
    return kHalving + "Once\n" + repeat + "\n    Dispatch Halve 1\nEndRepeat\nEndOnce\n";
}

TEST(ScriptRounds, EndWhenTheConditionHolds) {
    // 2^-10 is the first power of 1/2 below .001.
    EXPECT_EQ(problemsOf(once("Repeat 200 until (residual[0] < .001)") +
                         "Pass window\nEndPass\nExpect (rounds[0] == 10)\nExpect (residual[0] < .001)\n"),
              "");
    // The condition is looked at after each round, so there is one at least.
    EXPECT_EQ(problemsOf(once("Repeat 200 until (residual[0] > 0)") +
                         "Pass window\nEndPass\nExpect (rounds[0] == 1)\n"),
              "");
}

TEST(ScriptRounds, ReadCountersVariablesAndFunctions) {
    EXPECT_EQ(problemsOf("Let limit <0 .1 1>\nLet small(x k) (x < limit && k > 5)\n" +
                         once("Repeat 200 until (small(residual[0], k)) as k") +
                         "Pass window\nEndPass\nExpect (rounds[0] == 7)\n"),
              "");
}

TEST(ScriptRounds, ThatReachTheLimitAreReported) {
    const std::string problems = problemsOf(once("Repeat 5 until (residual[0] < .001)") +
                                            "Pass window\nEndPass\nExpect (rounds[0] == 5)\n");
    EXPECT_NE(problems.find("Repeat: (residual[0] < .001) is not true after 5 rounds: 0.03125 < 0.001 "
                            "[glib-W43]"),
              std::string::npos)
        << problems;
    EXPECT_EQ(problems.find("check-E01"), std::string::npos) << problems;
}

TEST(ScriptRounds, LeaveWhatFollowsTheRepetition) {
    EXPECT_EQ(
        problemsOf(kHalving + "Once\nRepeat 2\n  Repeat 50 until (residual[0] < .1)\n    Dispatch Halve 1\n"
                              "  EndRepeat\n  Dispatch Halve 1\nEndRepeat\nDispatch Halve 1\nEndOnce\n"
                              "Pass window\nEndPass\nExpect (rounds[0] == 4 + 1 + 1 + 1 + 1)\n"),
        "");
}

TEST(ScriptRounds, RunInEachStep) {
    TextScene scene(
        "Buffer r float 1 (0)\nBuffer total uint 1 (0)\n"
        "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
        "layout(std430) buffer r { float v[]; };\nvoid main() { v[0] = 1.; }\nEndCompute\nProgram Begin\n"
        "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
        "layout(std430) buffer r { float v[]; };\nlayout(std430) buffer total { uint n[]; };\n"
        "void main() { v[0] *= .5; n[0] += 1u; }\nEndCompute\nProgram Halve\n"
        "Step 10\nDispatch Begin 1\nRepeat 50 until (r[0] < .1)\n    Dispatch Halve 1\nEndRepeat\nEndStep\n"
        "Pass window\nEndPass\n");
    scene.draw(.35);  // three steps of four rounds
    EXPECT_EQ(scene.buffer("total", 1), (std::vector<double>{12}));
    EXPECT_EQ(scene.buffer("r", 1), (std::vector<double>{.0625}));
    scene.draw(.55);
    EXPECT_EQ(scene.buffer("total", 1), (std::vector<double>{20}));
}

TEST(ScriptRounds, OfTexturesKeepTheLastOne) {
    // Each round draws the number of the round into one of two textures in turn.
    const std::string text =
        "Texture2D a 4 4 r32f\nTexture2D b 4 4 r32f\nBuffer seen float 1 (0)\n"
        "Fragment inline\n#version 430\nuniform sampler2D uFrom;\nout vec4 c;\n"
        "void main() { c = vec4(texelFetch(uFrom, ivec2(0), 0).r + 1.); }\nEndFragment\nProgram Next\n"
        "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\nuniform sampler2D uFrom;\n"
        "layout(std430) buffer seen { float s[]; };\n"
        "void main() { s[0] = texelFetch(uFrom, ivec2(0), 0).r; }\nEndCompute\nProgram Look\n"
        "Once\nRepeat 40 until (seen[0] >= 6)\n"
        "    Fill b with Next uFrom a\n    Fill a with Next uFrom b\n    Dispatch Look 1 uFrom a\n"
        "EndRepeat\nEndOnce\nPass window\nEndPass\nExpect (seen[0] == 6)\nExpect pixel 0 0 [6] of a\n";
    EXPECT_EQ(problemsOf(text), "");
}

TEST(ScriptRounds, WithoutBuffersEndAnywhere) {
    EXPECT_EQ(problemsOf("Let n (1)\nRepeat 20 until (n > 100)\n    Let n (n * 2)\nEndRepeat\n"
                         "Pass window\nEndPass\nExpect (n == 128)\n"),
              "");
    const std::string problems = problemsOf(
        "Let n (1)\nRepeat 3 until (n > 100)\n    Let n (n * 2)\n"
        "EndRepeat\nPass window\nEndPass\nExpect (n == 8)\n");
    EXPECT_NE(problems.find("Repeat: (n > 100) is not true after 3 rounds: 8 > 100 [glib-W43]"),
              std::string::npos)
        << problems;
}

TEST(ScriptRounds, ThatReadBuffersStandInOnceOrStep) {
    const std::string problems = problemsOf(
        kHalving +
        "Repeat 5 until (residual[0] < .1)\n    Dispatch Halve 1\nEndRepeat\nPass window\nEndPass\n");
    EXPECT_NE(problems.find("Repeat: 'until (residual[0] < .1)' reads the buffer 'residual', so it stands in "
                            "Once or Step [glib-E32]"),
              std::string::npos)
        << problems;
}

}  // namespace
}  // namespace glibra::test
