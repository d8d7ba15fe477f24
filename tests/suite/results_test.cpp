#include "suite/results/results.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "results_maker.h"
#include "suite/report/terminal_report.h"

namespace glibra::suite {
namespace {

const Place kPlace{"results.jsonl", 7, 1};

TEST(Results, EveryVerdictHasItsOwnWord) {
    for (const Verdict verdict : kVerdictsByConcern) EXPECT_EQ(verdictOf(name(verdict)), verdict);
    EXPECT_EQ(std::string(name(Verdict::timedOut)), "timed-out");
    EXPECT_FALSE(verdictOf("good"));
}

TEST(Results, WhatWasSeenAndFoundRightOrNotRunIsNoFailure) {
    for (const Verdict verdict : kVerdictsByConcern)
        EXPECT_EQ(isFailure(verdict), verdict != Verdict::passed && verdict != Verdict::updated &&
                                          verdict != Verdict::skipped && verdict != Verdict::flaky &&
                                          verdict != Verdict::quarantined)
            << name(verdict);
}

TEST(Results, AnyShotComesBackWholeFromItsLine) {
    ResultsMaker maker(1);
    for (int i = 0; i < 2000; ++i) {
        const ShotResult shot = maker.shot();
        const std::string line = toJsonLine(shot);
        ASSERT_EQ(line.find('\n'), std::string::npos);
        const Result<ShotResult> back = parseJsonLine(line, kPlace);
        ASSERT_TRUE(back) << line << "\n" << toString(back.diagnostics.front());
        expectEqual(*back, shot);
        if (testing::Test::HasFailure()) FAIL() << line;
    }
}

TEST(Results, AnyRunComesBackWholeFromItsLine) {
    ResultsMaker maker(2);
    for (int i = 0; i < 500; ++i) {
        const RunResult run = maker.run();
        const Result<RunResult> back = parseRunLine(toJsonLine(run), kPlace);
        ASSERT_TRUE(back);
        EXPECT_EQ(back->driver, run.driver);
        EXPECT_EQ(back->machine, run.machine);
        EXPECT_EQ(back->shard, run.shard);
        EXPECT_EQ(back->command, run.command);
        EXPECT_EQ(std::bit_cast<std::uint64_t>(back->seconds), std::bit_cast<std::uint64_t>(run.seconds));
        EXPECT_EQ(back->began, run.began);
        EXPECT_EQ(back->planned, run.planned);
        EXPECT_EQ(back->missingShards, run.missingShards);
    }
}

TEST(Results, OtherProgramsReadTheLineAsPlainJson) {
    ShotResult shot;
    shot.suite = "start";
    shot.shot = "teapot@time=0.5";
    shot.verdict = Verdict::failed;
    shot.judgement.comparison.largest = 0.25;
    const auto json = nlohmann::json::parse(toJsonLine(shot));
    EXPECT_EQ(json.at("shot"), "teapot@time=0.5");
    EXPECT_EQ(json.at("verdict"), "failed");
    EXPECT_EQ(json.at("judgement").at("comparison").at("largest"), 0.25);
}

TEST(Results, MembersOfALaterVersionArePassedOver) {
    const Result<ShotResult> shot =
        parseJsonLine(R"({"suite":"s","shot":"a","verdict":"passed","colour":{"x":[1]}})", kPlace);
    ASSERT_TRUE(shot);
    EXPECT_EQ(shot->shot, "a");
    EXPECT_EQ(shot->tolerance.largest, image::Tolerance{}.largest);
}

struct BrokenLine {
    const char* line;
    const char* message;
};

class BrokenResults : public testing::TestWithParam<BrokenLine> {};

TEST_P(BrokenResults, AreReportedWithFileAndLine) {
    const Result<ShotResult> shot = parseJsonLine(GetParam().line, kPlace);
    ASSERT_FALSE(shot);
    ASSERT_EQ(shot.diagnostics.size(), 1U);
    const Diagnostic& reported = shot.diagnostics.front();
    EXPECT_EQ(reported.id, "result-E01");
    EXPECT_EQ(reported.place, kPlace);
    EXPECT_NE(reported.text.find(GetParam().message), std::string::npos) << reported.text;
}

INSTANTIATE_TEST_SUITE_P(
    Lines, BrokenResults,
    testing::Values(
        BrokenLine{"", "empty"}, BrokenLine{R"({"width":1e999})", "too large"},
        BrokenLine{"[]", "expected an object"}, BrokenLine{R"({"suite":"s",})", "not JSON"},
        BrokenLine{R"({"suite":"s")", "not JSON"},
        BrokenLine{R"({"suite":"s","shot":"a"})", "'verdict' is missing"},
        BrokenLine{R"({"suite":1,"shot":"a","verdict":"passed"})", "'suite': expected a string"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"good"})", "there is no verdict 'good'"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","width":1e99})",
                   "'width': expected a whole number"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","width":4294967296})", "whole number"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","judgement":{"comparison":{"x":"1"}}})",
                   "'x': expected a whole number"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","judgement":{"decidedBy":"luck"}})",
                   "the comparison has no rung 'luck'"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","diagnostics":[{"severity":"sad"}]})",
                   "there is no severity 'sad'"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","milliseconds":1e308})",
                   "'milliseconds': expected a number between 0 and"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","milliseconds":"nan"})", "'milliseconds'"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","width":-1})", "'width': expected a number"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","height":2000000000})", "'height'"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","diagnostics":[{"place":{"line":-7}}]})",
                   "'line'"},
        BrokenLine{R"({"suite":"s","shot":{"bytes":"Ā"},"verdict":"passed"})", "above U+00FF"}));

TEST(Results, ATimeThatNoRunTakesIsRefusedAndNeverPrintedInFull) {
    const Result<RunResult> run = parseRunLine(R"({"run":{"seconds":1e308}})", kPlace);
    ASSERT_FALSE(run);
    EXPECT_EQ(run.diagnostics.front().id, "result-E01");
    for (const double seconds : {1e308, 1e9, -1., std::nan("")})
        EXPECT_EQ(readableTime(seconds), "unknown time") << seconds;
    RunResult made;
    made.seconds = 1e308;
    made.shots.emplace_back().milliseconds = 1e308;
    made.shots.back().verdict = Verdict::failed;
    made.shots.back().judgement.decidedBy = image::Rung::flip;
    made.shots.back().judgement.flip = made.shots.back().judgement.structure = 1e308;
    for (const std::string& text : {toText(made, {}), toJunit(made)})
        EXPECT_EQ(text.find("00000000000000000000"), std::string::npos) << text;
}

TEST(Results, DamagedLinesNeverStopTheProgram) {
    ResultsMaker maker(3);
    std::mt19937 random(4);
    for (int i = 0; i < 3000; ++i) {
        std::string line = toJsonLine(maker.shot());
        for (int change = 0; change < 3; ++change) {
            const std::size_t at = random() % line.size();
            if (random() % 2 == 0)
                line[at] = static_cast<char>(random());
            else
                line.erase(at, random() % 9);
        }
        const Result<ShotResult> shot = parseJsonLine(line, kPlace);
        if (shot) continue;
        ASSERT_EQ(shot.diagnostics.size(), 1U);
        EXPECT_EQ(shot.diagnostics.front().place, kPlace);
    }
}

TEST(Results, DeepNestingIsRefusedAndNotRunInto) {
    const Result<ShotResult> shot = parseJsonLine(std::string(200000, '['), kPlace);
    EXPECT_FALSE(shot);
}

}  // namespace
}  // namespace glibra::suite
