#include "suite/results/results.h"

#include <gtest/gtest.h>

#include <bit>
#include <nlohmann/json.hpp>

#include "results_maker.h"

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
        EXPECT_EQ(isFailure(verdict),
                  verdict != Verdict::passed && verdict != Verdict::updated && verdict != Verdict::skipped)
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
    int column;
    const char* says;
};

class BrokenResults : public testing::TestWithParam<BrokenLine> {};

TEST_P(BrokenResults, AreToldWithFileLineAndColumn) {
    const Result<ShotResult> shot = parseJsonLine(GetParam().line, kPlace);
    ASSERT_FALSE(shot);
    ASSERT_EQ(shot.diagnostics.size(), 1U);
    const Diagnostic& told = shot.diagnostics.front();
    EXPECT_EQ(told.id, "result-E01");
    EXPECT_EQ(told.place.file, "results.jsonl");
    EXPECT_EQ(told.place.line, 7);
    EXPECT_EQ(told.place.column, GetParam().column) << told.text;
    EXPECT_NE(told.text.find(GetParam().says), std::string::npos) << told.text;
}

INSTANTIATE_TEST_SUITE_P(
    Lines, BrokenResults,
    testing::Values(
        BrokenLine{"", 1, "empty"}, BrokenLine{R"({"width":1e999})", 1, "beyond all limits"},
        BrokenLine{"[]", 1, "an object is expected"}, BrokenLine{R"({"suite":"s",})", 14, "no JSON"},
        BrokenLine{R"({"suite":"s")", 13, "no JSON"},
        BrokenLine{R"({"suite":"s","shot":"a"})", 1, "'verdict' is missing"},
        BrokenLine{R"({"suite":1,"shot":"a","verdict":"passed"})", 2, "'suite': a string is expected"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"good"})", 25, "no verdict is called 'good'"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","width":1e99})", 44,
                   "'width': a whole number"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","width":4294967296})", 44, "whole number"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","judgement":{"comparison":{"x":"1"}}})", 71,
                   "'x': a whole number"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","judgement":{"decidedBy":"luck"}})", 57,
                   "no rung of the comparison is called 'luck'"},
        BrokenLine{R"({"suite":"s","shot":"a","verdict":"passed","diagnostics":[{"severity":"sad"}]})", 60,
                   "no severity"},
        BrokenLine{R"({"suite":"s","shot":{"bytes":"Ā"},"verdict":"passed"})", 14, "no byte"}));

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
        EXPECT_GE(shot.diagnostics.front().place.column, 1);
        EXPECT_LE(shot.diagnostics.front().place.column, static_cast<int>(line.size()) + 1);
    }
}

TEST(Results, DeepNestingIsRefusedAndNotRunInto) {
    const Result<ShotResult> shot = parseJsonLine(std::string(200000, '['), kPlace);
    EXPECT_FALSE(shot);
}

}  // namespace
}  // namespace glibra::suite
