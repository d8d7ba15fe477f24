// Tests of the reports that consist of one text: JUnit XML and the terminal report.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/utf8.h"
#include "folder.h"
#include "image/write.h"
#include "results_maker.h"
#include "suite/report/report_pictures.h"
#include "suite/report/terminal_report.h"
#include "suite/results/results.h"

namespace glibra::suite {
namespace {

ShotResult failedShot() {
    ShotResult shot;
    shot.suite = "start";
    shot.shot = "teapot";
    shot.verdict = Verdict::failed;
    shot.reason = "240 pixels differ by more than 3/255, 13 may";
    shot.width = shot.height = 256;
    shot.judgement.decidedBy = image::Rung::differences;
    shot.judgement.comparison = {true, false, 300, 40 / 255., 17, 4, 2, 0.01};
    shot.judgement.beyond = 240;
    shot.judgement.bias = 0.25;
    shot.judgement.biasX = 16;
    shot.judgement.cluster = 91;
    shot.judgement.clusterX = 12;
    shot.judgement.clusterY = 3;
    shot.judgement.flip = 0.0125;
    shot.difference = "teapot.difference.png";
    shot.reproduce = "glibra render glib/start/teapot.glib --size 256x256";
    shot.accept = "glibra test scenes/start.toml --only teapot --update";
    shot.milliseconds = 12.5;
    return shot;
}

RunResult runOf(std::vector<ShotResult> shots) {
    RunResult run;
    run.driver = "llvmpipe (LLVM 15.0.6, 256 bits)";
    run.seconds = 65;
    run.shots = std::move(shots);
    return run;
}

ShotResult withVerdict(Verdict verdict) {
    ShotResult shot;
    shot.suite = "start";
    shot.shot = std::string("shot-") + name(verdict);
    shot.verdict = verdict;
    return shot;
}

int occurrences(const std::string& text, const std::string& part) {
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++count;
    return count;
}

TEST(TextReports, NameTheToleranceThatWouldPass) {
    ShotResult shot = failedShot();
    shot.steps = {{0, 1, 2, 4, 8, 16}, {300, 280, 260, 240, 12, 0}};
    shot.toPass = "tolerance = { cluster = 91 }";
    ShotResult other = failedShot();
    other.shot = "cube";
    other.noTolerance = "31 % of the pixels differ by more than 16 of 255";
    const RunResult run = runOf({shot, other});
    const std::string steps = "0: 300, 1: 280, 2: 260, 4: 240, 8: 12, 16: 0 of 255";
    const std::string text = toText(run, {.mapColumns = 0});
    EXPECT_NE(text.find("by more than        " + steps), std::string::npos) << text;
    EXPECT_NE(text.find("would pass      tolerance = { cluster = 91 }\n"), std::string::npos) << text;
    EXPECT_NE(text.find("no tolerance    is sensible: 31 % of"), std::string::npos) << text;
    const std::string junit = toJunit(run);
    EXPECT_NE(junit.find("would pass: tolerance = { cluster = 91 }\n"), std::string::npos) << junit;
    EXPECT_NE(junit.find("by more than: " + steps), std::string::npos) << junit;
    EXPECT_NE(junit.find("no tolerance is sensible: 31 % of"), std::string::npos) << junit;
    const std::string markdown = toMarkdown(run, {.results = {}, .picturesAt = "https://a"});
    EXPECT_NE(markdown.find("would pass: <code>tolerance = &#123; cluster = 91 &#125;</code>"),
              std::string::npos)
        << markdown;
    EXPECT_NE(markdown.find("no tolerance is sensible: 31 % of"), std::string::npos) << markdown;
    EXPECT_NE(markdown.find(steps), std::string::npos) << markdown;
}

/// Lists of somebody else's results may be of any length, and their texts of any kind.
TEST(TextReports, ShowFewOfManySteps) {
    ShotResult shot = failedShot();
    shot.steps.limits.assign(100'000, 1e300);
    shot.steps.pixels.assign(50'000, 7);
    EXPECT_LT(stepsText(shot).size(), 200U);
    shot.toPass = "</code>|\n# <script>";
    const std::string markdown = toMarkdown(runOf({shot}), {.results = {}, .picturesAt = "https://a"});
    EXPECT_EQ(markdown.find("<script>"), std::string::npos);
    EXPECT_EQ(occurrences(markdown, "</code>"), 1);
}

TEST(TextReports, ListWhatUpdateHasWrittenInOneTable) {
    ShotResult made = withVerdict(Verdict::updated);
    made.reason = "golden made: 32 x 32 pixels";
    ShotResult replaced = failedShot();
    replaced.verdict = Verdict::updated;
    replaced.goldenVariant = "nvidia";
    replaced.reason = "golden replaced: 240 pixels differ";
    const std::string text = toText(runOf({made, replaced, withVerdict(Verdict::passed)}), {});
    EXPECT_NE(text.find("2 goldens written, on llvmpipe (LLVM 15.0.6, 256 bits)\n"), std::string::npos)
        << text;
    EXPECT_NE(text.find("start/shot-updated  all drivers  -                   -         golden made"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("start/teapot        nvidia       300 (0.458 %)       40/255    golden replaced"),
              std::string::npos)
        << text;
    EXPECT_EQ(toText(runOf({withVerdict(Verdict::passed)}), {}).find("golden"), std::string::npos);
}

TEST(TextReports, NameOneCommandForAllPicturesOfGitLfs) {
    ShotResult shot = failedShot(), other = failedShot(), stored = failedShot();
    shot.awaits = {"g/a.png", "g/a.llvmpipe.png"};
    other.awaits = {"g/b.png", "g/a.png"};
    stored.awaits = {"g/c.png"};
    stored.awaitsStore = true;
    const std::string line = awaitedLine(runOf({shot, other, stored}));
    EXPECT_EQ(line.rfind("3 pictures of Git LFS have to be downloaded", 0), 0U) << line;
    EXPECT_EQ(line.find("c.png"), std::string::npos) << line;
    EXPECT_EQ(awaitedLine(runOf({stored, failedShot()})), "");
}

TEST(Figures, SayWhatWasMeasuredAndWhatIsBeyondItsLimit) {
    const std::vector<Figure> list = figures(failedShot());
    ASSERT_EQ(list.size(), 7U);
    EXPECT_EQ(list[0].value, "40/255 (blue, at 17 4)");
    EXPECT_EQ(list[0].limit, "3/255");
    EXPECT_TRUE(list[0].beyond);
    EXPECT_EQ(list[1].value, "240 (0.366 %)");
    EXPECT_TRUE(list[1].beyond);
    EXPECT_EQ(list[2].value, "91 (at 12 3)");
    EXPECT_EQ(list[2].limit, "8");
    EXPECT_TRUE(list[2].beyond);
    EXPECT_EQ(list[5].value, "0.25/255 (at 16 0)");
    EXPECT_FALSE(list[5].beyond);
    EXPECT_EQ(list[6].value, "0.01250");
}

TEST(Figures, AreNoneWhereNothingWasCompared) {
    EXPECT_TRUE(figures(withVerdict(Verdict::crashed)).empty());
    EXPECT_TRUE(figures(withVerdict(Verdict::passed)).empty());
}

TEST(Figures, NaNAgainstANumberIsCalledNoNumber) {
    ShotResult shot = failedShot();
    shot.judgement.comparison.largest = std::numeric_limits<double>::infinity();
    EXPECT_EQ(figures(shot)[0].value, "not a number (blue, at 17 4)");
}

TEST(Junit, CountsEachKindOfOutcomeOnce) {
    RunResult run = runOf({});
    for (const Verdict verdict : kVerdictsByConcern) run.shots.push_back(withVerdict(verdict));
    const std::string xml = toJunit(run);
    EXPECT_NE(xml.find(R"(<testsuites name="glibra" tests="11" failures="3" errors="3" time="65.000">)"),
              std::string::npos)
        << xml;
    EXPECT_NE(xml.find(R"(<testsuite name="start" tests="11" failures="3" errors="3" skipped="2")"),
              std::string::npos)
        << xml;
    EXPECT_EQ(occurrences(xml, "<failure "), 3);
    EXPECT_EQ(occurrences(xml, "<error "), 3) << "the failed shot has no picture";
    EXPECT_EQ(occurrences(xml, "<skipped "), 2);
    EXPECT_EQ(occurrences(xml, "<testcase "), 11);
}

TEST(Junit, HoldsTheReasonTheFiguresAndTheCommands) {
    const std::string xml = toJunit(runOf({failedShot()}));
    EXPECT_NE(xml.find(R"(message="240 pixels differ by more than 3/255, 13 may")"), std::string::npos)
        << xml;
    EXPECT_NE(xml.find("largest difference: 40/255 (blue, at 17 4), limit 3/255"), std::string::npos) << xml;
    EXPECT_NE(xml.find("reproduce: glibra render"), std::string::npos);
    EXPECT_NE(xml.find("accept: glibra test"), std::string::npos);
    EXPECT_NE(xml.find(R"(name="teapot" classname="start" time="0.013")"), std::string::npos) << xml;
}

TEST(Junit, NothingOfWhatXmlCannotHoldGetsIn) {
    ResultsMaker maker(6);
    RunResult run = maker.run();
    for (int i = 0; i < 300; ++i) run.shots.push_back(maker.shot());
    const std::string xml = toJunit(run);
    EXPECT_TRUE(base::isUtf8(xml));
    for (const char each : xml)
        ASSERT_TRUE(static_cast<unsigned char>(each) >= 0x20 || each == '\n' || each == '\t' || each == '\r');
    EXPECT_EQ(xml.find('\x7f'), std::string::npos);
    // Text outside of tags has no '<', and attributes have no '"' except their own quotes.
    EXPECT_EQ(occurrences(xml, "<"), occurrences(xml, ">"));
    EXPECT_EQ(occurrences(xml, "\"") % 2, 0);
    EXPECT_EQ(xml.find("</script>"), std::string::npos);
}

TEST(Terminal, EndsWithTheSummary) {
    const std::string text =
        toText(runOf({failedShot(), withVerdict(Verdict::passed), withVerdict(Verdict::missing)}), {});
    const std::string end =
        "1 drawn without a golden, 1 failed, 1 passed; 3 shots in 1 min 5 s, llvmpipe (LLVM 15.0.6, 256 "
        "bits)\n";
    ASSERT_GE(text.size(), end.size());
    EXPECT_EQ(text.substr(text.size() - end.size()), end) << text;
}

TEST(Terminal, PicturesOfANewSuiteAreNoFailures) {
    std::vector<ShotResult> shots;
    for (int i = 0; i < 30; ++i) shots.push_back(withVerdict(Verdict::missing));
    EXPECT_EQ(counts(runOf({shots[0]})), "1 drawn, it has no golden yet");
    EXPECT_EQ(counts(runOf(shots)), "30 drawn, none has a golden yet");
    // Scenes that cannot be drawn have no golden either.
    for (int i = 0; i < 10; ++i) shots.push_back(withVerdict(Verdict::failed));
    EXPECT_EQ(counts(runOf(shots)), "30 drawn, 10 failed, none has a golden yet");
    shots.push_back(withVerdict(Verdict::crashed));
    EXPECT_EQ(counts(runOf(shots)), "30 drawn, 10 failed, 1 crashed, none has a golden yet");
    shots.push_back(withVerdict(Verdict::passed));
    EXPECT_EQ(counts(runOf(shots)), "30 drawn without a golden, 10 failed, 1 crashed, 1 passed");
}

TEST(Terminal, ShowsTheReasonTheFiguresAndTheCommandsOfAFailure) {
    const std::string text = toText(runOf({failedShot()}), {});
    EXPECT_NE(text.find("failed start/teapot: 240 pixels differ by more than 3/255, 13 may\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("largest difference  40/255 (blue, at 17 4)  limit 3/255"), std::string::npos)
        << text;
    EXPECT_NE(text.find("accept          glibra test scenes/start.toml --only teapot --update"),
              std::string::npos)
        << text;
}

TEST(Terminal, ShowsNoPlainPassAndNothingTwice) {
    const std::string text = toText(runOf({withVerdict(Verdict::passed), withVerdict(Verdict::skipped)}), {});
    EXPECT_EQ(occurrences(text, "\n"), 1) << text;
    RunResult many = runOf({});
    for (int i = 0; i < 400; ++i) many.shots.push_back(failedShot());
    const std::string long400 = toText(many, {});
    EXPECT_EQ(occurrences(long400, "reproduce"), 20);
    EXPECT_EQ(occurrences(long400, "failed start/teapot"), 400);
    EXPECT_NE(long400.find("380 more with one line each"), std::string::npos);
}

TEST(Terminal, ShowsAWarningOfPassesOnceWithTheNumberOfShots) {
    std::vector<ShotResult> shots(4, withVerdict(Verdict::passed));
    const Diagnostic unknown = diagnose("glib-W23", "no program of the scene has a uniform 'uKe'");
    for (std::size_t i = 1; i < shots.size(); ++i) {
        shots[i].shot = "oval" + std::to_string(i);
        shots[i].diagnostics = {unknown, unknown, diagnose("draw-N01", "no LookAt")};
    }
    const std::string text = toText(runOf(shots), {});
    EXPECT_TRUE(
        text.starts_with("warning: no program of the scene has a uniform 'uKe' [glib-W23] in 3 shots, as "
                         "start/oval1\n4 passed"))
        << text;
    for (int i = 0; i < 30; ++i)
        shots[0].diagnostics.push_back(diagnose("glib-W23", "number " + std::to_string(i)));
    const std::string many = toText(runOf(shots), {});
    EXPECT_EQ(occurrences(many, "warning: "), 10) << many;
    EXPECT_NE(many.find("21 more warnings are not shown"), std::string::npos) << many;
}

TEST(Terminal, NoByteOfASceneControlsTheTerminal) {
    ShotResult shot = failedShot();
    shot.reason =
        "before\033[2J\r\x07 \xc2\x9b"
        "after";
    shot.diagnostics.push_back(diagnose("glsl-E01", "\033]0;title\007", {"a\033.frag", 1, 1}));
    const std::string text = toText(runOf({shot}), {});
    EXPECT_EQ(text.find('\033'), std::string::npos);
    EXPECT_EQ(text.find('\r'), std::string::npos);
    EXPECT_EQ(text.find('\x07'), std::string::npos);
    EXPECT_EQ(text.find("\xc2\x9b"), std::string::npos);
    EXPECT_NE(toText(runOf({shot}), {.color = true}).find("\033[1;31mfailed"), std::string::npos);
}

image::Image black(int width, int height) {
    image::Image picture{width, height, 3, image::Component::u8, {}};
    picture.data.resize(picture.rowBytes() * static_cast<std::size_t>(height));
    return picture;
}

TEST(SmallHeatMap, ASinglePixelIsSeenAtItsPlace) {
    image::Image picture = black(640, 320);
    const std::size_t pixel = (std::size_t{310} * 640 + 12) * 3;
    std::fill_n(picture.data.begin() + static_cast<std::ptrdiff_t>(pixel), 3, std::byte{255});
    const std::vector<std::string> rows = smallHeatMap(picture, 40, false);
    ASSERT_EQ(rows.size(), 10U);
    for (std::size_t row = 0; row < rows.size(); ++row)
        EXPECT_EQ(rows[row], row == 9 ? "@" + std::string(39, ' ') : std::string(40, ' ')) << row;
}

TEST(SmallHeatMap, InColourACharacterIsTwoCells) {
    image::Image picture = black(4, 4);
    for (std::size_t i = 0; i < 12; ++i) picture.data[i] = std::byte{200};  // the first row
    const std::vector<std::string> rows = smallHeatMap(picture, 4, true);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(occurrences(rows[0], "\033[38;2;200;200;200;48;2;0;0;0m\u2580"), 4) << rows[0];
    EXPECT_EQ(occurrences(rows[1], "\033[38;2;0;0;0;48;2;0;0;0m\u2580"), 4) << rows[1];
}

TEST(SmallHeatMap, FitsForPicturesOfAnyShape) {
    for (const auto& [width, height] :
         {std::pair{1, 1}, {1, 5000}, {5000, 1}, {3, 2}, {2000, 2000}, {7, 900}})
        for (const bool color : {false, true}) {
            const std::vector<std::string> rows = smallHeatMap(black(width, height), 48, color);
            ASSERT_GE(rows.size(), 1U);
            EXPECT_LE(rows.size(), 16U);
            if (!color) {
                EXPECT_LE(rows[0].size(), 48U);
            }
        }
    EXPECT_TRUE(smallHeatMap({}, 48, false).empty());
}

TEST(Terminal, ShowsTheDifferencePictureOfTheResultsFolder) {
    const Folder folder;
    image::Image picture = black(96, 96);
    std::fill(picture.data.begin(), picture.data.begin() + std::ptrdiff_t{96} * 3 * 48, std::byte{255});
    ASSERT_TRUE(image::writeImage(picture, folder / "teapot.difference.png").empty());
    const std::string text = toText(runOf({failedShot()}), {.resultsFolder = folder.path()});
    EXPECT_EQ(occurrences(text, "    |" + std::string(32, '@') + "|\n"), 8) << text;
    EXPECT_EQ(occurrences(text, "    |" + std::string(32, ' ') + "|\n"), 8) << text;
}

}  // namespace
}  // namespace glibra::suite
