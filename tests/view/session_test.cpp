// A session of the window without the window: what it draws, when, and what it keeps.

#include "gpu/object/loop_limit.h"
#include "scene_folder.h"
#include "view/session/object_timer.h"

namespace glibra::test {
namespace {

using view::Session;

constexpr const char* kFlatFragment =
    "#version 330\nuniform float uR; uniform int uG; uniform bool uB; uniform vec3 uTint; out vec4 c;\n"
    "void main() { c = vec4(uR, float(uG) / 4., uB ? 1. : 0., 1.) * vec4(uTint, 1.); }\n";
constexpr const char* kFlatScene =
    "WindowSize 32 32\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\n"
    "Program Flat uR <0 .2 1> uG <0 1 4> uB <false> uTint {1 1 1}\nQuadXY 0 1\n";

const std::map<std::string, std::string> kFlatFiles{{"a.vert", kPlainVertex}, {"a.frag", kFlatFragment}};

TEST(Session, DrawsTheSceneInItsWindowSize) {
    const SceneFolder folder(kFlatScene, kFlatFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    EXPECT_TRUE(session.drawIfNeeded());
    EXPECT_EQ(session.look().width(), 32);
    EXPECT_EQ(pixelOf(session, 16, 16), (Color{51, 64, 0})) << text(session.diagnostics());
}

TEST(Session, DrawsNoFrameWhenNothingChanged) {
    const SceneFolder folder(kFlatScene, kFlatFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    for (int i = 0; i < 100; ++i) {
        session.advance(.1);
        EXPECT_FALSE(session.drawIfNeeded());
        session.values().set(knobIndex(session, "uR"), {.2});
        session.look().setView(session.look().view());
        session.look().resize(32, 32);
    }
    EXPECT_EQ(session.framesDrawn(), 1U);
}

TEST(Session, ReportsOnceHowFarTheEyeWasMoved) {
    const SceneFolder folder("WindowSize 64 32\nPerspective 50\nSphere 2\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    const auto notes = [&] {
        session.drawIfNeeded();
        std::vector<std::string> all;
        for (const Diagnostic& each : session.diagnostics())
            if (each.id == "draw-N01") all.push_back(each.text);
        return all;
    };
    const std::vector<std::string> wide = notes();
    ASSERT_EQ(wide.size(), 1U) << text(session.diagnostics());
    session.look().resize(32, 64);
    const std::vector<std::string> high = notes();
    ASSERT_EQ(high.size(), 1U);
    EXPECT_NE(high, wide) << "a narrow picture needs a larger distance";
    session.look().resize(64, 32);
    EXPECT_EQ(notes(), wide);
}

TEST(Session, EveryKindOfValueReachesThePicture) {
    const SceneFolder folder(kFlatScene, kFlatFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.values().set(knobIndex(session, "uR"), {.8});
    session.values().set(knobIndex(session, "uG"), {3});
    session.values().set(knobIndex(session, "uB"), {1});
    session.values().set(knobIndex(session, "uTint"), {1, 1, .4});
    EXPECT_TRUE(session.drawIfNeeded());
    EXPECT_EQ(pixelOf(session, 16, 16), (Color{204, 191, 102}));
    session.values().reset(knobIndex(session, "uG"));
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 16, 16), (Color{204, 64, 102}));
    session.values().resetAll();
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 16, 16), (Color{51, 64, 0}));
}

TEST(Session, ValuesBeyondTheRangeAreKeptAndIntegersCut) {
    const SceneFolder folder(kFlatScene, kFlatFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.values().set(knobIndex(session, "uR"), {7.5});
    session.values().set(knobIndex(session, "uG"), {2.9});
    EXPECT_EQ(session.values().knob("", "uR")->current, std::vector<double>{7.5});
    EXPECT_EQ(session.values().knob("", "uG")->current, std::vector<double>{2});
}

TEST(Session, WarnsOfALoopThatIsTooLongUntilTheValueIsReset) {
    const SceneFolder folder(
        "WindowSize 2 2\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\nProgram P uN <1 100 100000> uM 1\n"
        "QuadXY 0 1\n",
        {{"a.vert", kPlainVertex},
         {"a.frag",
          "#version 330\nuniform int uN, uM; out vec4 c;\nvoid main() {\n  c = vec4(0.);\n"
          "  for (int i = 0; i < uN; ++i) c += float(uM);\n}\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.drawIfNeeded();
    const Diagnostics before = session.diagnostics();
    const int limit = gpu::measureLoopLimit(context());
    const std::size_t warnings = limit > 0 && limit < 70'000 ? 1 : 0;
    for (const double rounds : {70'000., 80'000.}) {
        session.values().set(knobIndex(session, "uN"), {rounds});
        session.drawIfNeeded();
        ASSERT_EQ(session.diagnostics().size(), before.size() + warnings) << text(session.diagnostics());
        if (warnings == 0) continue;
        const Diagnostic& warned = session.diagnostics().back();
        EXPECT_EQ(warned.id, "draw-W08");
        EXPECT_EQ(warned.place.line, 5);
        EXPECT_NE(warned.text.find(rounds == 70'000 ? "70,000" : "80,000"), std::string::npos) << warned.text;
    }
    session.reload();
    EXPECT_EQ(session.diagnostics().size(), before.size() + warnings) << "the value is kept";
    session.values().set(knobIndex(session, "uN"), {200});
    EXPECT_EQ(text(session.diagnostics()), text(before));
}

TEST(Session, LoopsThatOnlyTheDriverCountsAreReportedAfterThePicture) {
    const SceneFolder folder(
        "WindowSize 2 2\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\nProgram P uN <1 100 1000>\n"
        "QuadXY 0 1\n",
        {{"a.vert", kPlainVertex},
         {"a.frag",
          "#version 430\nuniform int uN; out vec4 c;\nvoid main() {\n  int t = 0;\n"
          "  for (int i = 0; i < uN; i++)\n    for (int j = 0; j < i; j++) t++;\n"
          "  c = vec4(t == uN * (uN - 1) / 2);\n}\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    const int limit = gpu::measureLoopLimit(context());
    const bool isCut = limit > 0 && limit < 124'750 && context().capabilities().compute;
    const auto reported = [&] {
        return std::ranges::count(session.diagnostics(), "draw-W08", &Diagnostic::id);
    };
    EXPECT_FALSE(session.watchLoops()) << "the picture comes first";
    session.drawIfNeeded();
    for (const double rounds : {100., 500., 100., 500.}) {
        session.values().set(knobIndex(session, "uN"), {rounds});
        session.drawIfNeeded();
        const Color before = pixelOf(session, 1, 1);
        EXPECT_EQ(reported(), 0) << "not before the picture is there";
        EXPECT_EQ(session.watchLoops(), limit > 0);
        EXPECT_EQ(session.drawIfNeeded(), limit > 0);
        EXPECT_EQ(pixelOf(session, 1, 1), before);
        EXPECT_EQ(reported(), isCut && rounds == 500 ? 1 : 0) << text(session.diagnostics());
        EXPECT_FALSE(session.watchLoops()) << "once";
        EXPECT_FALSE(session.drawIfNeeded());
    }
    session.reload();
    EXPECT_EQ(reported(), 0);
    session.drawIfNeeded();
    EXPECT_EQ(session.watchLoops(), limit > 0);
    session.drawIfNeeded();
    EXPECT_EQ(reported(), isCut ? 1 : 0);
}

TEST(Session, LoopsOfShortTextsAreNotWatched) {
    const SceneFolder folder(kFlatScene, kFlatFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    EXPECT_FALSE(session.watchLoops());
    EXPECT_FALSE(session.drawIfNeeded());
}

TEST(Session, KnobsHaveTheWidgetsOfTheirForms) {
    const SceneFolder folder(kFlatScene, kFlatFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    EXPECT_EQ(session.values().knob("Flat", "uR")->widget, render::Widget::slider);
    EXPECT_EQ(session.values().knob("Flat", "uR")->maximum, 1);
    EXPECT_TRUE(session.values().knob("Flat", "uG")->isInteger());
    EXPECT_EQ(session.values().knob("Flat", "uB")->widget, render::Widget::checkBox);
    EXPECT_EQ(session.values().knob("Flat", "uTint")->widget, render::Widget::color);
    EXPECT_EQ(session.values().knob("Other", "uR"), nullptr);
}

TEST(Session, ASetArgumentOfOneProgramLeavesTheOtherAlone) {
    const SceneFolder folder(
        "WindowSize 32 16\nOrtho -2 2 -1 1\nVertex a.vert\nFragment a.frag\n"
        "Program One uR <0 .2 1>\nQuadXY 0 1\nTranslate 1 0 0\nProgram Two uR <0 .6 1>\nQuadXY 0 .5\n",
        {{"a.vert", kPlainVertex},
         {"a.frag",
          "#version 330\nuniform float uR; out vec4 c;\nvoid main() { c = vec4(uR, 0., 0., 1.); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    EXPECT_TRUE(session.values().setByText("One:uR=1").empty());
    EXPECT_EQ(session.values().knob("One", "uR")->current.front(), 1);
    EXPECT_EQ(session.values().knob("Two", "uR")->current.front(), .6);
    EXPECT_TRUE(session.values().setByText("8:uR=0").empty());
    EXPECT_EQ(session.values().knob("Two", "uR")->current.front(), 0);
    EXPECT_FALSE(session.values().setByText("Three:uR=0").empty());
    EXPECT_FALSE(session.values().setByText("uR=red").empty());
}

/// The control of a variable belongs to no program.
TEST(Session, ASetArgumentReachesVariablesOfTheScene) {
    const SceneFolder folder(
        "WindowSize 32 16\nOrtho -2 2 -1 1\nLet size <0. .5 1.>\nLet tint {1 0 0}\nVertex a.vert\n"
        "Fragment a.frag\nProgram One uR (size)\nQuadXY 0 1\n",
        {{"a.vert", kPlainVertex},
         {"a.frag",
          "#version 330\nuniform float uR; out vec4 c;\nvoid main() { c = vec4(uR, 0., 0., 1.); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    const auto valuesOf = [&](const char* name) {
        for (const render::Knob& each : session.values().knobs())
            if (each.tag == name) return each.current;
        return std::vector<double>();
    };
    EXPECT_TRUE(session.values().setByText("size=.25").empty());
    EXPECT_EQ(valuesOf("size"), std::vector<double>{.25});
    EXPECT_TRUE(session.values().setByText("tint=0,1,.5").empty());
    EXPECT_EQ(valuesOf("tint"), (std::vector<double>{0, 1, .5}));
    for (const char* wrong : {"size=1,2", "tint=1", "none=3", "One:size=1", "size=big", "size=[]", "size"})
        EXPECT_EQ(session.values().setByText(wrong).size(), 1U) << wrong;
    EXPECT_EQ(valuesOf("size"), std::vector<double>{.25});
    EXPECT_EQ(valuesOf("tint"), (std::vector<double>{0, 1, .5}));
}

TEST(Session, AFaultyStatementIsLeftOutAndTheRestDrawn) {
    const SceneFolder folder("WindowSize 32 32\nSpere 1\nOrtho -1 1 -1 1\nColor 0 1 0\nQuadXY 0 1\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 16, 16), (Color{0, 255, 0}));
    ASSERT_FALSE(session.diagnostics().empty());
    EXPECT_EQ(session.diagnostics().front().id, "glib-E01");
    EXPECT_EQ(session.diagnostics().front().place.line, 2);
}

TEST(Session, AProgramThatFailsAtFirstDrawsMagenta) {
    const SceneFolder folder(kFlatScene,
                             {{"a.vert", kPlainVertex}, {"a.frag", "#version 330\nvoid main() { x }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 16, 16), (Color{255, 0, 255}));
    EXPECT_TRUE(hasError(session.diagnostics()));
    EXPECT_TRUE(session.values().knobs().empty());
}

TEST(Session, AnUnreadableSceneLeavesWhatIsShown) {
    const SceneFolder folder(kFlatScene, kFlatFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    EXPECT_FALSE(session.open(folder / "none.glib"));
    EXPECT_TRUE(hasError(session.diagnostics()));
    EXPECT_EQ(session.path(), folder.scene());
    EXPECT_EQ(pixelOf(session, 16, 16), (Color{51, 64, 0}));
}

TEST(Session, TheBackgroundOfTheViewReplacesTheScenes) {
    const SceneFolder folder("WindowSize 16 16\nBackground 1 0 0\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 3, 3), (Color{255, 0, 0}));
    ViewState view;
    view.background = {0, 0, 1, 1};
    session.look().setView(view);
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 3, 3), (Color{0, 0, 255}));
}

TEST(Transforms, ResetKeepsValues) {
    const SceneFolder folder(kFlatScene, kFlatFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.values().set(knobIndex(session, "uR"), {.8});
    session.look().drag(view::TransformMode::eye, {view::Gesture::rotate, {5, 9}, {32, 32}});
    EXPECT_TRUE(session.look().view() != ViewState{});
    session.look().resetTransforms();
    EXPECT_TRUE(session.look().view() == ViewState{});
    EXPECT_EQ(session.values().knob("", "uR")->current.front(), .8);
}

TEST(Session, GoesThroughTheProjectionsThatTheSceneDoesNotHave) {
    const auto round = [](const std::string& projections) {
        const SceneFolder folder("WindowSize 16 16\n" + projections);
        Session session(context(), {});
        EXPECT_TRUE(session.open(folder.scene()));
        std::vector<ProjectionMode> seen;
        do {
            session.look().nextProjection();
            seen.push_back(session.look().view().projection);
        } while (seen.back() != ProjectionMode::scene && seen.size() < 9);
        return seen;
    };
    using Modes = std::vector<ProjectionMode>;
    const std::string deep = "Perspective 50 .1 100\nSphere\n", flat = "Ortho -1 1 -1 1\nQuadXY 0 1\n";
    EXPECT_EQ(round(deep), (Modes{ProjectionMode::orthographic, ProjectionMode::scene}));
    EXPECT_EQ(round(flat), (Modes{ProjectionMode::perspective, ProjectionMode::scene}));
    EXPECT_EQ(round(deep + flat),
              (Modes{ProjectionMode::orthographic, ProjectionMode::perspective, ProjectionMode::scene}));
    EXPECT_EQ(round(""), Modes{ProjectionMode::scene});
}

TEST(Session, LeavesTheTimeOfASceneThatDoesNotUseIt) {
    const SceneFolder still("WindowSize 16 16\nSphere\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(still.scene()));
    session.advance(.5);
    EXPECT_EQ(session.clock().time(), 0);
    const SceneFolder moving("WindowSize 16 16\nTranslate (time) 0 0\nSphere\n");
    ASSERT_TRUE(session.open(moving.scene()));
    session.advance(.5);
    EXPECT_EQ(session.clock().time(), .5);
}

TEST(Session, MeasuresObjectsAndNotClears) {
    const std::string heavy =
        "#version 330\nout vec4 c;\nvoid main() { float x = gl_FragCoord.x; for (int i = 0; i < 4000; ++i) x "
        "= sin(x + "
        "float(i)); c = vec4(x); }\n";
    const auto measure = [&](const std::string& statements) {
        const SceneFolder folder("WindowSize 200 200\nOrtho -1 1 -1 1\n" + statements,
                                 {{"a.vert", kPlainVertex}, {"a.frag", heavy}});
        Session session(context(), {});
        EXPECT_TRUE(session.open(folder.scene()));
        EXPECT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
        session.setMeasuresObjects(true);
        for (int i = 0; i < 2; ++i) {  // the first one compiles
            session.setNeedsFrame();
            session.drawIfNeeded();
        }
        return session.objectMilliseconds().value_or(-1);
    };
    const double drawn = measure("Vertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0 1\n");
    EXPECT_GT(drawn, 1);
    const double cleared = measure("Clear\nClear\n");
    EXPECT_EQ(cleared, 0);
    EXPECT_LT(measure("QuadXY 0 .01\n"), drawn / 4);
}

/// Counts calls of glFinish while it lives.
class FinishCount {
  public:
    FinishCount() : own_(glad_glFinish) {
        calls = 0;
        original = own_;
        glad_glFinish = [] {
            ++calls;
            original();
        };
        gladUninstallGLDebug();  // what is called are copies of the table
    }
    FinishCount(const FinishCount&) = delete;
    FinishCount& operator=(const FinishCount&) = delete;
    ~FinishCount() {
        glad_glFinish = own_;
        gladUninstallGLDebug();
    }
    static inline int calls = 0;

  private:
    static inline void (*original)() = nullptr;
    void (*own_)();
};

TEST(Session, MeasuresMovingObjectsWithoutWaitingForThem) {
    const SceneFolder folder(
        "WindowSize 64 64\nOrtho -1 1 -1 1\nTimer 10\nVertex a.vert\nFragment a.frag\n"
        "Program P\nQuadXY 0 1\n",
        {{"a.vert", kPlainVertex},
         {"a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(Timer); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    ASSERT_GT(context().capabilities().timerBits, 0);
    session.drawIfNeeded();
    session.setMeasuresObjects(true);
    const FinishCount finish;
    for (int i = 0; i < 40; ++i) {
        session.advance(.01);
        ASSERT_TRUE(session.drawIfNeeded());
    }
    EXPECT_EQ(FinishCount::calls, 0);
    glFinish();
    EXPECT_EQ(FinishCount::calls, 1) << "it would have been counted";
    session.advance(.01);
    session.drawIfNeeded();
    EXPECT_GT(session.objectMilliseconds().value_or(0), 0);
}

TEST(ObjectTimer, MeasuresNothingWithoutATimer) {
    const SceneFolder folder(kFlatScene, kFlatFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    gpu::Capabilities none = context().capabilities();
    none.timerBits = 0;
    view::ObjectTimer timer(none);
    EXPECT_FALSE(timer.measures());
    timer.begin(session.live().drawer(), session.live().plan());
    session.setNeedsFrame();
    session.drawIfNeeded();
    timer.end(session.live().drawer());
    timer.finish();
    EXPECT_FALSE(timer.milliseconds());
}

}  // namespace
}  // namespace glibra::test
