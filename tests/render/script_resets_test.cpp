// Step ... reset, and the size of the window in Once and Step (language, 12.8).

#include <gtest/gtest.h>

#include <string>

#include "modern_text.h"
#include "script_problems.h"

namespace glibra::test {
namespace {

/// Counts the steps in `steps`, from what Once sets, and keeps the tick and the time of the last one.
const std::string kCountingSteps =
    "Buffer steps float 3\nBuffer others float 1\n"
    "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
    "layout(std430) buffer steps { float s[]; };\nvoid main() { s[0] = 100.; }\nEndCompute\nProgram Begin\n"
    "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\nuniform vec2 uNow;\n"
    "layout(std430) buffer steps { float s[]; };\n"
    "void main() { s[0] += 1.; s[1] = uNow.x; s[2] = uNow.y; }\nEndCompute\nProgram Count\n"
    "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
    "layout(std430) buffer others { float o[]; };\nvoid main() { o[0] += 1.; }\nEndCompute\nProgram Other\n"
    "Once\nDispatch Begin 1\nEndOnce\n";

std::string counting(const std::string& before, const std::string& reset) {
    return before + kCountingSteps + "Step 10 reset " + reset +
           "\nDispatch Count 1  uNow (vec2(tick, time))\nEndStep\n"
           "Step 10\nDispatch Other 1\nEndStep\n"
           "Pass window\nEndPass\n";
}

TEST(ScriptResets, ABlockBeginsAnewWhereAValueChangesWithTime) {
    // Steps 0 to 9 have the values 0, 10 to 19 the values 1.
    for (const char* value : {"(floor(time))", "(vec2(1, floor(time)))", "edge", "eye", "turned"}) {
        TextScene scene(
            counting("Let edge (floor(time))\n"
                     "Camera eye LookAt (edge) 0 5  0 0 0  0 1 0  Perspective 50 .1 100\n"
                     "Camera turned Shift eye 1 0 0\n",
                     value));
        scene.draw(.95);  // steps 0 to 8
        EXPECT_EQ(scene.buffer("steps", 3), (std::vector<double>{109, 8, .8F})) << value;
        scene.draw(1.25);  // steps 9 to 11, of which 10 begins anew
        EXPECT_EQ(scene.buffer("steps", 3), (std::vector<double>{102, 1, 1.1F})) << value;
        EXPECT_EQ(scene.buffer("others", 1), (std::vector<double>{12})) << value;
        scene.draw(.35);  // time goes back
        EXPECT_EQ(scene.buffer("steps", 3), (std::vector<double>{103, 2, .2F})) << value;
        scene.draw(1.25);  // at once as well
        EXPECT_EQ(scene.buffer("steps", 3), (std::vector<double>{102, 1, 1.1F})) << value;
    }
}

TEST(ScriptResets, WithoutAChangeNothingBeginsAnew) {
    for (const char* value : {"(1 + 1)", "eye", "edge (sqrt(edge))", "(0 * time)"}) {
        TextScene scene(counting(
            "Let edge <0 1 2>\nCamera eye LookAt 0 0 5  0 0 0  0 1 0  Perspective 50 .1 100\n", value));
        scene.draw(1.25);
        EXPECT_EQ(scene.buffer("steps", 2), (std::vector<double>{112, 11})) << value;
    }
}

TEST(ScriptResets, AValueThatIsNoneIsReported) {
    EXPECT_NE(refusalOf(counting("", "(nothing)")).find("nothing"), std::string::npos);
    EXPECT_NE(refusalOf(counting("", "nothing")).find("nothing"), std::string::npos);
}

TEST(ScriptResets, BlocksReadTheSizeOfTheWindow) {
    const std::string scene =
        "Buffer sizes vec4 2\n"
        "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\nuniform vec3 uSize;\nuniform int uAt;\n"
        "layout(std430) buffer sizes { vec4 s[]; };\nvoid main() { s[uAt] += vec4(uSize, 1.); }\nEndCompute\n"
        "Program Note\n"
        "Once\nDispatch Note 1  uAt 0  uSize (vec3(window, aspect))\nEndOnce\n"
        "Step 10\nDispatch Note 1  uAt 1  uSize (vec3(window, aspect))\nEndStep\nPass window\nEndPass\n"
        "Expect buffer sizes [80 40 2 1 160 80 4 2] at .2\n";
    RenderOptions options;
    options.width = 80;
    options.height = 40;
    EXPECT_EQ(problemsOf(scene, {}, options), "");
}

}  // namespace
}  // namespace glibra::test
