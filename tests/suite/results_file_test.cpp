#include "suite/results/results_file.h"

#include <gtest/gtest.h>

#include <string>

#include "folder.h"
#include "results_maker.h"
#include "small_run.h"

namespace glibra::suite {
namespace {

TEST(ResultsFile, ARunComesBackWhole) {
    const Folder folder;
    ResultsMaker maker(5);
    RunResult run = maker.run();
    for (int i = 0; i < 50; ++i) {
        run.shots.push_back(maker.shot());
        run.shots.back().shot += std::to_string(i);
    }
    ASSERT_TRUE(writeResults(run, folder / "new/results").empty());
    const Result<RunResult> back = readResults(folder / "new/results");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->command, run.command);
    EXPECT_EQ(back->planned, run.planned);
    EXPECT_FALSE(back->complete);
    run.complete = true;
    ASSERT_TRUE(writeResults(run, folder / "whole").empty());
    EXPECT_TRUE(readResults(folder / "whole")->complete);
    ASSERT_EQ(back->shots.size(), run.shots.size());
    for (std::size_t i = 0; i < run.shots.size(); ++i) expectEqual(back->shots[i], run.shots[i]);
    EXPECT_TRUE(readResults(folder / "new/results/results.jsonl")) << "the file itself names the results too";
}

TEST(ResultsFile, ATornLastLineIsLeftOutWithANote) {
    const Folder folder;
    ASSERT_TRUE(writeResults(smallRun(3), folder.path()).empty());
    const std::string whole = textOf(folder / "results.jsonl");
    const std::size_t lastLine = whole.rfind('\n', whole.size() - 2) + 1;
    for (std::size_t length = lastLine + 1; length < whole.size() - 1; length += 13) {
        writeText(folder / "results.jsonl", whole.substr(0, length));
        const Result<RunResult> back = readResults(folder.path());
        ASSERT_TRUE(back) << length;
        ASSERT_EQ(back->shots.size(), 2U) << length;
        ASSERT_EQ(back.diagnostics.size(), 1U);
        EXPECT_EQ(back.diagnostics.front().id, "result-N01");
        EXPECT_EQ(back.diagnostics.front().place.line, 4);
    }
}

TEST(ResultsFile, ABrokenLineInTheMiddleIsAnErrorWithItsPlace) {
    const Folder folder;
    ASSERT_TRUE(writeResults(smallRun(3), folder.path()).empty());
    std::string text = textOf(folder / "results.jsonl");
    text.replace(text.find("shot1") + 5, 1, "");
    writeText(folder / "results.jsonl", text);
    const Result<RunResult> back = readResults(folder.path());
    ASSERT_FALSE(back);
    EXPECT_EQ(back.diagnostics.front().place.file, (folder / "results.jsonl").string());
    EXPECT_EQ(back.diagnostics.front().place.line, 3);
}

/// Whoever accepts the result writes a file and a line of that name.
TEST(ResultsFile, AVariantIsAFamilyOrAFurtherPicture) {
    ShotResult shot = smallRun(1).shots[0];
    for (const char* variant : {"", "nvidia", "other", "d3d12", "osmesa-llvmpipe", "also1", "also9"}) {
        shot.goldenVariant = variant;
        EXPECT_TRUE(parseJsonLine(toJsonLine(shot), {})) << variant;
    }
    for (const char* variant : {"x/../b", "../b", "x/y", "x\nfoo", "a b", ".", "..", "also0", "also10",
                                "osmesa-", "nvidia.png", "\xff", "-"}) {
        shot.goldenVariant = variant;
        const Result<ShotResult> read = parseJsonLine(toJsonLine(shot), {"results.jsonl", 2, 1});
        ASSERT_FALSE(read) << variant;
        EXPECT_EQ(read.diagnostics.front().id, "result-E01");
        EXPECT_NE(read.diagnostics.front().text.find("'goldenVariant'"), std::string::npos);
    }
}

TEST(ResultsFile, AnEndLineThatDoesNotFitIsAnErrorWithItsPlace) {
    const Folder folder;
    RunResult run = smallRun(3);
    run.complete = true;
    ASSERT_TRUE(writeResults(run, folder.path()).empty());
    const std::string whole = textOf(folder / "results.jsonl");
    const auto expectBroken = [&](const std::string& text, int line, const char* message) {
        writeText(folder / "results.jsonl", text);
        const Result<RunResult> back = readResults(folder.path());
        ASSERT_FALSE(back) << text;
        EXPECT_EQ(back.diagnostics.front().id, "result-E01");
        EXPECT_EQ(back.diagnostics.front().place.line, line);
        EXPECT_NE(back.diagnostics.front().text.find(message), std::string::npos)
            << back.diagnostics.front().text;
    };
    expectBroken(whole + toJsonLine(run.shots[0]) + "\n", 6, "after the end line");
    std::string less = whole;
    const std::size_t second = less.find('\n') + 1;
    less.erase(second, less.find('\n', second) + 1 - second);
    expectBroken(less, 4, "the end line counts 3 shots, but the file has 2");
}

TEST(ResultsFile, AFolderWithoutResultsIsNamed) {
    const Folder folder;
    const Result<RunResult> back = readResults(folder / "none");
    ASSERT_FALSE(back);
    EXPECT_EQ(back.diagnostics.front().id, "file-E01");
    EXPECT_NE(back.diagnostics.front().text.find("none"), std::string::npos);
}

TEST(ResultsWriter, ContinuesAfterATornLine) {
    const Folder folder;
    const RunResult run = smallRun(3);
    ASSERT_TRUE(writeResults(run, folder.path()).empty());
    const std::string whole = textOf(folder / "results.jsonl");
    writeText(folder / "results.jsonl", whole.substr(0, whole.size() - 20));
    {
        Result<ResultsWriter> writer = ResultsWriter::open(folder.path(), run, ResultsWriter::Start::resumed);
        ASSERT_TRUE(writer);
        ASSERT_TRUE(writer->add(run.shots[2]).empty());
    }
    EXPECT_EQ(textOf(folder / "results.jsonl"), whole);
}

TEST(ResultsWriter, OfTwoLinesForOneShotTheLaterCounts) {
    const Folder folder;
    RunResult run = smallRun(3);
    {
        Result<ResultsWriter> writer = ResultsWriter::open(folder.path(), run);
        for (const ShotResult& shot : run.shots) ASSERT_TRUE(writer->add(shot).empty());
        run.shots[1].verdict = Verdict::failed;
        ASSERT_TRUE(writer->add(run.shots[1]).empty());
    }
    const Result<RunResult> back = readResults(folder.path());
    ASSERT_TRUE(back);
    ASSERT_EQ(back->shots.size(), 3U);
    EXPECT_EQ(back->shots[1].verdict, Verdict::failed);
}

TEST(ResultsWriter, AResumedRunIsNotCompleteAndHasItsOwnPlan) {
    const Folder folder;
    RunResult run = smallRun(2);
    run.planned = {{"s", {"shot0", "shot1"}}};
    run.complete = true;
    ASSERT_TRUE(writeResults(run, folder.path()).empty());
    run.planned = {{"s", {"shot0", "shot1", "shot2"}}};
    ASSERT_TRUE(ResultsWriter::open(folder.path(), run, ResultsWriter::Start::resumed));
    const Result<RunResult> back = readResults(folder.path());
    ASSERT_TRUE(back);
    EXPECT_FALSE(back->complete);
    EXPECT_EQ(back->shots.size(), 2U);
    EXPECT_EQ(shortfall(*back), "1 of 3 planned shots have no verdict: s/shot2");
}

TEST(ResultsWriter, DoesNotContinueBrokenResults) {
    const Folder folder;
    writeText(folder / "results.jsonl", "{\"run\":{}}\nnonsense\n");
    const Result<ResultsWriter> writer =
        ResultsWriter::open(folder.path(), smallRun(0), ResultsWriter::Start::resumed);
    ASSERT_FALSE(writer);
    EXPECT_EQ(writer.diagnostics.front().id, "result-E01");
    EXPECT_EQ(writer.diagnostics.front().place.line, 2);
}

TEST(ResultsWriter, BeginsAnewUnlessItResumes) {
    const Folder folder;
    ASSERT_TRUE(writeResults(smallRun(3), folder.path()).empty());
    ASSERT_TRUE(ResultsWriter::open(folder.path(), smallRun(0)));
    EXPECT_TRUE(readResults(folder.path())->shots.empty());
    const Folder empty;
    ASSERT_TRUE(ResultsWriter::open(empty.path(), smallRun(0), ResultsWriter::Start::resumed));
    EXPECT_EQ(readResults(empty.path())->shard, "2/8");
}

TEST(ResultsWriter, TwoRunsDoNotWriteIntoOneFolder) {
    const Folder folder;
    Result<ResultsWriter> first = ResultsWriter::open(folder.path(), smallRun(0));
    ASSERT_TRUE(first);
    const ResultsWriter moved = std::move(*first);
    const Result<ResultsWriter> second = ResultsWriter::open(folder.path(), smallRun(0));
    ASSERT_FALSE(second);
    EXPECT_EQ(second.diagnostics.front().id, "result-E02");
}

}  // namespace
}  // namespace glibra::suite
