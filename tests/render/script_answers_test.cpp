// Every Expect that runs is answered once, at its time; the others are named (language, 12.9).

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "script_problems.h"

namespace glibra::test {
namespace {

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

/// The picture is grey: time / 8.
const std::string kClock = "WindowSize 4 4\nPass window clear {(time/8)}\nEndPass\n";

TEST(ScriptAnswers, ChecksAtATimeAreAnsweredWhereverTheyStand) {
    const auto wrongOf = [](const std::string& scene, double time = 0) {
        RenderOptions options;
        options.time = time;
        const std::string problems = problemsOf(kClock + scene, {}, options);
        EXPECT_EQ(countOf(problems, "check-E01"), countOf(problems, "\n")) << problems;
        return countOf(problems, "check-E01");
    };
    // Each of these holds, and each with another colour does not.
    const struct {
        std::string before, after;
        std::size_t checks;
    } kPlaces[] = {
        {"Expect pixel 0 0 [C] at 4", "\n", 1},
        {"Expect pixel 0 0 [C] at (time + 4)", "\n", 1},
        {"When (time < 1)\nExpect pixel 0 0 [C] at 4", "\nEndWhen\n", 1},
        {"When (time > 1)\nExpect pixel 0 0 [C] at 4", "\nEndWhen\n", 1},
        {"Repeat (2 - time/4)\nExpect pixel 0 0 [C] at 4", "\nEndRepeat\n", 2},
        {"Group g t 0\nExpect pixel 0 0 [C] at (t)", "\nEndGroup\nDraw g t 4\nDraw g t (4 + 0*time)\n", 2},
        {"Group\nWhen (frame == 0)\nExpect pixel 0 0 [C] at (frame + 4)", "\nEndWhen\nEndGroup\n", 1},
    };
    for (const auto& [before, after, checks] : kPlaces) {
        const auto with = [&](const std::string& color) {
            std::string scene = before + after;
            return scene.replace(scene.find("C]"), 1, color);
        };
        EXPECT_EQ(wrongOf(with(".5")), 0U) << before;
        EXPECT_EQ(wrongOf(with(".25")), checks) << before;
    }
    // Rounds have their own times.
    EXPECT_EQ(wrongOf("Repeat 5 as k\nExpect pixel 0 0 [(k/8)] at (k)\nEndRepeat\n"), 0U);
    EXPECT_EQ(wrongOf("Repeat 5 as k\nExpect pixel 0 0 [.125] at (k)\nEndRepeat\n"), 4U);
    EXPECT_EQ(
        wrongOf("Repeat 3 as k\nWhen (k != time)\nExpect pixel 0 0 [(k/8)] at (k)\nEndWhen\nEndRepeat\n"),
        0U);
    // The seconds are those of the picture's time, everything else is of the check's own.
    EXPECT_EQ(wrongOf("Expect pixel 0 0 [(time/8)] at (time + 1)\nExpect (time == 3) at (time + 1)\n", 2),
              0U);
    EXPECT_EQ(wrongOf("Expect pixel 0 0 [.25]\n", 2), 0U);
}

TEST(ScriptAnswers, ConditionsReadTheNamesWhereTheyStand) {
    EXPECT_EQ(
        problemsOf("Buffer data float [4 5 6]\nLet a (1)\nExpect (a == 1)\nLet a (2)\nExpect (a == 2)\n"
                   "Repeat 3 as k\nExpect (data[k] == k + 4)\nEndRepeat\n"
                   "Group g b data n 0\nExpect (b[1] == n)\nExpect (b.count == 3)\nEndGroup\nDraw g n 5\n"
                   "Repeat [(vec2(1, 2)) (vec2(3, 4))] as v\nExpect (v.y == v.x + 1)\nEndRepeat\n"
                   "Let mode <plain lit>\nExpect (mode == plain)\nExpect buffer data [4 5 6]\n"),
        "");
    const std::string problems =
        problemsOf("Repeat 3 as k\nExpect (k == 1)\nEndRepeat\nLet a (1)\nExpect (a == 7)\nLet a (7)\n");
    EXPECT_EQ(countOf(problems, "check-E01"), 3U) << problems;
    EXPECT_NE(problems.find("found 2 == 1"), std::string::npos) << problems;
    EXPECT_NE(problems.find("found 1 == 7"), std::string::npos) << problems;
}

TEST(ScriptAnswers, ChecksThatDoNotRunAreNamed) {
    EXPECT_NE(problemsOf("Group g\nExpect pixel 0 0 [1]\nEndGroup\nSphere\n")
                  .find("Expect pixel 0 0 [1] is not answered: group 'g' is not drawn [check-W01]"),
              std::string::npos);
    EXPECT_NE(problemsOf("Repeat 0\nExpect pixel 0 0 [1]\nEndRepeat\nSphere\n")
                  .find("is not answered: the Repeat on line 1 has no round [check-W01]"),
              std::string::npos);
    EXPECT_NE(
        problemsOf("When (time > 3)\nExpect pixel 0 0 [1]\nElse\nWhen (1 < 0)\nExpect samples 0\nEndWhen\n"
                   "EndWhen\nSphere\n")
            .find("the condition of the When on line 4 is false [check-N01]"),
        std::string::npos);
    EXPECT_EQ(
        problemsOf(kClock +
                   "When (time < 1)\nExpect pixel 0 0 [0]\nElse\nExpect pixel 0 0 [.5] at 4\nEndWhen\n"),
        "")
        << "at a number, it runs";
}

TEST(ScriptAnswers, ChecksOfASceneThatFailsAsExpectedAreReported) {
    const std::string wrong =
        "Fragment inline\n#version 330\nout vec4 c;\nvoid main() { c = vec4(x); }\nEndFragment\n"
        "Program P\nFill window with P\nExpect error glsl-E01\n";
    EXPECT_EQ(problemsOf(wrong), "");
    const std::string problems = problemsOf(wrong + "Expect pixel 0 0 [1]\nExpect primitives 1\n");
    EXPECT_EQ(countOf(problems, "check-E02"), 2U) << problems;
    EXPECT_NE(problems.find("there is no picture to look at, because of glsl-E01"), std::string::npos)
        << problems;
    EXPECT_EQ(countOf(problemsOf("Fragment missing.frag\nProgram Q\nFill window with Q\n" + wrong +
                                 "Expect pixel 0 0 [1]\n"),
                      "check-E02"),
              0U)
        << "other errors say enough";
    // The scene fails at another time than the first.
    const std::string later = kClock + "Translate (1/(time - 4)) 0 0\nSphere\nExpect error expr-E06\n";
    const std::string found =
        problemsOf(later + "Expect pixel 0 0 [.5] at 4\nExpect pixel 0 0 [0] within 1\n");
    EXPECT_EQ(countOf(found, "check-E02"), 1U) << found;
}

}  // namespace
}  // namespace glibra::test
