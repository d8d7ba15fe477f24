#include <cmath>
#include <set>

#include "scene_folder.h"
#include "view/session/history.h"

namespace glibra::test {
namespace {

using view::History;
using view::Session;

constexpr const char* kAnimatedScene =
    "WindowSize 32 32\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\n"
    "Program Flat uR <0 .25 1> uG <0 1 4> uTint {1 1 1}\nQuadXY 0 1\n";
const std::map<std::string, std::string> kAnimatedFiles{
    {"a.vert", kPlainVertex},
    {"a.frag",
     "#version 330\nuniform float uR; uniform int uG; uniform vec3 uTint; out vec4 c;\n"
     "void main() { c = vec4(uR, float(uG) / 4., 0., 1.) * vec4(uTint, 1.); }\n"}};

double valueOf(const Session& session, const char* tag) {
    return session.values().knob("", tag)->current[0];
}

void goTo(Session& session, double time) {
    session.clock().setTime(time);
}

class Animated : public ::testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
        history.record(session);
        r = knobIndex(session, "uR");
    }
    SceneFolder folder{kAnimatedScene, kAnimatedFiles};
    Session session{context(), {}};
    History history;
    std::size_t r = 0;
};

TEST_F(Animated, ValuesGoFromEndToEndAndBack) {
    session.values().animate(r, true);
    EXPECT_TRUE(session.isMoving()) << "although no shader reads the time";
    session.advance(1);
    EXPECT_DOUBLE_EQ(valueOf(session, "uR"), .5) << "4 seconds from end to end, from where it was";
    session.advance(2);
    EXPECT_DOUBLE_EQ(valueOf(session, "uR"), 1);
    session.advance(2);
    EXPECT_DOUBLE_EQ(valueOf(session, "uR"), .5);
    session.advance(2);
    EXPECT_DOUBLE_EQ(valueOf(session, "uR"), 0);
    session.advance(1);
    EXPECT_DOUBLE_EQ(valueOf(session, "uR"), .25);
    EXPECT_EQ(valueOf(session, "uG"), 1) << "the others stay";
}

TEST_F(Animated, TheValueIsAFunctionOfTheTime) {
    session.values().animate(r, true);
    const double begin = session.clock().time();
    goTo(session, begin + 5.5);
    const double there = valueOf(session, "uR");
    goTo(session, begin + 1);
    for (int i = 0; i < 450; ++i) session.advance(.01);
    EXPECT_NEAR(valueOf(session, "uR"), there, 1e-4);
}

TEST_F(Animated, ItStopsWithItsValueAndWithTheClock) {
    session.values().animate(r, true);
    session.advance(1);
    session.clock().play(false);
    session.advance(1);
    EXPECT_DOUBLE_EQ(valueOf(session, "uR"), .5);
    EXPECT_FALSE(session.isMoving());
    session.values().animate(r, false);
    session.clock().play(true);
    session.advance(1);
    EXPECT_DOUBLE_EQ(valueOf(session, "uR"), .5);
    EXPECT_FALSE(session.isMoving());
}

TEST_F(Animated, UndoTakesAnAnimationAsOneChange) {
    session.values().animate(r, true);
    for (int i = 0; i < 100; ++i) {
        session.advance(.01);
        history.record(session);
    }
    session.values().animate(r, false);
    const double stopped = valueOf(session, "uR");
    EXPECT_NE(stopped, .25);
    ASSERT_TRUE(history.undo(session));
    EXPECT_EQ(valueOf(session, "uR"), .25);
    EXPECT_FALSE(history.undo(session));
    ASSERT_TRUE(history.redo(session));
    EXPECT_EQ(valueOf(session, "uR"), stopped);
}

TEST_F(Animated, UndoEndsARunningAnimation) {
    session.values().set(knobIndex(session, "uG"), {3});
    history.record(session);
    session.values().animate(r, true);
    session.advance(1);
    ASSERT_TRUE(history.undo(session));
    EXPECT_FALSE(session.values().isAnimated(r));
    EXPECT_EQ(valueOf(session, "uR"), .25);
    EXPECT_EQ(valueOf(session, "uG"), 3) << "the change before stays";
    ASSERT_TRUE(history.undo(session));
    EXPECT_EQ(valueOf(session, "uG"), 1);
}

TEST_F(Animated, OnlyRangesMoveAndIntegersInWholeSteps) {
    session.values().animate(knobIndex(session, "uTint"), true);
    EXPECT_FALSE(session.values().isAnimated(knobIndex(session, "uTint")));
    session.values().animate(knobIndex(session, "uG"), true);
    for (int i = 0; i < 50; ++i) {
        session.advance(.1);
        const double value = valueOf(session, "uG");
        EXPECT_EQ(value, std::round(value));
        EXPECT_TRUE(value >= 0 && value <= 4);
    }
}

