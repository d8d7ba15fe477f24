#include "suite/run/verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <utility>

#include "folder.h"
#include "pictures.h"

namespace glibra::suite {
namespace {

class Verdicts : public testing::Test {
  protected:
    Verdicts() {
        suite.name = "s";
        suite.file = "s.toml";
        suite.goldens = folder / "goldens";
    }
    ShotJudge judge(JudgeOptions options = {}, const std::string& family = "llvmpipe") {
        options.results = folder / "results";
        store = *GoldenStore::open(suite);
        return {suite, store, family, "key", options};
    }
    /// The verdict of a run on the picture: first() and, if necessary, second() with `again`.
    Judged decide(const Shot& which, const image::Image& image, JudgeOptions options = {},
                  const std::optional<image::Image>& again = {}, const std::string& family = "llvmpipe") {
        const ShotJudge judge = this->judge(std::move(options), family);
        const Attempt attempt = attemptAt(which, image);
        if (std::optional<Judged> first = judge.first(attempt)) return *first;
        return judge.second(attempt, attemptAt(which, again ? *again : image));
    }
    /// Runs --update and adds the accepted pixels to the list.
    ShotResult accept(const Shot& which, const image::Image& image, JudgeOptions options = {}) {
        options.update = true;
        const Judged judged = decide(which, image, options);
        if (judged.accepted) {
            EXPECT_TRUE(acceptHashes(store.hashFile(), std::vector{*judged.accepted}).empty());
        }
        return judged.result;
    }
    bool exists(const std::filesystem::path& path) const { return std::filesystem::exists(folder / path); }
    image::Image golden(const Shot& which) { return *decode(*store.find(which, "llvmpipe")); }

