// Counts at a place of a buffer, comparisons of depth textures, and draws that end before the rasteriser
// (language, 12.4, 12.6 and 12.7).

#include <gtest/gtest.h>

#include <string>

#include "script_problems.h"

namespace glibra::test {
namespace {

const std::string kCountScene = "WindowSize 8 8\nBackground 0 0 0\nCamera eye (mat4(1)) (mat4(1))\n";

/// Draws a column of the window per instance, or a pixel per vertex.
const std::string kColumns =
    "Vertex inline\n#version 430\nvoid main() {\n"
    "gl_Position = vec4((vec2(gl_InstanceID, gl_VertexID) + .5)/4. - 1., 0., 1.); }\nEndVertex\n"
    "Fragment inline\n#version 430\nout vec4 c;\nvoid main() { c = vec4(1.); }\nEndFragment\nProgram "
    "Columns\n";

TEST(CountsAtAPlace, GiveInstancesAndVertices) {
    EXPECT_EQ(
        problemsOf(
            kCountScene + kColumns +
            "Buffer counts uint [9 7 3 8 2 6]\nInstances from counts at 2\nVertices points from counts at "
            "(2 + 2)\nExpect count [1 1 1] 6\nExpect pixel 2 1 [1 1 1]\n"),
        "");
}

TEST(CountsAtAPlace, GiveNumbersOfIndices) {
    EXPECT_EQ(
        problemsOf(
            kCountScene + kColumns +
            "Buffer counts int [100 3]\nBuffer order uint [5 3 1 0]\n"
            "Vertices points from counts at 1 indices order\nExpect count [1 1 1] 3\nExpect pixel 0 5 [1 "
            "1 1]\nExpect pixel 0 0 [0 0 0]\n"),
        "");
}

const std::string kCounting =
    "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
    "layout(std430) buffer Sum { uint sum[]; };\nvoid main() { atomicAdd(sum[0], 1u); }\nEndCompute\n"
    "Program Count\nBuffer Sum uint 1\n";

TEST(CountsAtAPlace, GiveGroupsOfADispatch) {
    EXPECT_EQ(
        problemsOf(
            kCountScene + kCounting +
            "Buffer groups uint [100 100 100 2 3 4]\nDispatch Count from groups at 3\nExpect buffer Sum "
            "[24]\n"),
        "");
}

TEST(CountsAtAPlace, LieInsideAStructureToo) {
    const std::string block =
        "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\nstruct Job { vec3 place; uint n; uvec3 "
        "groups; };\n"
        "layout(std430) buffer Jobs { Job jobs[]; };\nlayout(std430) buffer Sum { uint sum[]; };\n"
        "void main() { atomicAdd(sum[0], jobs[1].n); }\nEndCompute\nProgram Count\nBuffer Sum uint 1\n";
    // std430: place 0..11, n at 12, groups at 16..27, the next element at 32; so its groups are word 12.
    const std::string jobs = "Buffer Jobs Job [0 0 0 9 9 9 9  1.5 0 0 5 2 2 1]\n";
    EXPECT_EQ(
        problemsOf(kCountScene + block + jobs + "Dispatch Count from Jobs at 12\nExpect buffer Sum [20]\n"),
        "");
    for (const char* place : {"8", "7", "10"}) {
        const std::string problems = problemsOf(kCountScene + block + jobs + "Dispatch Count from Jobs at " +
                                                place + "\nExpect buffer Sum [20]\n");
        EXPECT_NE(
            problems.find(std::string("Dispatch: buffer 'Jobs' has no numbers of type uint from word ") +
                          place + " on"),
            std::string::npos)
            << problems;
    }
}

TEST(CountsAtAPlace, OutsideOfTheBufferAreReported) {
    const std::string problems =
        problemsOf(kCountScene + kCounting +
                   "Buffer groups uint [1 1 1 2]\nDispatch Count from groups at 2\nExpect buffer Sum [1]\n");
    EXPECT_NE(problems.find("Dispatch: buffer 'groups' has 16 bytes, but 3 counts from word 2 on need 20"),
              std::string::npos)
        << problems;
    EXPECT_NE(problemsOf(kCountScene + kColumns +
                         "Buffer n float [1 2 3]\nInstances from n at 1\nVertices points 1\n")
                  .find("Instances: buffer 'n' has no number of type uint from word 1 on"),
              std::string::npos);
}

/// Compares .25, .5 and .75 with the depth .5, in three thirds of the window, and below with a place outside
/// of the texture.
std::string comparedDepths(const std::string& options, const std::string& read) {
    return "WindowSize 9 9\nTexture2D half 4 4 depth32f nearest " + options +
           "\nSampler own nearest compare notequal border {1}\nPass half clear depth .5\nEndPass\n"
           "Fragment inline\n#version 330\nin vec2 vST;\nuniform sampler2DShadow uDepth;\nout vec4 c;\n"
           "void main() { float d = .25 + .25*floor(3.*vST.s);\n"
           "c = vec4(texture(uDepth, vec3(vST.t < .5 ? -2. : .5, .5, d))); }\nEndFragment\nProgram Compare\n"
           "Fill window with Compare uDepth " +
           read + "\n";
}

TEST(DepthComparison, IsThatOfTheTexture) {
    struct Row {
        const char* test;
        const char *below, *equal, *above;  // the third coordinate against the depth
        const char* outside;                // of the depth that counts there, for .25
    };
    constexpr Row kRows[] = {
        {"never", "0", "0", "0", "0"},    {"less", "1", "0", "0", "1"},   {"lequal", "1", "1", "0", "1"},
        {"equal", "0", "1", "0", "0"},    {"gequal", "0", "1", "1", "1"}, {"greater", "0", "0", "1", "1"},
        {"notequal", "1", "0", "1", "1"}, {"always", "1", "1", "1", "1"},
    };
    for (const Row& each : kRows) {
        const auto expect = [](int x, int y, const char* value) {
            return "Expect pixel " + std::to_string(x) + " " + std::to_string(y) + " [" + value + "]\n";
        };
        EXPECT_EQ(problemsOf(comparedDepths(std::string("compare ") + each.test, "half") +
                             expect(1, 7, each.below) + expect(4, 7, each.equal) + expect(7, 7, each.above) +
                             expect(1, 1, each.outside)),
                  "")
            << each.test;
    }
}

TEST(DepthComparison, IsThatOfTheSamplerWhereThereIsOne) {
    EXPECT_EQ(problemsOf(comparedDepths("compare less", "half.own") +
                         "Expect pixel 1 7 [1]\nExpect pixel 4 7 [0]\nExpect pixel 7 7 [1]\n"),
              "");
}

TEST(DepthComparison, NeedsDepth) {
    for (const char* texture :
         {"Texture2D glow 4 4 rgba8 compare less", "Texture2D glow x.png compare less"}) {
        const std::string problems = problemsOf(std::string(texture) + "\nSet uMap glow\nBox\n");
        EXPECT_NE(problems.find("only textures of depth are compared"), std::string::npos) << problems;
    }
}

TEST(Discard, RunsTheVertexStageAndDrawsNothing) {
    // No fragment stage is needed, and neither is a warning; clears and later draws are not discarded.
    const std::string count =
        "Buffer Sum uint 1\nVertex inline\n#version 430\nlayout(std430) buffer Sum { uint sum[]; };\n"
        "void main() { atomicAdd(sum[0], 1u); gl_Position = vec4(0., 0., 0., 1.); "
        "}\nEndVertex\nFragment\nProgram Count\n";
    EXPECT_EQ(
        problemsOf(kCountScene + kColumns + count +
                   "State discard on\nVertices points 5\nState discard off\nUse Columns\nVertices points 3\n"
                   "Expect buffer Sum [5]\nExpect count [1 1 1] 3\n"),
        "");
    EXPECT_EQ(
        problemsOf(kCountScene + kColumns +
                   "State discard on\nVertices points 5\nTexture2D other 4 4 rgba8\nPass other clear {1 0 0 "
                   "1}\nEndPass\nExpect count [1 0 0 1] 16 of other\nExpect count [1 1 1] 0\n"),
        "");
}

}  // namespace
}  // namespace glibra::test
