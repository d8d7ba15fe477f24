// A scene beside the solution of its exercise, and the chapters of examples.

#include "view/session/comparison.h"

#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "scene_folder.h"
#include "view/browse/example_scenes.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;
using view::Comparison;
using view::Session;

constexpr const char* kTimedFragment =
    "#version 330\nuniform float uR; out vec4 c;\nvoid main() { c = vec4(uR, Timer, 0., 1.); }\n";
std::string scene(const std::string& fragment, const std::string& more = "") {
    return kHead + "Timer 1\nVertex a.vert\nFragment " + fragment + "\nProgram P uR <0. .2 1.>\n" + more +
           "QuadXY 0 1\n";
}

class ComparisonTest : public testing::Test {
  protected:
    ComparisonTest()
        : folder(scene("a.frag"),
                 {{"a.vert", kPlainVertex},
                  {"a.frag", kTimedFragment},
                  {"task.glib", scene("a.frag", "Scale .5 .5 .5\n")},
                  {"task.toml", "solution = \"scene.glib\"\ntimes = [0]\nsweep = [\"uR=[0, 1]\"]\n"}}),
          own(context(), {}),
          comparison(context(), {}) {
        EXPECT_TRUE(own.open(folder / "task.glib"));
        EXPECT_EQ(comparison.open(folder.scene()), "");
    }
    SceneFolder folder;
    Session own;
    Comparison comparison;
};

int redAt(const image::Image* picture, int x, int y) {
    if (!picture) return -1;
    return std::to_integer<int>(picture->row(y)[static_cast<std::size_t>(x) * 4]);
}
int greenAt(const image::Image* picture, int x, int y) {
    if (!picture) return -1;
    return std::to_integer<int>(picture->row(y)[static_cast<std::size_t>(x) * 4 + 1]);
}

TEST_F(ComparisonTest, ShowsBothPicturesAndHowTheyDiffer) {
    own.drawIfNeeded();
    ASSERT_TRUE(comparison.follow(own));
    EXPECT_NE(redAt(comparison.own(), 2, 2), 51) << "the background";
    EXPECT_EQ(redAt(comparison.other(), 2, 2), 51) << comparison.problem();
    EXPECT_EQ(redAt(comparison.own(), 20, 20), 51);
    const auto score = comparison.score();
    ASSERT_TRUE(score);
    EXPECT_GT(score->flip, .01);
    own.drawIfNeeded();
    EXPECT_FALSE(comparison.follow(own)) << "nothing has changed";
    EXPECT_TRUE(comparison.known());
}

TEST_F(ComparisonTest, FollowsValuesTimeAndSize) {
    own.values().set(knobIndex(own, "uR"), {.8});
    own.clock().pauseAt(.4);
    own.look().resize(30, 20);
    own.drawIfNeeded();
    ASSERT_TRUE(comparison.follow(own));
    ASSERT_TRUE(comparison.other());
    EXPECT_EQ(comparison.other()->width, 30);
    EXPECT_EQ(redAt(comparison.other(), 15, 10), 204);
    EXPECT_EQ(greenAt(comparison.other(), 15, 10), 102);
    EXPECT_EQ(greenAt(comparison.own(), 15, 10), 102);
}

TEST_F(ComparisonTest, EqualScenesDoNotDiffer) {
    folder.write("task.glib", scene("a.frag"));
    own.reload();
    own.drawIfNeeded();
    ASSERT_TRUE(comparison.follow(own));
    ASSERT_TRUE(comparison.score());
    EXPECT_EQ(comparison.score()->flip, 0);
    EXPECT_EQ(comparison.score()->structure, 0);
}

TEST_F(ComparisonTest, ASceneShownInAnyWayEqualsItsCopy) {
    const auto slanted = [](double depth) {
        return kHead + "Timer 1\nPerspective 60\nLookAt 0 0 " + std::to_string(depth) +
               "  0 0 0  0 1 0\nRotate 20 0 0 1\nVertex a.vert\nFragment a.frag\n"
               "Program P uR <0. .2 1.>\nSphere 1\n";
    };
    folder.write("task.glib", slanted(4));
    folder.write("scene.glib", slanted(4) + "# the same\n");
    own.open(folder / "task.glib");
    comparison.open(folder.scene());
    const auto picture = [&] {
        own.drawIfNeeded();
        EXPECT_TRUE(comparison.follow(own));
        return comparison.own() ? comparison.own()->data : std::vector<std::byte>();
    };
    const std::vector<std::pair<const char*, std::function<void()>>> changes{
        {"samples", [&] { own.setSamples(4); }},
        {"size", [&] { own.look().resize(60, 90); }},
        {"the whole shape", [&] { own.look().setWholeShape(2); }},
        {"a value", [&] { own.values().set(knobIndex(own, "uR"), {.9}); }},
        {"axes", [&] { own.look().setAxes(true); }},
        {"wireframe", [&] { own.look().setWireframe(true); }},
        {"the time", [&] { own.advance(.25); }},
        {"a debug view", [&] { own.look().setDebugView(view::DebugView::facing); }},
        {"the view",
         [&] { own.look().drag(view::TransformMode::eye, {view::Gesture::rotate, {9, 4}, {60, 90}}); }},
    };
    std::vector<std::byte> before = picture();
    for (const auto& [what, change] : changes) {
        change();
        const std::vector<std::byte> after = picture();
        EXPECT_NE(after, before) << what;
        ASSERT_TRUE(comparison.other());
        EXPECT_EQ(comparison.other()->data, after) << what;
        ASSERT_TRUE(comparison.score());
        EXPECT_EQ(comparison.score()->flip, 0) << what;
        EXPECT_EQ(comparison.score()->structure, 0) << what;
        before = after;
    }
}

