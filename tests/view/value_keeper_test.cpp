#include "view/session/history.h"

#include "scene_folder.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;
using view::Session;
using view::ValueKeeper;

std::string sceneWith(const std::string& value) {
    return kHead + "Vertex a.vert\nFragment a.frag\nProgram P uR " + value + "\nQuadXY 0 1\n";
}

class ValueKeeperTest : public testing::Test {
  protected:
    ValueKeeperTest()
        : files(sceneWith("<0. .2 1.>"),
                {{"a.vert", kPlainVertex},
                 {"a.frag", "#version 330\nuniform float uR; out vec4 c;\nvoid main() { c = vec4(uR); }\n"}}),
          folder(files / "values"),
          first(context(), {}),
          second(context(), {}) {
        EXPECT_TRUE(first.open(files.scene()));
        EXPECT_FALSE(keeper.restore(first)) << "nothing was kept yet";
    }
    double again() {
        ValueKeeper other(folder);
        EXPECT_TRUE(second.open(files.scene()));
        other.restore(second);
        return second.values().knobs().at(knobIndex(second, "uR")).current.front();
    }
    SceneFolder files;
    fs::path folder;
    ValueKeeper keeper{folder};
    Session first, second;
};

TEST_F(ValueKeeperTest, ValuesAreWrittenWithinASecondAndComeBack) {
    EXPECT_LT(keeper.keep(first, 10), 0) << "nothing has changed";
    first.values().set(0, {.7});
    EXPECT_GT(keeper.keep(first, 11), 0);
    first.values().set(0, {.75});
    double due = keeper.keep(first, 11.1);
    EXPECT_GT(due, 0);
    EXPECT_LT(due, 1) << "also while a slider goes on moving";
    due = keeper.keep(first, 11.1 + due);
    EXPECT_LT(due, 0);
    EXPECT_EQ(again(), .75);
    EXPECT_TRUE(second.values().isChanged());
}

TEST_F(ValueKeeperTest, AtTheEndTheyAreWrittenAtOnceAndOnlyOnce) {
    first.values().set(0, {.7});
    keeper.keepNow(first);
    EXPECT_EQ(again(), .7);
    fs::remove_all(folder);
    keeper.keepNow(first);
    EXPECT_FALSE(fs::exists(folder)) << "nothing has changed since";
}

TEST_F(ValueKeeperTest, ValuesAsInTheSceneLeaveNothing) {
    first.values().set(0, {.7});
    keeper.keepNow(first);
    first.values().resetAll();
    keeper.keepNow(first);
    EXPECT_EQ(again(), .2);
    first.values().set(0, {.7});
    keeper.keepNow(first);
    keeper.forget(first);
    EXPECT_EQ(again(), .2);
}

TEST_F(ValueKeeperTest, AValueForWhichTheSceneSaysAnotherOneDoesNotComeBack) {
    first.values().set(0, {.7});
    keeper.keepNow(first);
    files.write("scene.glib", sceneWith("<0. .4 1.>"));
    EXPECT_EQ(again(), .4);
}

TEST_F(ValueKeeperTest, ASceneThatIsBrokenForAWhileLosesNothing) {
    first.values().set(0, {.7});
    keeper.keepNow(first);
    const std::string whole = files.read("a.frag");
    files.write("a.frag", "broken");
    EXPECT_TRUE(second.open(files.scene()));
    ValueKeeper other(folder);
    other.restore(second);
    files.write("a.frag", whole);
    second.reload();
    EXPECT_EQ(second.values().knobs().at(knobIndex(second, "uR")).current.front(), .7);
    other.keepNow(second);
    EXPECT_EQ(again(), .7);
}

TEST_F(ValueKeeperTest, AnAnimatedValueIsKeptAsItWasBefore) {
    first.values().set(0, {.7});
    first.values().animate(0, true);
    first.advance(.5);
    keeper.keepNow(first);
    EXPECT_EQ(again(), .7);
}

TEST_F(ValueKeeperTest, ADamagedFileGivesNoValues) {
    first.values().set(0, {.7});
    keeper.keepNow(first);
    for (const auto& each : fs::directory_iterator(folder)) fs::resize_file(each.path(), 20);
    EXPECT_EQ(again(), .2);
}

}  // namespace
}  // namespace glibra::test
