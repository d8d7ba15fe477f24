#include "glib/script.h"
#include "scene_folder.h"
#include "view/history.h"
#include "view/save_values.h"
#include "view/source_lines.h"

namespace glibra::test {
namespace {

using view::Session;

const std::string kScene =
    "WindowSize 16 16  # small\r\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\n"
    "Program P uA <0 .25 1> \\\n\tuI < -3 1 9 >   uOn <true> uC {1 .5 0} uV [1 2] uN 4.\nQuadXY 0 1\n";
const std::map<std::string, std::string> kFiles{
    {"a.vert", kPlainVertex},
    {"a.frag",
     "#version 330\nuniform float uA, uN; uniform int uI; uniform bool uOn; uniform vec3 uC; uniform vec2 "
     "uV; out vec4 "
     "c;\nvoid main() { c = vec4(uC * uA + float(uI) + uN + (uOn ? uV.x : uV.y), 1.); }\n"}};

void turnAll(Session& session) {
    session.setValue(knobIndex(session, "uA"), {.75});
    session.setValue(knobIndex(session, "uI"), {-2});
    session.setValue(knobIndex(session, "uOn"), {0});
    session.setValue(knobIndex(session, "uC"), {.1, .2, .3});
    session.setValue(knobIndex(session, "uV"), {5, -6.5});
    session.setValue(knobIndex(session, "uN"), {1e-3});
}

TEST(SavedValues, ReplaceTheirOwnTextAndNothingElse) {
    const SceneFolder folder(kScene, kFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    turnAll(session);
    const Diagnostics problems = view::saveValues(session.path(), session.knobs());
    ASSERT_TRUE(problems.empty()) << text(problems);
    EXPECT_EQ(
        folder.read("scene.glib"),
        "WindowSize 16 16  # small\r\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\n"
        "Program P uA <0 0.75 1> \\\n\tuI <-3 -2 9>   uOn <false> uC {0.1 0.2 0.3} uV [5 -6.5] uN 0.001\n"
        "QuadXY 0 1\n");
    ASSERT_TRUE(session.reload());
    for (const view::Knob& each : session.knobs()) EXPECT_FALSE(each.isChanged()) << each.tag;
    EXPECT_EQ(session.knob("", "uV")->current, (std::vector<double>{5, -6.5}));
}

TEST(SavedValues, AreRefusedWhenTheSceneHasBecomeShorter) {
    const SceneFolder folder(kScene, kFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    turnAll(session);
    folder.write("scene.glib", "Sphere\n");
    EXPECT_TRUE(hasError(view::saveValues(session.path(), session.knobs())));
    EXPECT_EQ(folder.read("scene.glib"), "Sphere\n");
}

TEST(ProgramLine, ReadsBackAsTheValuesItWasMadeFrom) {
    const SceneFolder folder(kScene, kFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    turnAll(session);
    const std::string line = view::programLine(session.live().scene(), 0, session.knobs());
    const glib::Script script = glib::parse(line, "copied");
    EXPECT_TRUE(script.diagnostics.empty()) << text(script.diagnostics) << line;
    ASSERT_EQ(script.commands.size(), 1U);
    EXPECT_EQ(script.commands.front().text, "P");
    for (const glib::UniformSpec& each : script.commands.front().uniforms) {
        const view::Knob* knob = session.knob("", each.tag);
        ASSERT_TRUE(knob) << each.tag;
        if (each.form == glib::UniformForm::range)
            EXPECT_EQ(each.values[1], knob->current.front());
        else
            EXPECT_EQ(each.values, knob->current) << each.tag;
    }
}

TEST(SetArguments, GiveTheValuesBack) {
    const SceneFolder folder(kScene, kFiles);
    Session session(context(), {});
    Session other(context(), {});
    ASSERT_TRUE(session.open(folder.scene()) && other.open(folder.scene()));
    turnAll(session);
    for (const std::string& each : session.renderOptions().set)
        EXPECT_TRUE(other.setByText(each).empty()) << each;
    for (const view::Knob& each : session.knobs()) EXPECT_EQ(other.knob("", each.tag)->current, each.current);
}

TEST(History, GoesBackAndForward) {
    const SceneFolder folder(kScene, kFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    view::History history;
    history.record(session);
    session.setValue(knobIndex(session, "uA"), {.5});
    history.record(session);
    ViewState view;
    view.projection = ProjectionMode::orthographic;
    session.setView(view);
    history.record(session);
    history.record(session);
    ASSERT_TRUE(history.undo(session));
    EXPECT_EQ(session.view().projection, ProjectionMode::scene);
    EXPECT_EQ(session.knob("", "uA")->current.front(), .5);
    ASSERT_TRUE(history.undo(session));
    EXPECT_EQ(session.knob("", "uA")->current.front(), .25);
    EXPECT_FALSE(history.undo(session));
    ASSERT_TRUE(history.redo(session));
    EXPECT_EQ(session.knob("", "uA")->current.front(), .5);
    session.setValue(knobIndex(session, "uA"), {.6});
    ASSERT_TRUE(history.undo(session)) << "what was not recorded is not lost";
    EXPECT_EQ(session.knob("", "uA")->current.front(), .5);
}

TEST(Clock, PlaysStepsAndScrubs) {
    view::Clock clock;
    EXPECT_TRUE(clock.advance(.5));
    EXPECT_EQ(clock.time(), .5);
    clock.setSpeed(2);
    clock.advance(.25);
    EXPECT_EQ(clock.time(), 1);
    clock.step(1);
    EXPECT_FALSE(clock.isPlaying());
    EXPECT_FALSE(clock.advance(1));
    EXPECT_NEAR(clock.time(), 1 + 2. / 30, 1e-12);
    clock.setTime(-3);
    EXPECT_EQ(clock.time(), 0);
    clock.step(-1);
    EXPECT_EQ(clock.time(), 0);
}

TEST(SourceLine, IsTheLineOfAMessageWithItsColumn) {
    const SceneFolder folder("one\r\n\ttwo three\n");
    EXPECT_EQ(view::sourceLine({folder.scene().string(), 2, 6}), " two three");
    EXPECT_EQ(view::caretLine(" two three", 6), "     ^");
    EXPECT_EQ(view::sourceLine({folder.scene().string(), 9, 1}), "");
    EXPECT_EQ(view::sourceLine({(folder / "none").string(), 1, 1}), "");
}

}  // namespace
}  // namespace glibra::test
