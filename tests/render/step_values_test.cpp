// What Once and Step read: values of variables, textures on units, what the frame writes, counts in buffers.

#include <gtest/gtest.h>

#include <string>

#include "modern_text.h"
#include "script_problems.h"

namespace glibra::test {
namespace {

/// A compute program `name` with one invocation.
std::string computing(const std::string& name, const std::string& declarations, const std::string& body) {
    return "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\n" + declarations +
           "\nvoid main() { " + body + " }\nEndCompute\nProgram " + name + "\n";
}

/// A program that adds a uniform to out[0] and writes it to out[1].
std::string adding(const std::string& name, const std::string& uniform) {
    return computing(name, "buffer Out { float o[]; };\nuniform float " + uniform + ";",
                     "o[0] += " + uniform + "; o[1] = " + uniform + ";");
}

constexpr const char* kWindow = "WindowSize 16 16\n";

TEST(StepValues, TexturesOfThreeThousandStepsCountOnce) {
    // A texture of 2 MiB; 3,000 of them would be more than a scene may have.
    const std::string scene = std::string(kWindow) + "Buffer sums float 2\n" +
                              computing("Noisy",
                                        "buffer sums { float o[]; };\nuniform sampler3D Noise3;\nuniform "
                                        "float uTick;",
                                        "o[0] += texture(Noise3, vec3(uTick)).r < 2 ? 1 : 0; o[1] = uTick;") +
                              "Step 10\nDispatch Noisy 1 uTick (tick)\nEndStep\n"
                              "Expect buffer sums [3000 2999] at 300\n";
    EXPECT_EQ(problemsOf(scene), "");
}

TEST(StepValues, ATextureOfAUnitFollowsItsSize) {
    const std::string scene = std::string(kWindow) +
                              "Noise3D (time < 1 ? 8 : 16)\n"
                              "Fragment inline\n#version 330\nuniform sampler3D Noise3;\nout vec4 c;\n"
                              "void main() { c = vec4(textureSize(Noise3, 0).x / 16.); }\nEndFragment\n"
                              "Program Show\nFill window with Show\n"
                              "Expect pixel 5 5 [.5] within .01 at 0\nExpect pixel 5 5 [1] at 2\n"
                              "Expect pixel 5 5 [.5] within .01 at .5\n";
    EXPECT_EQ(problemsOf(scene), "");
}

TEST(StepValues, UniformsFollowTheTimeOfTheStep) {
    const std::string head = std::string(kWindow) + "Let x (time * 10 + 1)\nBuffer Out float 4\n";
    const std::string tagged = head + adding("P", "uX");
    const std::string check = "Expect buffer Out [10 4] at .45\nExpect buffer Out [3 2] at .2\n";
    EXPECT_EQ(problemsOf(head + adding("P", "x") + "Step 10\nDispatch P 1\nEndStep\n" + check), "");
    EXPECT_EQ(problemsOf(tagged + "Step 10\nDispatch P 1 uX x\nEndStep\n" + check), "");
    EXPECT_EQ(problemsOf(tagged + "Step 10\nSet uX x\nDispatch P 1\nEndStep\n" + check), "");
    EXPECT_EQ(problemsOf(tagged + "Set uX x\nStep 10\nDispatch P 1\nEndStep\n" + check), "");
    std::string onProgram = tagged;
    onProgram.insert(onProgram.size() - 1, "  uX x");
    EXPECT_EQ(problemsOf(onProgram + "Step 10\nDispatch P 1\nEndStep\n" + check), "");
}

TEST(StepValues, AFillInStepFollowsAVariableOfItsName) {
    const std::string scene = std::string(kWindow) +
                              "Let x (time * 10 + 1)\nTexture2D sum 4 4 r32f history\n"
                              "Fragment inline\n#version 330\nuniform sampler2D uIn;\nuniform float x;\n"
                              "out float f;\n"
                              "void main() { f = texelFetch(uIn, ivec2(gl_FragCoord.xy), 0).r + x; }\n"
                              "EndFragment\nProgram Add uIn sum.prev\n"
                              "Step 10\nFill sum with Add\nEndStep\nExpect pixel 0 0 [10] of sum at .45\n";
    EXPECT_EQ(problemsOf(scene), "");
}

TEST(StepValues, OnceRefusesWhatChangesWithTime) {
    const std::string head = std::string(kWindow) + "Let x (time)\nLet y[2] (time + i)\nBuffer Out float 4\n";
    for (const char* tag : {"uX x", "uX (x + 1)", "uX (y[1])"}) {
        const std::string found =
            problemsOf(head + adding("P", "uX") + "Once\nDispatch P 1 " + tag + "\nEndOnce\n");
        EXPECT_NE(found.find("scene.glib:14:"), std::string::npos) << found;
        EXPECT_NE(found.find("which changes with time"), std::string::npos) << found;
        EXPECT_NE(found.find("memory-E11"), std::string::npos) << found;
    }
    const std::string byName = problemsOf(head + adding("P", "x") + "Once\nDispatch P 1\nEndOnce\n");
    EXPECT_NE(byName.find("scene.glib:14:1"), std::string::npos) << byName;
    EXPECT_NE(byName.find("uniform 'x' of program 'P'"), std::string::npos) << byName;
    EXPECT_NE(byName.find("memory-E11"), std::string::npos) << byName;
}

TEST(StepValues, OnceMayReadVariablesOfItsOwnAndThoseOfControls) {
    const std::string scene = std::string(kWindow) +
                              "Let x (time)\nLet k <0 3 9>\nLet twice (k * 2)\nBuffer Out float 4\n" +
                              adding("P", "uX") +
                              "Once\nLet x (7)\nDispatch P 1 uX (x + twice)\nEndOnce\n"
                              "Expect buffer Out [13 13] at 1\n";
    EXPECT_EQ(problemsOf(scene), "");
}

TEST(StepValues, LetInABlockIsForTheBlockAlone) {
    const std::string scene = std::string(kWindow) + "Let x (5)\nLet y[2] (i)\nBuffer Out float 4\n" +
                              adding("P", "uX") +
                              "Once\nLet x (7)\nLet y[3] (i + 20)\nDispatch P 1 uX x\nEndOnce\n"
                              "Step 10\nLet x (x + 1)\nDispatch P 1 uX x\nEndStep\n"
                              "Expect (x == 5)\nExpect (y[1] == 1 && y.count == 2)\n"
                              "Expect buffer Out [7 7]\nExpect buffer Out [19 6] at .2\n";
    EXPECT_EQ(problemsOf(scene), "");
}

TEST(StepValues, ProgramsOfABlockReadItsVariablesByTheirNames) {
    const std::string scene = std::string(kWindow) + "Buffer Out float 4\n" + adding("P", "y") +
                              "Step 10\nLet y (time * 10 + 1)\nDispatch P 1\nEndStep\n";
    EXPECT_EQ(problemsOf(scene + "Expect buffer Out [10 4] at .45\n"), "");
    const std::string found = problemsOf(scene + "Box (y)\n");
    EXPECT_NE(found.find("only Step sets it (line 11)"), std::string::npos) << found;
}

TEST(StepValues, AVariableUnderAConditionOfTimeChangesWithTime) {
    const std::string scene =
        std::string(kWindow) + "Let x (1)\nWhen (time >= .2)\nLet x (2)\nEndWhen\nBuffer Out float 4\n" +
        adding("P", "x") + "Step 10\nDispatch P 1\nEndStep\nExpect buffer Out [6 2] at .45\n";
    EXPECT_EQ(problemsOf(scene), "");
}

TEST(StepValues, AStepThatReadsWhatTheFrameDrawsIsWarnedOf) {
    const std::string scene =
        std::string(kWindow) +
        "Texture2D shadow 4 4 rgba8\nBuffer Out float 4\n"
        "Fragment inline\n#version 330\nout vec4 c;\nvoid main() { c = vec4(1); }\n"
        "EndFragment\nProgram Paint\n" +
        computing("Look", "buffer Out { float o[]; };\nuniform sampler2D uT;",
                  "o[0] = texelFetch(uT, ivec2(0), 0).r;") +
        "Set uT shadow\nFill shadow with Paint\n"
        "Step 10\nDispatch Look 1\nEndStep\nFill window with Paint\nExpect range Out 0 9\n";
    const std::string found = problemsOf(scene);
    EXPECT_NE(
        found.find("scene.glib:21:1: warning: Step reads 'shadow', which only the frame writes (line 19)"),
        std::string::npos)
        << found;
    EXPECT_NE(found.find("memory-W01"), std::string::npos) << found;
}

TEST(StepValues, AStepThatReadsABufferOfTheFrameIsWarnedOf) {
    const std::string scene =
        std::string(kWindow) + "Buffer A float 4\nBuffer Out float 4\n" +
        computing("Write", "writeonly buffer A { float o[]; };", "o[0] = 3;") +
        computing("Copy", "readonly buffer A { float a[]; };\nbuffer Out { float o[]; };", "o[0] = a[0];");
    const std::string steps = "Step 10\nDispatch Copy 1\nEndStep\nExpect range Out 0 9\n";
    EXPECT_NE(problemsOf(scene + "Dispatch Write 1\n" + steps).find("memory-W01"), std::string::npos);
    EXPECT_EQ(problemsOf(scene + "Once\nDispatch Write 1\nEndOnce\n" + steps), "");
}

std::string dispatchFrom(const std::string& buffer) {
    return std::string(kWindow) + buffer + "\nBuffer Out float 4\n" +
           computing("P", "buffer Out { float o[]; };", "o[0] = 1;") +
           "Dispatch P from n\nExpect buffer Out [1]\n";
}

TEST(StepValues, BuffersWithoutCountsAreRefused) {
    EXPECT_EQ(problemsOf(dispatchFrom("Buffer n uint [4 1 1]")), "");
    const std::string small = problemsOf(dispatchFrom("Buffer n uint 1 [4]"));
    EXPECT_NE(small.find("scene.glib:11:1: error: Dispatch: buffer 'n' has 4 bytes, but 3 counts need 12"),
              std::string::npos)
        << small;
    const std::string fractions = problemsOf(dispatchFrom("Buffer n float [4 1 1]"));
    EXPECT_NE(fractions.find("does not begin with 3 numbers of type uint (type float decides)"),
              std::string::npos)
        << fractions;
    for (const char* statement : {"Vertices points from n", "Instances from n\nVertices points 3"}) {
        const std::string found =
            problemsOf(std::string(kWindow) + "Buffer n float [4]\n" + statement + "\n");
        EXPECT_NE(found.find("memory-E12"), std::string::npos) << found;
    }
}

TEST(StepValues, CountersOfOneBindingHaveOneBuffer) {
    const auto counting = [](const std::string& second) {
        return std::string(kWindow) + "Buffer red uint 2\nBuffer all uint 1\n" +
               computing("Count",
                         "layout(binding = 0) uniform atomic_uint red;\nlayout(" + second +
                             ") uniform atomic_uint all;",
                         "atomicCounterIncrement(red); atomicCounterIncrement(all); "
                         "atomicCounterIncrement(all);") +
               "Dispatch Count 5\nExpect (red[0] == 5)\nExpect (all[0] == 10)\n";
    };
    EXPECT_EQ(problemsOf(counting("binding = 1")), "");
    const std::string found = problemsOf(counting("binding = 0, offset = 4"));
    EXPECT_NE(found.find("atomic counters 'red' and 'all' of program 'Count' have the same binding"),
              std::string::npos)
        << found;
    EXPECT_NE(found.find("memory-E14"), std::string::npos) << found;
}

TEST(StepValues, CountsBeyondTheLimitsAreRefused) {
    const std::string groups = problemsOf(dispatchFrom("Buffer n uint [1 4294967295 1]"));
    EXPECT_NE(groups.find("4,294,967,295 groups along y; this driver allows"), std::string::npos) << groups;
    const std::string head = std::string(kWindow) + "Buffer n uint [4294967295]\n";
    const std::string vertices = problemsOf(head + "Vertices points from n\n");
    EXPECT_NE(vertices.find("4,294,967,295 vertices; the limit is 500,000,000"), std::string::npos)
        << vertices;
    EXPECT_EQ(problemsOf(head + "Vertices points from n\nExpect error memory-E06\n"), "");
    const std::string instances = problemsOf(head + "Instances from n\nVertices points 3\n");
    EXPECT_NE(instances.find("4,294,967,295 instances; the limit is 100,000,000"), std::string::npos)
        << instances;
}

TEST(StepValues, GroupsThatASoftwareDriverLeavesUndoneAreReported) {
    if (!sharedContext().capabilities().isSoftware) GTEST_SKIP() << "this driver counts them all";
    // 65535^3 is 196,607 for a counter of 32 bits, so this takes no time.
    const std::string found = problemsOf(dispatchFrom("Buffer n uint [65535 65535 65535]"));
    EXPECT_NE(found.find("draw-W18"), std::string::npos) << found;
    EXPECT_EQ(problemsOf(dispatchFrom("Buffer n uint [3 1 1]")).find("draw-W18"), std::string::npos);
}

TEST(StepValues, CamerasOfTheStepBeforeAreThoseOneStepEarlier) {
    const std::string camera = " LookAt (time) 0 5  (time) 0 0  0 1 0  Perspective 45 .1 50\n";
    EXPECT_EQ(
        problemsOf("WindowSize 8 8\nCamera orbit" + camera +
                   "Buffer r float 4\nCompute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
                   "layout(std430) writeonly buffer R { float r[]; };\nuniform float uA, uB, uC;\n"
                   "void main() { r[0] = uA; r[1] = uB; r[2] = uC; }\nEndCompute\nProgram C R r\nStep "
                   "10\nCamera mine" +
                   camera +
                   "Dispatch C 1 uA (orbit.position.x) uB (orbit.prev.position.x) uC (mine.prev.position.x)\n"
                   "EndStep\nExpect buffer r [.9 .8 .8] within .00001 at 1\n"),
        "");
}

}  // namespace
}  // namespace glibra::test
