// Rubrics: how they are read, and which marks they give.

#include "classroom/rubric.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glibra::classroom {
namespace {

Picture pictureWith(double flip, double likenessOf) {
    Picture picture;
    picture.verdict = suite::Verdict::passed;
    picture.file = "pictures/0001-1.png";
    picture.score = Score{flip, 0, likenessOf};
    return picture;
}

/// A class of one, with two moments that vary uAd.
Classroom classOfOne() {
    Classroom room;
    room.reference.submission.scene = "solution.glib";
    room.reference.reactions = {Change{0.1, 0.1}};
    room.moments.resize(2);
    room.moments[0].label = "uAd=0.1";
    room.moments[1].label = "uAd=0.3";
    room.sliders = {{"uAd", {{0, 1}}}};
    Entry& entry = room.entries.emplace_back();
    entry.submission = {"ana", "all/ana", "all/ana/a.glib", {}};
    entry.pictures = {pictureWith(0.01, 0.9), pictureWith(0.09, 0.6)};
    entry.reactions = {Change{0.08, 0.08}};
    entry.ranges = {{"uAd", 0.01, 0.5}};
    entry.calls = {"main", "mix", "smoothstep"};
    entry.programs = {
        {"P", {"vertex", "tessellation control", "fragment"}, {{"uAd", "float"}, {"uBd", "float"}}}};
    return room;
}

Mark markOf(const std::string& check, const Classroom& room = classOfOne()) {
    const Result<Rubric> rubric = readRubricText("[[check]]\npoints = 4\n" + check, "class.toml");
    EXPECT_TRUE(rubric) << check;
    if (!rubric) return {};
    Entry entry = room.entries[0];
    giveMarks(*rubric, room, {}, entry);
    return entry.marks.at(0);
}

TEST(Rubrics, GivePointsForEachKindOfCheck) {
    EXPECT_EQ(markOf("drawn = true").points, 4);
    EXPECT_EQ(markOf("slider = \"uAd\"").points, 4);
    EXPECT_EQ(markOf("slider = \"uAd\"\nrange = [0.01, 0.5]").points, 4);
    EXPECT_EQ(markOf("slider = \"uAd\"\nrange = [0, 1]").points, 2) << "the name is right";
    EXPECT_EQ(markOf("slider = \"uBd\"").points, 2) << "a uniform without a range";
    EXPECT_EQ(markOf("slider = \"uTol\"").points, 0);
    EXPECT_EQ(markOf("stage = \"tessellation\"").points, 4);
    EXPECT_EQ(markOf("stage = \"geometry\"").points, 0);
    EXPECT_EQ(markOf("reacts = \"uAd\"").points, 4);
    EXPECT_EQ(markOf("ignores = \"uAd\"").points, 0);
    EXPECT_EQ(markOf("uses = \"smoothstep\"").points, 4);
    EXPECT_EQ(markOf("uses = \"texture\"").points, 0);
    EXPECT_EQ(markOf("avoids = \"texture\"").points, 4);
    EXPECT_EQ(markOf("avoids = \"mix\"").points, 0);
    Classroom idle = classOfOne();
    idle.entries[0].programs[0].idle = {"tessellation control"};
    EXPECT_EQ(markOf("stage = \"tessellation\"", idle).points, 0) << "nothing is drawn with it";
    EXPECT_EQ(markOf("stage = \"fragment\"", idle).points, 4);
    Classroom undrawn = classOfOne();
    for (Picture& each : undrawn.entries[0].pictures) each.verdict = suite::Verdict::failed;
    for (const char* each : {"stage = \"fragment\"", "uses = \"mix\"", "avoids = \"texture\""}) {
        EXPECT_EQ(markOf(each, undrawn).points, 0) << each;
        EXPECT_EQ(markOf(each, undrawn).reason, "no picture was drawn") << each;
    }
    undrawn.entries[0].pictures[1].verdict = suite::Verdict::passed;
    EXPECT_EQ(markOf("stage = \"fragment\"", undrawn).points, 4) << "a picture is drawn with it";
    EXPECT_EQ(markOf("without = \"glib-W*\"").points, 4);
    EXPECT_EQ(markOf("by-hand = true").points, 0);
    EXPECT_TRUE(markOf("by-hand = true").isOpen);
    EXPECT_EQ(markOf("solved = true").points, 4);
}

TEST(Rubrics, AnExerciseIsSolvedIfAllItsPicturesAre) {
    Classroom room = classOfOne();
    room.entries[0].pictures[1].score->unsolved = "its picture differs";
    const Mark mark = markOf("solved = true", room);
    EXPECT_EQ(mark.points, 0);
    EXPECT_EQ(mark.reason, "at uAd=0.3 its picture differs");
    EXPECT_EQ(mark.moment, 1U);
    room.entries[0].pictures[0].score.reset();
    EXPECT_EQ(markOf("solved = true", room).reason, "at uAd=0.1 a picture was not drawn");
    room.entries[0].pictures.clear();
    EXPECT_EQ(markOf("solved = true", room).points, 0);
    ASSERT_EQ(solvedRubric().checks.size(), 1U);
    EXPECT_EQ(solvedRubric().checks[0].name, "is solved");
}

TEST(Rubrics, GivePartialCreditForLikeness) {
    // 1 at 0.8 and more, 0 at 0.4 and less.
    EXPECT_EQ(markOf("like = 0.8").points, 3) << "1 and 0.5";
    EXPECT_EQ(markOf("like = 0.8\nat = \"uAd=0.1\"").points, 4);
    const Mark worst = markOf("like = 0.8\nat = [\"uAd=0.3\"]");
    EXPECT_EQ(worst.points, 2);
    EXPECT_EQ(worst.moment, std::optional<std::size_t>(1));
    EXPECT_EQ(worst.reason, "likeness 0.600");
    EXPECT_EQ(markOf("like = 0.8\nnone = 0.7").points, 2);
    Classroom without = classOfOne();
    for (Picture& each : without.entries[0].pictures) {
        each.score->effect = 0.1;
        each.score->kept = 0;
    }
    EXPECT_EQ(markOf("like = 0.2\nmeasure = \"flip\"", without).points, 0) << "without the effect";
    EXPECT_EQ(markOf("like = 0.2\nmeasure = \"flip\"", without).reason,
              "at worst FLIP 0.090, because it does not change as the reference does");
    EXPECT_EQ(markOf("like = 0.5").reason, "at worst likeness 0.600") << "both have all points";
    EXPECT_EQ(markOf("like = 0.5").moment, std::optional<std::size_t>(1));
    EXPECT_EQ(markOf("like = 1\nnone = 0.95").reason, "at worst likeness 0.600") << "none has any";
    EXPECT_EQ(markOf("like = 0.1\nmeasure = \"flip\"").reason, "at worst FLIP 0.090");
    EXPECT_EQ(markOf("like = 0.05\nmeasure = \"flip\"\nat = \"uAd=0.1\"").points, 4);
    EXPECT_EQ(markOf("like = 0.05\nmeasure = \"flip\"").points, 3.6) << "(0.25 - 0.09) / 0.2 of the other";
    Classroom room = classOfOne();
    room.entries[0].drawsNothing = true;
    EXPECT_EQ(markOf("like = 0.1", room).points, 0);
    EXPECT_EQ(markOf("drawn = true", room).points, 0);
}

TEST(Rubrics, WeakReactionsAndSingleWarningsAreHalf) {
    Classroom room = classOfOne();
    room.entries[0].reactions = {Change{0.01, 0.01}};
    EXPECT_EQ(markOf("reacts = \"uAd\"", room).points, 2);
    room.entries[0].reactions = {Change{0.08, 0.08, true}};
    EXPECT_EQ(markOf("reacts = \"uAd\"", room).points, 2) << "in another way than the reference";
    room.entries[0].reactions = {Change{0.001, 0.08}};
    EXPECT_EQ(markOf("reacts = \"uAd\"", room).points, 4) << "in a small part of the picture";
    room.entries[0].reactions = {Change{}};
    EXPECT_EQ(markOf("reacts = \"uAd\"", room).points, 0);
    EXPECT_EQ(markOf("ignores = \"uAd\"", room).points, 4);
    room.entries[0].reactions = {std::nullopt};
    EXPECT_EQ(markOf("ignores = \"uAd\"", room).points, 0) << "a picture that was not drawn ignores nothing";
    room.entries[0].diagnostics = {diagnose("glib-W23", "a")};
    EXPECT_EQ(markOf("without = [\"glib-W23\"]", room).points, 2);
    EXPECT_EQ(markOf("without = \"glib-W02\"", room).points, 4);
    room.entries[0].diagnostics.push_back(diagnose("glib-W23", "b"));
    EXPECT_EQ(markOf("without = [\"glib-W23\"]", room).points, 0);
    room.entries[0].diagnostics = {diagnose("glsl-E01", "a"),
                                   {Severity::note, "glsl-E01", "in Program 'P'", {}},
                                   diagnose("check-N03", "b")};
    EXPECT_EQ(markOf("without = \"glsl-*\"", room).points, 2) << "one mistake, and a note that belongs to it";
    EXPECT_EQ(markOf("without = \"check-N*\"", room).points, 2);
}

TEST(Rubrics, PointsAreNeverMoreThanTheMost) {
    const Classroom room = classOfOne();
    for (const std::string points : {"0.125", "0.004", "0.3333", "2.5"}) {
        const Result<Rubric> rubric = readRubricText(
            "[[check]]\nlike = 0.6\npoints = " + points +
                "\n[[check]]\nlike = 0.605\nat = \"uAd=0.3\"\npoints = " + points + "\nname = \"nearly\"\n",
            "x");
        ASSERT_TRUE(rubric) << points;
        Entry entry = room.entries[0];
        giveMarks(*rubric, room, {}, entry);
        EXPECT_EQ(entry.marks[0].points, std::stod(points));
        EXPECT_LE(entry.marks[1].points, std::stod(points));
    }
}

TEST(Rubrics, BonusIsNotAmongTheMostAndLateTakesItsPart) {
    Classroom room = classOfOne();
    const Result<Rubric> rubric = readRubricText(
        "[[check]]\ndrawn = true\npoints = 8\n[[check]]\nuses = \"mix\"\npoints = 2\nbonus = true\n"
        "[late]\ndue = \"2026-11-20 23:59\"\nper-day = 0.1\nmost = 0.5\n",
        "class.toml");
    ASSERT_TRUE(rubric);
    Entry& entry = room.entries[0];
    const auto pointsFor = [&](const HandedIn& handedIn) {
        giveMarks(*rubric, room, handedIn, entry);
        return std::round(pointsOf(entry).value_or(-1) * 100) / 100;
    };
    EXPECT_EQ(pointsFor({}), 10);
    EXPECT_EQ(mostPoints(room), 8);
    EXPECT_EQ(pointsFor({{}, "2026-11-20 23:59", false}), 10);
    EXPECT_EQ(pointsFor({{}, "2026-11-21 00:00", false}), 9);
    EXPECT_EQ(entry.lateReason, "1 day late, 10 % less");
    EXPECT_EQ(pointsFor({{}, "2026-11-22T00:00:10Z", false}), 8);
    EXPECT_EQ(pointsFor({3.0, {}, false}), 7);
    EXPECT_EQ(pointsFor({{}, {}, true}), 9);
    EXPECT_EQ(pointsFor({400.0, {}, false}), 5);
}

TEST(Rubrics, TheFirstOfWhatIsKnownAboutATimeCounts) {
    Classroom room = classOfOne();
    const Result<Rubric> rubric = readRubricText(
        "[[check]]\ndrawn = true\npoints = 10\n[late]\ndue = \"2026-11-20 23:59\"\n", "class.toml");
    const auto lost = [&](const HandedIn& handedIn) {
        giveMarks(*rubric, room, handedIn, room.entries[0]);
        return std::round(10 - pointsOf(room.entries[0]).value_or(-1));
    };
    const std::string time = "Monday, 23 November 2026, 8:00 AM";
    EXPECT_EQ(lost({{}, time, false}), 3);
    EXPECT_EQ(lost({{}, time, false, "Submitted for grading - 1 day 3 hours late"}), 3)
        << "the rule has a due date";
    EXPECT_EQ(lost({{}, {}, false, "Submitted for grading - 1 day 3 hours late"}), 2);
    EXPECT_EQ(
        lost({{}, time, false, "Submitted for grading - Extension granted until: Tuesday, 24 November 2026"}),
        0);
    EXPECT_EQ(
        lost({{}, time, false, "Submitted for grading - 5 mins late - Extension granted until: Monday"}), 1);
    EXPECT_EQ(lost({0.0, time, true}), 0) << "the teacher's own column";
    EXPECT_EQ(lost({{}, {}, true}), 1);
}

TEST(Rubrics, MistakesHaveTheirPlace) {
    const auto idOf = [](const std::string& text) {
        const Result<Rubric> rubric = readRubricText(text, "class.toml");
        return rubric || rubric.diagnostics.empty() ? std::string("none") : rubric.diagnostics[0].id;
    };
    EXPECT_EQ(idOf("[[check]]\nuses = \"mix\"\navoids = \"mix\"\n"), "suite-E24");
    EXPECT_EQ(idOf("[[check]]\nname = \"x\"\n"), "suite-E24");
    EXPECT_EQ(idOf(""), "suite-E24");
    EXPECT_EQ(idOf("[[check]]\ndrawn = true\n[[check]]\ndrawn = true\n"), "suite-E25");
    EXPECT_EQ(idOf("[[check]]\ndrawn = true\npoint = 3\n"), "suite-E02");
    EXPECT_EQ(idOf("[[check]]\nstage = \"pixel\"\n"), "suite-E03");
    EXPECT_EQ(idOf("[[check]]\nlike = 2\n"), "suite-E04");
    EXPECT_EQ(idOf("[[check]]\nlike"), "suite-E01");
    EXPECT_EQ(idOf("[[check]]\nwithout = [\"glsl-E01\", \"glib-*\", \"*-W0?\"]\n"), "none");
    EXPECT_EQ(idOf("[[check]]\ndrawn = true\n[late]\ndue = \"tomorrow\"\n"), "suite-E03");
    const Result<Rubric> rubric = readRubricText(
        "[[check]]\nreacts = \"uBd\"\n[[check]]\nlike = 0.5\nat = \"uAd=7\"\n[[check]]\nreacts = \"uAd\"\n",
        "x");
    ASSERT_TRUE(rubric);
    const Classroom room = classOfOne();
    EXPECT_EQ(problemsOf(*rubric, room.moments, room.sliders, true).size(), 2U);
    EXPECT_EQ(problemsOf(*rubric, room.moments, room.sliders, false).size(), 3U);
    EXPECT_EQ(problemsOf(*rubric, room.moments, room.sliders, true)[1].place, (Place{"x", 3, 1}));
}

/// "LINE ID TEXT" of the first message.
std::string mistakeOf(const std::string& check) {
    const Result<Rubric> rubric = readRubricText("[[check]]\n" + check, "class.toml");
    if (rubric || rubric.diagnostics.empty()) return "none";
    const Diagnostic& first = rubric.diagnostics[0];
    return std::to_string(first.place.line) + " " + first.id + " " + first.text;
}

TEST(Rubrics, LimitsInTheWrongOrderAreErrors) {
    EXPECT_EQ(
        mistakeOf("like = 0.8\nnone = 0.9\n"),
        "3 suite-E04 none: 0.9 is more than 0.8, the likeness of 'like'; points begin at a smaller one");
    EXPECT_EQ(mistakeOf("none = 0.01\nmeasure = \"flip\"\nlike = 0.02\n"),
              "2 suite-E04 none: 0.01 is less than 0.02, the FLIP of 'like'; FLIP grows with the difference, "
              "so points end at a larger one");
    EXPECT_EQ(mistakeOf("like = 0.02\nmeasure = \"flip\"\nnone = 0\n").substr(0, 11), "4 suite-E04");
    EXPECT_EQ(mistakeOf("like = 0.02\nmeasure = \"flip\"\nnone = 0.02\n"), "none") << "all or nothing";
    EXPECT_EQ(mistakeOf("slider = \"uTol\"\nrange = [1, 0]\n"),
              "3 suite-E04 range: 1 is not less than 0; the smaller number comes first");
    EXPECT_EQ(mistakeOf("slider = \"uTol\"\nrange = [1, 1]\n").substr(0, 11), "3 suite-E04");
}

TEST(Rubrics, AStatedNoneOfZeroIsNotTheUsualOne) {
    EXPECT_EQ(markOf("like = 0.8\nnone = 0\nat = \"uAd=0.3\"").points, 3) << "0.6 of 0.8";
}

TEST(Rubrics, KeysOfAnotherKindOfCheckAreErrors) {
    EXPECT_EQ(mistakeOf("slider = \"uTol\"\nmeasure = \"flip\"\n"),
              "3 suite-E24 'measure' belongs to a check that asks for 'like'; this one asks for 'slider'");
    EXPECT_EQ(mistakeOf("range = [0, 1]\nreacts = \"uTol\"\n"),
              "2 suite-E24 'range' belongs to a check that asks for 'slider'; this one asks for 'reacts'");
    EXPECT_EQ(mistakeOf("without = [\"glsl-E01\", \"nonsense-E9\"]\n").substr(0, 56),
              "2 suite-E17 without: there is no message 'nonsense-E9'; ");
    EXPECT_EQ(mistakeOf("drawn = false\n").substr(0, 33), "2 suite-E03 drawn: expected true,");
    EXPECT_EQ(mistakeOf("lik = 0.8\ndrawn = true\n"),
              "2 suite-E02 unknown key 'lik' in [[check]]; did you mean 'like'?");
}

}  // namespace
}  // namespace glibra::classroom
