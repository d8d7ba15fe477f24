#include <algorithm>
#include <tuple>

#include "glib/script.h"
#include "scene_folder.h"
#include "view/edit/saved_scene.h"
#include "view/edit/source_lines.h"
#include "view/session/history.h"

namespace glibra::test {
namespace {

using view::Session;

const std::string kTextScene =
    "WindowSize 16 16  # small\r\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\n"
    "Program P uA <0 .25 1> \\\n\tuI < -3 1 9 >   uOn <true> uC {1 .5 0} uV [1 2] uN 4.\nQuadXY 0 1\n";
const std::map<std::string, std::string> kTextFiles{
    {"a.vert", kPlainVertex},
    {"a.frag",
     "#version 330\nuniform float uA, uN; uniform int uI; uniform bool uOn; uniform vec3 uC; uniform vec2 "
     "uV; out vec4 "
     "c;\nvoid main() { c = vec4(uC * uA + float(uI) + uN + (uOn ? uV.x : uV.y), 1.); }\n"}};

void turnAll(Session& session) {
    session.values().set(knobIndex(session, "uA"), {.75});
    session.values().set(knobIndex(session, "uI"), {-2});
    session.values().set(knobIndex(session, "uOn"), {0});
    session.values().set(knobIndex(session, "uC"), {.1, .2, .3});
    session.values().set(knobIndex(session, "uV"), {5, -6.5});
    session.values().set(knobIndex(session, "uN"), {1e-3});
}

TEST(SavedValues, ReplaceTheirOwnTextAndNothingElse) {
    const SceneFolder folder(kTextScene, kTextFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    turnAll(session);
    const Diagnostics problems = view::saveValues(session.path(), session.values().knobs());
    ASSERT_TRUE(problems.empty()) << text(problems);
    EXPECT_EQ(
        folder.read("scene.glib"),
        "WindowSize 16 16  # small\r\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\n"
        "Program P uA <0 0.75 1> \\\n\tuI < -3 -2 9 >   uOn <false> uC {0.1 0.2 0.3} uV [5 -6.5] uN 0.001\n"
        "QuadXY 0 1\n");
    ASSERT_TRUE(session.reload());
    for (const render::Knob& each : session.values().knobs()) EXPECT_FALSE(each.isChanged()) << each.tag;
    EXPECT_EQ(session.values().knob("", "uV")->current, (std::vector<double>{5, -6.5}));
}

TEST(SavedValues, AreNotWrittenWhereAnotherValueStandsNow) {
    const std::string scene = kHead + "Vertex a.vert\nFragment a.frag\nProgram P uA <0 .25 1>\n";
    const SceneFolder folder(scene + "Box 1 2 3\n", kTextFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.values().set(knobIndex(session, "uA"), {.75});
    const std::string moved = kHead + "Vertex a.vert\nFragment a.frag\nProgram P uX <0 .75 3>\n";
    folder.write("scene.glib", moved);
    EXPECT_TRUE(hasError(view::saveValues(session.path(), session.values().knobs())));
    EXPECT_EQ(folder.read("scene.glib"), moved);
}

TEST(SavedValues, OfVectorsAndExpressionsKeepTheirBrackets) {
    const SceneFolder folder(
        "Let v <-5 0 3 2 5>  # a vector\nLet w <0 (min(1, .5)) 2>\nTranslate (v)\nBox (w)\n", {});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.values().set(knobIndex(session, "v"), {1, 1, 1});
    session.values().set(knobIndex(session, "w"), {1.5});
    const Diagnostics problems = view::saveValues(session.path(), session.values().knobs());
    ASSERT_TRUE(problems.empty()) << text(problems);
    EXPECT_EQ(folder.read("scene.glib"),
              "Let v <-5 1 1 1 5>  # a vector\nLet w <0 1.5 2>\nTranslate (v)\nBox (w)\n");
}

TEST(SavedValues, LeaveUntouchedNumbersAsTheyWereWritten) {
    const SceneFolder folder(
        "WindowSize 16 16\nOrtho -1. 1. -1. 1.\nVertex a.vert\nFragment a.frag\n"
        "Program P uA <0. .250 1.> uI <0 +1 9> uOn <true> uC {1. .50 0.} uV [1e0 2.0]\nQuadXY 0 1\n",
        kTextFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.values().set(knobIndex(session, "uA"), {.75});
    session.values().set(knobIndex(session, "uC"), {1, .5, .25});
    session.values().set(knobIndex(session, "uV"), {1, -6.5});
    const Diagnostics problems = view::saveValues(session.path(), session.values().knobs());
    ASSERT_TRUE(problems.empty()) << text(problems);
    EXPECT_EQ(
        folder.read("scene.glib"),
        "WindowSize 16 16\nOrtho -1. 1. -1. 1.\nVertex a.vert\nFragment a.frag\n"
        "Program P uA <0. 0.75 1.> uI <0 +1 9> uOn <true> uC {1. .50 0.25} uV [1e0 -6.5]\nQuadXY 0 1\n");
}

TEST(SavedValues, AreRefusedWhenTheSceneHasBecomeShorter) {
    const SceneFolder folder(kTextScene, kTextFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    turnAll(session);
    folder.write("scene.glib", "Sphere\n");
    EXPECT_TRUE(hasError(view::saveValues(session.path(), session.values().knobs())));
    EXPECT_EQ(folder.read("scene.glib"), "Sphere\n");
}

TEST(ProgramLine, ReadsBackAsTheValuesItWasMadeFrom) {
    const SceneFolder folder(kTextScene, kTextFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    turnAll(session);
    const std::string line =
        render::programLine(session.live().scene(), scene::ProgramIndex(0), session.values().knobs());
    const glib::Script script = glib::parse(line, "copied");
    EXPECT_TRUE(script.diagnostics.empty()) << text(script.diagnostics) << line;
    ASSERT_EQ(script.commands.size(), 1U);
    EXPECT_EQ(script.commands.front().text(), "P");
    for (const glib::UniformSpec& each : script.commands.front().uniforms) {
        const render::Knob* knob = session.values().knob("", each.tag);
        ASSERT_TRUE(knob) << each.tag;
        if (each.form == glib::UniformForm::range)
            EXPECT_EQ(each.values[1], knob->current.front());
        else
            EXPECT_EQ(each.values, knob->current) << each.tag;
    }
}

TEST(SetArguments, GiveTheValuesBack) {
    const SceneFolder folder(kTextScene, kTextFiles);
    Session session(context(), {});
    Session other(context(), {});
    ASSERT_TRUE(session.open(folder.scene()) && other.open(folder.scene()));
    turnAll(session);
    for (const std::string& each : session.renderOptions().set)
        EXPECT_TRUE(other.values().setByText(each).empty()) << each;
    for (const render::Knob& each : session.values().knobs())
        EXPECT_EQ(other.values().knob("", each.tag)->current, each.current);
}

TEST(History, GoesBackAndForward) {
    const SceneFolder folder(kTextScene, kTextFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    view::History history;
    history.record(session);
    session.values().set(knobIndex(session, "uA"), {.5});
    history.record(session);
    ViewState view;
    view.projection = ProjectionMode::orthographic;
    session.look().setView(view);
    history.record(session);
    history.record(session);
    ASSERT_TRUE(history.undo(session));
    EXPECT_EQ(session.look().view().projection, ProjectionMode::scene);
    EXPECT_EQ(session.values().knob("", "uA")->current.front(), .5);
    ASSERT_TRUE(history.undo(session));
    EXPECT_EQ(session.values().knob("", "uA")->current.front(), .25);
    EXPECT_FALSE(history.undo(session));
    ASSERT_TRUE(history.redo(session));
    EXPECT_EQ(session.values().knob("", "uA")->current.front(), .5);
    session.values().set(knobIndex(session, "uA"), {.6});
    ASSERT_TRUE(history.undo(session)) << "an unrecorded change can be undone too";
    EXPECT_EQ(session.values().knob("", "uA")->current.front(), .5);
}

TEST(Clock, PlaysStepsAndScrubs) {
    view::Clock clock;
    clock.advance(.5);
    EXPECT_EQ(clock.time(), .5);
    clock.setSpeed(2);
    clock.advance(.25);
    EXPECT_EQ(clock.time(), 1);
    clock.step(1);
    EXPECT_FALSE(clock.isPlaying());
    clock.advance(1);
    EXPECT_NEAR(clock.time(), 1 + 2. / 30, 1e-12);
    clock.setTime(-3);
    EXPECT_EQ(clock.time(), 0);
    clock.step(-1);
    EXPECT_EQ(clock.time(), 0);
}

TEST(SourceLine, IsTheLineOfAMessageWithItsColumn) {
    const SceneFolder folder("one\r\n\ttwo three\n");
    EXPECT_EQ(view::sourceLine({folder.scene().string(), 2, 6}), " two three");
    EXPECT_EQ(view::sourceLine({folder.scene().string(), 9, 1}), "");
    EXPECT_EQ(view::sourceLine({(folder / "none").string(), 1, 1}), "");
}

TEST(Excerpt, OfAShortLineIsTheLine) {
    for (const auto& [line, column, caret] :
         {std::tuple(" two three", 6, "     ^"), std::tuple("abc", 4, "   ^"), std::tuple("abc", 99, "   ^"),
          std::tuple("", 1, "^"), std::tuple("abc", 0, "^"),
          // Columns count bytes; the blanks before the caret count characters.
          std::tuple("\xC3\xA4\xE2\x82\xAC+", 6, "  ^"), std::tuple("\xC3\xA4+", 2, "^")}) {
        const view::Excerpt shown = view::excerpt(line, column, 12);
        EXPECT_EQ(shown.text, line);
        EXPECT_EQ(shown.caret, caret) << line;
    }
}

TEST(Excerpt, OfALongLineShowsTheCharacterOfItsColumn) {
    std::string line;
    for (int i = 0; i < 40; ++i) line += std::string(1, static_cast<char>('a' + i % 26)) + "\xC3\xA4";
    for (const int most : {0, 12, 13, 40, 79, 80, 81})
        for (int column = 1; column <= 120; ++column) {
            const view::Excerpt shown = view::excerpt(line, column, most);
            const auto isStart = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
            const auto characters = std::count_if(shown.text.begin(), shown.text.end(), isStart);
            ASSERT_EQ(characters, std::min(80, std::max(most, 12))) << column;
            ASSERT_EQ(most < 80, shown.text.find("...") != std::string::npos);
            std::size_t at = 0;
            for (std::size_t left = shown.caret.size(); at < shown.text.size(); ++at)
                if (isStart(shown.text[at]) && --left == 0) break;
            ASSERT_LT(at, shown.text.size());
            const auto byte = static_cast<std::size_t>(column) - 1;
            const std::size_t start = byte - (isStart(line[byte]) ? 0 : 1);
            ASSERT_EQ(shown.text[at], line[start]) << column << " " << most << " " << shown.text;
        }
    EXPECT_EQ(view::excerpt("0123456789abcdefghij", 3, 12).text, "012345678...");
    EXPECT_EQ(view::excerpt("0123456789abcdefghij", 10, 12).text, "...6789ab...");
    EXPECT_EQ(view::excerpt("0123456789abcdefghij", 20, 12).text, "...bcdefghij");
    const view::Excerpt after = view::excerpt("0123456789abcdefghij", 21, 12);
    EXPECT_EQ(after.text, "...cdefghij");
    EXPECT_EQ(after.caret, "           ^");
}

}  // namespace
}  // namespace glibra::test