TEST_F(Animated, AReloadGoesOn) {
    session.values().animate(r, true);
    session.advance(1);
    ASSERT_TRUE(session.reload());
    EXPECT_TRUE(session.values().isAnimated(r));
    session.advance(1);
    EXPECT_DOUBLE_EQ(valueOf(session, "uR"), .75);
}

TEST(SceneValues, NeedNoDevice) {
    view::SceneValues* follows = nullptr;
    view::Clock clock([&] { follows->followClock(); });
    int changes = 0;
    view::SceneValues values(clock, [&](const render::Knob&) { ++changes; });
    follows = &values;
    render::Knob knob;
    knob.tag = "size";
    knob.widget = render::Widget::slider;
    knob.maximum = 4;
    knob.written = knob.initial = knob.current = {1};
    const scene::Scene scene;
    values.enter(scene, {knob});
    EXPECT_EQ(changes, 0);
    values.animate(0, true);
    clock.advance(1);
    EXPECT_EQ(changes, 1);
    EXPECT_DOUBLE_EQ(values.knobs()[0].current[0], 2);
    values.leave();
    values.enter(scene, {knob});
    EXPECT_DOUBLE_EQ(values.knobs()[0].current[0], 2) << "loaded again";
    EXPECT_TRUE(values.isAnimated(0));
    EXPECT_TRUE(values.undoAnimations());
    EXPECT_FALSE(values.isChanged());
}

TEST(Samples, SmoothTheScreenAndNothingElse) {
    const SceneFolder folder(
        "WindowSize 64 64\nBackground 0 0 0\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\nProgram Flat "
        "uR <0 1 1>\n"
        "Rotate 20 0 0 1\nQuadXY 0 .5\n",
        {{"a.vert", kPlainVertex},
         {"a.frag",
          "#version 330\nuniform float uR; out vec4 c; void main() { c = vec4(uR, 0., 0., 1.); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    const auto shades = [&] {
        session.drawIfNeeded();
        std::set<int> reds;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) reds.insert(pixelOf(session, x, y)[0]);
        return reds;
    };
    EXPECT_EQ(shades(), (std::set<int>{0, 255}));
    session.setSamples(4);
    EXPECT_EQ(session.framesDrawn(), 1U);
    if (context().capabilities().maxSamples < 4) GTEST_SKIP() << "the driver has no 4 samples";
    std::set<int> quarters;
    for (const int each : shades()) {
        quarters.insert((each + 32) / 64);
        EXPECT_NEAR(each, (each + 32) / 64 * 63.75, 1);
    }
    EXPECT_GE(quarters.size(), 4U) << "pixels of an edge are covered in part";
    EXPECT_EQ(session.picture()->samples(), 4);
    EXPECT_EQ(session.renderOptions().samples, 0) << "hardcopies stay as they are";
    ASSERT_NE(session.plainPicture(), nullptr);
    EXPECT_EQ(session.plainPicture()->samples(), 1);
    session.pickAt(32, 32);
    EXPECT_TRUE(session.look().picked()) << "picking reads the depth of one sample";
    session.setSamples(0);
    EXPECT_EQ(shades(), (std::set<int>{0, 255}));
}

TEST(WholeShape, APerspectiveFitsIntoANarrowPicture) {
    // The quad covers nine tenths of a square picture's width and height.
    const SceneFolder folder("WindowSize 64 64\nPerspective 90\nLookAt 0 0 1 0 0 0 0 1 0\nQuadXY 0 .9\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    const auto isDrawn = [&](int x, int y) { return pixelOf(session, x, y) != pixelOf(session, 0, 0); };
    session.look().resize(32, 64);
    session.drawIfNeeded();
    EXPECT_TRUE(isDrawn(16, 32));
    EXPECT_TRUE(isDrawn(0, 32)) << "cropped";
    session.look().setWholeShape(1);
    session.drawIfNeeded();
    EXPECT_TRUE(isDrawn(16, 32));
    EXPECT_FALSE(isDrawn(0, 32)) << "whole";
    EXPECT_TRUE(isDrawn(3, 32));
    EXPECT_FALSE(isDrawn(16, 12)) << "as wide as high, so not over the whole height";
    EXPECT_NE(session.renderOptions().viewState, session.look().view()) << "a hardcopy shows the same";
    session.look().resize(64, 64);
    EXPECT_EQ(session.renderOptions().viewState, session.look().view());
}

}  // namespace
}  // namespace glibra::test