TEST_F(ComparisonTest, WhileTimeRunsBothPicturesAreOfOneMoment) {
    folder.write("task.glib", scene("a.frag"));
    own.reload();
    for (int frame = 0; frame < 3; ++frame) {
        own.drawIfNeeded();
        own.advance(.2);  // the window does so before it shows the comparison
        ASSERT_TRUE(comparison.follow(own));
        EXPECT_EQ(greenAt(comparison.own(), 20, 20), 51 * frame);
        EXPECT_EQ(greenAt(comparison.other(), 20, 20), 51 * frame);
    }
}

TEST_F(ComparisonTest, ABrokenSceneHasAProblem) {
    folder.write("broken.glib", scene("none.frag"));
    EXPECT_EQ(comparison.open(folder / "broken.glib"), "");
    own.drawIfNeeded();
    comparison.follow(own);
    EXPECT_NE(comparison.problem().find("none.frag"), std::string::npos);
    EXPECT_NE(comparison.open(folder / "missing.glib"), "");
}

TEST_F(ComparisonTest, SaysWhetherTheExerciseIsSolvedAsItIsEdited) {
    view::SolutionCheck check(context(), {});
    while (check.follow(own)) {
    }
    EXPECT_EQ(check.state(), view::SolutionCheck::State::unsolved);
    EXPECT_TRUE(check.text().starts_with("not solved yet: at uR=0 its picture differs")) << check.text();
    own.setTexts({{folder / "task.glib", scene("a.frag")}});
    ASSERT_TRUE(own.reload());
    EXPECT_TRUE(check.follow(own));
    EXPECT_EQ(check.text(), "comparing: 1 of 2 sets of values");
    while (check.follow(own)) {
    }
    EXPECT_EQ(check.text(), "solved, with 2 sets of values");
    std::string other = scene("a.frag");
    other.replace(other.find("uR <"), 4, "uQ <");
    own.setTexts({{folder / "task.glib", other}});
    ASSERT_TRUE(own.reload());
    while (check.follow(own)) {
    }
    EXPECT_TRUE(check.text().starts_with("not solved yet: ")) << check.text();
    ASSERT_TRUE(own.open(folder.scene()));
    EXPECT_FALSE(check.follow(own));
    EXPECT_EQ(check.state(), view::SolutionCheck::State::none) << "it is no exercise";
}

TEST_F(ComparisonTest, AChoiceKeepsItsWordWhereTheOtherSceneHasAnotherOrder) {
    const auto with = [](const std::string& words) {
        return scene("a.frag", "Let size <" + words + ">\nScale (size == large ? 1 : .5) 1 1\n");
    };
    folder.write("mine.glib", with("large small"));
    folder.write("other.glib", with("small large"));
    ASSERT_TRUE(own.open(folder / "mine.glib"));
    own.drawIfNeeded();
    Comparison ordered(context(), {});
    EXPECT_EQ(ordered.open(folder / "other.glib"), "");
    ASSERT_TRUE(ordered.follow(own));
    ASSERT_TRUE(ordered.score());
    EXPECT_EQ(ordered.score()->flip, 0);
}

TEST_F(ComparisonTest, TheSolutionIsFoundAlsoFromACopy) {
    EXPECT_EQ(view::solutionOf(folder / "task.glib"), folder.scene());
    EXPECT_EQ(view::solutionOf(folder.scene()), fs::path());
    folder.write("mine/copy.glib", scene("a.frag"));
    EXPECT_TRUE(view::copyExercise(folder / "task.glib", folder / "mine/copy.glib").empty());
    EXPECT_EQ(view::solutionOf(folder / "mine/copy.glib"), folder.scene());
    EXPECT_EQ(folder.read("mine/copy.toml"),
              "solution = \"" + folder.scene().string() + "\"\ntimes = [0]\nsweep = [\"uR=[0, 1]\"]\n");
    folder.write("mine/copy.toml", "mine = 1\n");
    EXPECT_TRUE(view::copyExercise(folder / "task.glib", folder / "mine/copy.glib").empty());
    EXPECT_EQ(folder.read("mine/copy.toml"), "mine = 1\n") << "it stays";
    EXPECT_TRUE(view::copyExercise(folder.scene(), folder / "mine/other.glib").empty());
    EXPECT_FALSE(fs::exists(folder / "mine/other.toml"));
}

TEST(ExampleChapters, HaveTheirScenesAndExercises) {
    const auto scenes = view::exampleScenes(GLIBRA_SOURCE_DIR);
    const std::vector<std::string> chapters = view::chaptersOf(scenes);
    EXPECT_GT(chapters.size(), 30U);
    const auto at = [&](const char* name) { return std::find(chapters.begin(), chapters.end(), name); };
    ASSERT_NE(at("OpenGL with Java, chapter 7"), chapters.end());
    EXPECT_LT(at("OpenGL with Java, chapter 7"), at("OpenGL with Java, chapter 10"));
    int shown = 0, tasks = 0;
    for (const view::ExampleScene& each : scenes) {
        EXPECT_FALSE(each.topic.starts_with("exercises") && each.source.empty()) << each.file;
        if (!view::isOfChapter(each, "OpenGL with Java, chapter 7")) continue;
        ++shown;
        tasks += each.topic == "exercises/gl07" ? 1 : 0;
    }
    EXPECT_GE(shown, 13);
    EXPECT_EQ(tasks, 3);
    EXPECT_TRUE(view::isOfChapter(scenes.front(), ""));
}

}  // namespace
}  // namespace glibra::test
