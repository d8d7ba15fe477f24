// A session whose device is lost: its scene comes back with its values, view and time, or is stopped.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/device_lost.h"
#include "scene_folder.h"

namespace glibra::test {
namespace {

using view::Session;

constexpr const char* kScene =
    "WindowSize 32 32\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\n"
    "Program Flat uR <0 .2 1> uG <0 .5 1>\nQuadXY 0 .7\n";
constexpr const char* kFragment =
    "#version 330\nuniform float uR, uG; out vec4 c;\nvoid main() { c = vec4(uR, uG, 0., 1.); }\n";

bool isSaid(const Session& session, std::string_view id) {
    const Diagnostics& all = session.diagnostics();
    return std::any_of(all.begin(), all.end(), [&](const Diagnostic& each) { return each.id == id; });
}

/// A session with a value and a view of its own, which has drawn its picture.
void open(Session& session, const SceneFolder& folder) {
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.values().set(knobIndex(session, "uR"), {.8});
    ViewState view = session.look().view();
    view.eye[12] = .25;
    session.look().setView(view);
    ASSERT_TRUE(session.drawIfNeeded());
}

TEST(LostSession, ComesBackWithItsValuesAndItsView) {
    const SceneFolder folder(kScene, {{"a.vert", kPlainVertex}, {"a.frag", kFragment}});
    Session session(context(), {});
    open(session, folder);
    const std::vector<std::byte> before = pixelsOf(session);
    for (int i = 0; i < 3; ++i) {
        session.releaseDevice();
        EXPECT_FALSE(session.hasScene());
        session.restoreDevice();
        ASSERT_TRUE(session.hasScene());
        EXPECT_EQ(session.values().knobs()[knobIndex(session, "uR")].current, std::vector<double>{.8});
        EXPECT_TRUE(session.drawIfNeeded());
        EXPECT_EQ(pixelsOf(session), before);
    }
    EXPECT_FALSE(isSaid(session, "view-E04"));
}

TEST(LostSession, KeepsItsValuesWhenItsFileIsMissingForAWhile) {
    const SceneFolder folder(kScene, {{"a.vert", kPlainVertex}, {"a.frag", kFragment}});
    Session session(context(), {});
    open(session, folder);
    session.releaseDevice();
    std::filesystem::rename(folder.scene(), folder / "away");
    session.restoreDevice();
    EXPECT_FALSE(session.hasScene());
    std::filesystem::rename(folder / "away", folder.scene());
    ASSERT_TRUE(session.reload());
    EXPECT_EQ(session.values().knobs()[knobIndex(session, "uR")].current, std::vector<double>{.8});
}

TEST(LostSession, IsNotDrawnUntilAValueOrItsTextChanges) {
    const SceneFolder folder(kScene, {{"a.vert", kPlainVertex}, {"a.frag", kFragment}});
    Session session(context(), {});
    open(session, folder);
    const auto stop = [&] {
        session.releaseDevice();
        session.restoreDevice();
        base::DeviceLost lost;
        lost.place = {folder.scene().string(), 6, 1};
        session.stop(lost);
        session.advance(1);
        session.look().resize(40, 40);
        session.look().resize(32, 32);
        EXPECT_FALSE(session.drawIfNeeded());
        EXPECT_FALSE(session.isMoving());
        EXPECT_EQ(session.picture(), nullptr);
        EXPECT_TRUE(isSaid(session, "view-E04"));
        session.probe(3, 3);
        session.pickAt(3, 3);
        EXPECT_EQ(session.picture(), nullptr);
    };
    stop();
    session.releaseDevice();  // another scene is lost
    session.restoreDevice();
    EXPECT_FALSE(session.drawIfNeeded());
    EXPECT_TRUE(isSaid(session, "view-E04"));
    session.values().set(knobIndex(session, "uG"), {.25});
    EXPECT_FALSE(isSaid(session, "view-E04"));
    EXPECT_TRUE(session.drawIfNeeded());
    stop();
    ASSERT_TRUE(session.reload());
    EXPECT_FALSE(isSaid(session, "view-E04"));
    EXPECT_TRUE(session.drawIfNeeded());
}

}  // namespace
}  // namespace glibra::test
