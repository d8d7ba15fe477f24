#include "view/session/history.h"

#include "scene_folder.h"

namespace glibra::test {
namespace {

TEST(History, UndoPassesOverAChangeThatWasTakenBack) {
    const SceneFolder files("Let size <0. .2 1.>\nSphere (size)\n");
    view::Session first(context(), {});
    ASSERT_TRUE(first.open(files.scene()));
    view::History history;
    const auto value = [&] { return first.values().knobs()[0].current.front(); };
    history.record(first);
    first.values().set(0, {.502});  // the first click of two
    history.record(first);
    first.values().set(0, {.2});
    history.takeBack(first);
    first.values().set(0, {.7});  // typed
    history.record(first);
    EXPECT_TRUE(history.undo(first));
    EXPECT_EQ(value(), .2);
    EXPECT_TRUE(history.redo(first));
    EXPECT_EQ(value(), .7);
    history.takeBack(first);
    EXPECT_TRUE(history.undo(first)) << "what was not taken back stays";
    EXPECT_EQ(value(), .2);
}

}  // namespace
}  // namespace glibra::test