    Folder folder;
    Suite suite;
    GoldenStore store = *GoldenStore::open(suite);
    Shot shot = shotNamed("a");
};

TEST_F(Verdicts, WithoutAGoldenItIsMissingAndThePictureIsThere) {
    const ShotResult result = decide(shot, gradient()).result;
    EXPECT_EQ(result.verdict, Verdict::missing);
    EXPECT_TRUE(exists("results" / result.got));
    EXPECT_EQ(result.accept, "glibra test s.toml --only a --update --allow-outside");
}

TEST_F(Verdicts, UpdateMakesTheGoldenAndTheNextRunIsDecidedByTheHash) {
    const ShotResult made = accept(shot, gradient());
    EXPECT_EQ(made.verdict, Verdict::updated);
    EXPECT_TRUE(exists("goldens/a.png"));
    const ShotResult next = decide(shot, gradient()).result;
    EXPECT_EQ(next.verdict, Verdict::passed);
    EXPECT_TRUE(next.exact);
    EXPECT_FALSE(next.changed);
    EXPECT_EQ(next.expected, folder / "goldens/a.png");
    EXPECT_TRUE(next.got.empty());
}

TEST_F(Verdicts, TheHashSavesOpeningTheGolden) {
    // A golden that is not a picture, with accepted pixels for exactly these bytes.
    writeText(folder / "goldens/a.png", "no picture");
    const Golden broken = *GoldenStore::open(suite)->find(shot, "llvmpipe");
    ASSERT_TRUE(acceptHashes(GoldenStore::open(suite)->hashFile(),
                             std::vector{AcceptedHash{"a", "", broken.identity, hashOf(gradient()), "key"}})
                    .empty());
    EXPECT_EQ(decide(shot, gradient()).result.verdict, Verdict::passed);
    const ShotResult other = decide(shot, gradient(1)).result;
    EXPECT_EQ(other.verdict, Verdict::failed);
    EXPECT_NE(other.reason.find("--update"), std::string::npos) << other.reason;
}

TEST_F(Verdicts, WithinTheToleranceOfTheGoldenButOtherThanBeforeIsChanged) {
    accept(shot, gradient());
    image::Image other = gradient();
    other.data[40] ^= std::byte{1};
    const ShotResult result = decide(shot, other).result;
    EXPECT_EQ(result.verdict, Verdict::passed);
    EXPECT_FALSE(result.exact);
    EXPECT_TRUE(result.changed);
}

TEST_F(Verdicts, UpdateKeepsAGoldenThatStillFitsAndAcceptsTheNewPixels) {
    accept(shot, gradient());
    const std::string before = textOf(folder / "goldens/a.png");
    image::Image other = gradient();
    other.data[40] ^= std::byte{1};
    EXPECT_EQ(accept(shot, other).verdict, Verdict::passed);
    EXPECT_EQ(textOf(folder / "goldens/a.png"), before);
    const ShotResult next = decide(shot, other).result;
    EXPECT_TRUE(next.exact);
    EXPECT_FALSE(next.changed);
}

TEST_F(Verdicts, AnotherPictureFailsWithAllThatAReportShows) {
    accept(shot, gradient());
    const ShotResult result = decide(shot, gradient(40)).result;
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_FALSE(result.reason.empty());
    EXPECT_FALSE(result.judgement.same);
    EXPECT_NEAR(result.judgement.comparison.largest, 40 / 255.0, 1e-6);
    for (const auto& each : {result.got, result.expected, result.difference}) {
        EXPECT_FALSE(each.empty());
        EXPECT_TRUE(each.is_relative());
        EXPECT_TRUE(exists("results" / each)) << each;
    }
}

TEST_F(Verdicts, AnotherSizeFails) {
    accept(shot, gradient());
    const ShotResult result = decide(shot, picture(16, 32, [](int x, int y, int) { return x + y; })).result;
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_EQ(result.width, 16);
}

TEST_F(Verdicts, TwoRenderingsThatDifferAreUnstable) {
    accept(shot, gradient());
    const ShotResult result = decide(shot, gradient(40), {}, gradient(41)).result;
    EXPECT_EQ(result.verdict, Verdict::unstable);
    EXPECT_FALSE(result.judgement.comparison.identical);
    EXPECT_TRUE(exists("results" / result.expected));
}

TEST_F(Verdicts, AnUnstablePictureBecomesNoGolden) {
    const ShotResult result = decide(shot, gradient(), {.update = true, .force = true}, gradient(1)).result;
    EXPECT_EQ(result.verdict, Verdict::unstable);
    EXPECT_FALSE(exists("goldens/a.png"));
}

TEST_F(Verdicts, UpdateReplacesWhatDiffersAndSaysByHowMuch) {
    accept(shot, gradient());
    const ShotResult result = accept(shot, gradient(40));
    EXPECT_EQ(result.verdict, Verdict::updated);
    EXPECT_EQ(result.reason.rfind("golden replaced: ", 0), 0U) << result.reason;
    EXPECT_GT(result.reason.size(), std::string("golden replaced: ").size());
    EXPECT_NEAR(result.judgement.comparison.largest, 40 / 255.0, 1e-6);
    EXPECT_TRUE(exists("results" / result.expected)) << "the old one, to look at";
    EXPECT_TRUE(image::compare(golden(shot), gradient(40)).identical);
}

TEST_F(Verdicts, AGoodGoldenIsNotReplacedByOneColourWithoutForce) {
    accept(shot, gradient());
    const ShotResult refused = accept(shot, oneColor(90));
    EXPECT_EQ(refused.verdict, Verdict::refused);
    EXPECT_NE(refused.reason.find("one colour"), std::string::npos) << refused.reason;
    EXPECT_TRUE(image::compare(golden(shot), gradient()).identical);

    EXPECT_EQ(accept(shot, oneColor(90), {.force = true}).verdict, Verdict::updated);
    EXPECT_TRUE(image::compare(golden(shot), oneColor(90)).identical);
    EXPECT_EQ(accept(shot, oneColor(200)).verdict, Verdict::updated) << "the old one is no better";
}

TEST_F(Verdicts, ANewGoldenOfOneColourNeedsForceToo) {
    EXPECT_EQ(accept(shot, oneColor(0)).verdict, Verdict::refused);
    EXPECT_FALSE(exists("goldens/a.png"));
}

TEST_F(Verdicts, NanTransparencyAndOneColourAreNoGoldens) {
    EXPECT_NE(whyNoGolden(floats(1.F, std::nanf(""))), "");
    EXPECT_NE(whyNoGolden(floats(1.F, INFINITY)), "");
    EXPECT_NE(whyNoGolden(floats(1.F, 1.F)), "");
    EXPECT_EQ(whyNoGolden(floats(1.F, 2.F)), "");
    image::Image clear{2, 1, 4, image::Component::u8, std::vector<std::byte>(8)};
    clear.data[0] = std::byte{9};
    EXPECT_NE(whyNoGolden(clear), "");
    clear.data[3] = std::byte{1};
    EXPECT_EQ(whyNoGolden(clear), "");
    EXPECT_EQ(whyNoGolden(gradient()), "");
}

TEST_F(Verdicts, ADamagedGoldenIsReplacedByUpdate) {
    writeText(folder / "goldens/a.png", "\x89PNG\r\n\x1a\nand no more");
    EXPECT_EQ(decide(shot, gradient()).result.verdict, Verdict::failed);
    EXPECT_EQ(accept(shot, gradient()).verdict, Verdict::updated);
    EXPECT_EQ(decide(shot, gradient()).result.verdict, Verdict::passed);
}

TEST_F(Verdicts, AVariantIsForOneFamilyOnly) {
    accept(shot, gradient());
    const JudgeOptions variant{.update = true, .variant = true};
    EXPECT_EQ(decide(shot, gradient(40), variant, {}, "nvidia").result.verdict, Verdict::updated);
    EXPECT_TRUE(exists("goldens/a.nvidia.png"));
    EXPECT_EQ(decide(shot, gradient()).result.verdict, Verdict::passed);
    const ShotResult there = decide(shot, gradient(40), {}, {}, "nvidia").result;
    EXPECT_EQ(there.verdict, Verdict::passed);
    EXPECT_EQ(there.goldenVariant, "nvidia");
}

TEST_F(Verdicts, TheGoldenForAllDriversIsRightForAFamilyToo) {
    accept(shot, gradient());
    const JudgeOptions variant{.update = true, .variant = true};
    ASSERT_EQ(decide(shot, gradient(40), variant, {}, "nvidia").result.verdict, Verdict::updated);
    const ShotResult general = decide(shot, gradient(), {}, {}, "nvidia").result;
    EXPECT_EQ(general.verdict, Verdict::passed);
    EXPECT_EQ(general.goldenVariant, "");
    EXPECT_EQ(decide(shot, gradient(80), {}, {}, "nvidia").result.verdict, Verdict::failed);
    // But a golden that cannot be read is a fault, whatever the other says.
    std::ofstream(folder / "goldens/a.nvidia.png") << "no picture";
    EXPECT_NE(decide(shot, gradient(), {}, {}, "nvidia").result.verdict, Verdict::passed);
}

class Failures : public Verdicts {
  protected:
    ShotResult fails(const Diagnostics& diagnostics) {
        Attempt attempt;
        attempt.shot = &shot;
        attempt.own.diagnostics = diagnostics;
        return judge().first(attempt)->result;
    }
    const Diagnostic compile = diagnose("glsl-E01", "'uColour' is not declared", {"a.frag", 7, 3});
};

TEST_F(Failures, ASceneWithErrorsIsReportedByItsFirstError) {
    const ShotResult result = fails({diagnose("glib-W04", "remark"), compile});
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_EQ(result.reason, toString(compile));
    EXPECT_EQ(result.diagnostics.size(), 2U);
}

TEST_F(Failures, AnExpectedErrorPasses) {
    for (const ExpectedError& expected :
         {ExpectedError{}, ExpectedError{"glsl-E01", "", 0}, ExpectedError{"glsl-E01", "uColour", 7},
          ExpectedError{"", "not declared", 0}}) {
        shot.expectedError = expected;
        EXPECT_EQ(fails({compile}).verdict, Verdict::passed) << toPhrase(expected);
    }
}

TEST_F(Failures, AnotherErrorThanTheExpectedOneFails) {
    for (const ExpectedError& expected : {ExpectedError{"glsl-E02", "", 0}, ExpectedError{"glsl-E01", "", 8},
                                          ExpectedError{"", "uColor ", 0}}) {
        shot.expectedError = expected;
        EXPECT_EQ(fails({compile}).verdict, Verdict::failed) << toPhrase(expected);
    }
    shot.expectedError = ExpectedError{"glib-W04", "", 0};
    EXPECT_EQ(fails({diagnose("glib-W04", "only a warning"), compile}).verdict, Verdict::failed);
}

TEST_F(Failures, AnExpectedErrorThatDoesNotComeFails) {
    shot.expectedError = ExpectedError{"glsl-E01", "", 0};
    const ShotResult result = decide(shot, gradient()).result;
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_NE(result.reason.find("glsl-E01"), std::string::npos);
    EXPECT_TRUE(result.accept.empty());
}

class Pairs : public Verdicts {
  protected:
    ShotResult against(const image::Image& own, const image::Image& partner, bool match) {
        shot.golden = false;
        (match ? shot.match : shot.differ) = "b";
        Attempt attempt = attemptAt(shot, own);
        (match ? attempt.match : attempt.differ).emplace().picture = partner;
        const ShotJudge judge = this->judge();
        if (std::optional<Judged> first = judge.first(attempt)) return first->result;
        return judge.second(attempt, attempt).result;
    }
};

TEST_F(Pairs, AMatchHasToBeTheSamePicture) {
    EXPECT_EQ(against(gradient(), gradient(), true).verdict, Verdict::passed);
    const ShotResult result = against(gradient(), gradient(40), true);
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_NE(result.reason.find("'b'"), std::string::npos);
    EXPECT_TRUE(exists("results" / result.expected)) << "the partner's picture";
}

TEST_F(Pairs, APairThatHasToDifferMayNotBeTheSame) {
    EXPECT_EQ(against(gradient(), gradient(40), false).verdict, Verdict::passed);
    EXPECT_EQ(against(gradient(), gradient(), false).verdict, Verdict::failed);
}

TEST_F(Failures, ACheckThatFailsIsRepeatedByCheck) {
    Attempt attempt = attemptAt(shot, gradient());
    attempt.own.failedChecks.push_back(diagnose("check-E01", "Expect (k == 1): expected true, found k is 2"));
    shot.options.width = shot.options.height = 32;
    const ShotResult result = judge().first(attempt)->result;
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_EQ(result.reproduce, "glibra check --run " + shot.script.string() + " --size 32x32");
    EXPECT_EQ(result.accept, "") << "a golden does not make the check hold";
    shot.options.axes = true;  // which `glibra check` does not have
    EXPECT_TRUE(judge().first(attempt)->result.reproduce.starts_with("glibra render "));
}

TEST_F(Pairs, APartnerThatFailsFailsThePair) {
    shot.golden = false;
    shot.match = "b";
    Attempt attempt = attemptAt(shot, gradient());
    attempt.match.emplace().diagnostics.push_back(diagnose("glib-E01", "unknown command"));
    const ShotJudge judge = this->judge();
    ASSERT_FALSE(judge.first(attempt));
    const ShotResult result = judge.second(attempt, attempt).result;
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_NE(result.reason.find("unknown command"), std::string::npos);
}

TEST_F(Pairs, UpdateDoesNotHideABrokenPair) {
    shot.match = "b";
    Attempt attempt = attemptAt(shot, gradient());
    attempt.match.emplace().picture = gradient(40);
    const ShotJudge judge = this->judge({.update = true});
    EXPECT_EQ(judge.second(attempt, attempt).result.verdict, Verdict::failed);
}

}  // namespace
}  // namespace glibra::suite
