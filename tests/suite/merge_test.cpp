#include "suite/results/merge.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "folder.h"
#include "pictures.h"
#include "suite/report/report_files.h"
#include "suite/report/terminal_report.h"
#include "suite/results/results_file.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

ShotResult shot(const std::string& name, Verdict verdict, const std::string& got = "") {
    ShotResult made;
    made.suite = "s";
    made.shot = name;
    made.verdict = verdict;
    made.got = got;
    return made;
}

/// A run that planned these shots, and is complete if it skips none.
RunResult run(const std::string& shard, std::vector<ShotResult> shots) {
    RunResult made;
    made.driver = "llvmpipe";
    made.shard = shard;
    made.plan = "the plan";
    made.shots = std::move(shots);
    made.planned.emplace();
    for (const ShotResult& each : made.shots) made.planned->push_back({each.suite, {each.shot}});
    made.complete = missingShots(made).empty();
    return made;
}

/// The same run as it is when it was killed after so many shots.
RunResult killed(RunResult run, std::size_t after) {
    run.shots.resize(after);
    run.complete = false;
    return run;
}

std::string ids(const Diagnostics& diagnostics) {
    std::string all;
    for (const Diagnostic& each : diagnostics) all += each.id + " ";
    return all;
}

std::string verdicts(const RunResult& result) {
    std::string all;
    for (const ShotResult& each : result.shots) all += each.shot + ":" + name(each.verdict) + " ";
    return all;
}

class Merge : public testing::Test {
  protected:
    fs::path add(const std::string& name, const RunResult& result) {
        EXPECT_TRUE(writeResults(result, folder / name).empty());
        folders.push_back(folder / name);
        return folders.back();
    }
    Result<RunResult> merged() { return mergeResults(folders, folder / "into"); }

    Folder folder;
    std::vector<fs::path> folders;
};

TEST_F(Merge, JoinsTheShardsWithTheirPictures) {
    writeText(folder / "1/pictures/a.png", png(1));
    writeText(folder / "2/pictures/b.png", png(2));
    add("2", run("2/2", {shot("b", Verdict::failed, "pictures/b.png")}));
    add("1", run("1/2", {shot("a", Verdict::passed, "pictures/a.png"), shot("c", Verdict::missing)}));
    const Result<RunResult> result = merged();
    ASSERT_TRUE(result);
    EXPECT_EQ(ids(result.diagnostics), "");
    EXPECT_EQ(verdicts(*result), "a:passed b:failed c:missing ");
    EXPECT_EQ(textOf(folder / "into" / result->shots[0].got), png(1));
    EXPECT_EQ(textOf(folder / "into" / result->shots[1].got), png(2));
    EXPECT_EQ(result->shard, "");
    EXPECT_EQ(result->driver, "llvmpipe");
    const Result<RunResult> written = readResults(folder / "into");
    ASSERT_TRUE(written);
    EXPECT_EQ(verdicts(*written), verdicts(*result));
}

TEST_F(Merge, GivesTheSameForAnyOrderOfTheFolders) {
    for (int i = 1; i <= 4; ++i)
        add(std::to_string(i),
            run(std::to_string(i) + "/4",
                {shot("a" + std::to_string(5 - i), Verdict::passed), shot("b", static_cast<Verdict>(i))}));
    std::ranges::sort(folders);
    std::string first;
    do {
        const Result<RunResult> result = merged();
        ASSERT_TRUE(result);
        if (first.empty()) first = verdicts(*result);
        EXPECT_EQ(verdicts(*result), first);
        EXPECT_EQ(first, "a1:passed a2:passed a3:passed a4:passed b:failed ");
    } while (std::next_permutation(folders.begin(), folders.end()));
}

TEST_F(Merge, ReportsMissingShards) {
    add("1", run("1/4", {shot("a", Verdict::passed)}));
    add("3", run("3/4", {shot("b", Verdict::passed)}));
    const Result<RunResult> result = merged();
    ASSERT_TRUE(result) << "what is there is joined";
    ASSERT_EQ(ids(result.diagnostics), "result-E03 ");
    EXPECT_NE(result.diagnostics[0].text.find("2/4, 4/4"), std::string::npos) << result.diagnostics[0].text;
    EXPECT_EQ(result->shots.size(), 2U);
    const std::string missing = "2 of 4 shards are missing: 2/4, 4/4";
    EXPECT_EQ(shortfall(*result), missing);
    EXPECT_NE(toText(*result, {.resultsFolder = folder / "into"}).find("incomplete: " + missing),
              std::string::npos);
    EXPECT_NE(toJunit(*result).find("<error message=\"" + missing), std::string::npos);
    EXPECT_TRUE(writeHtmlReport(*result, folder / "into", folder / "page", {}).empty());
    EXPECT_NE(textOf(folder / "page/index.html").find("<h1>None of 2 shots failed, " + missing + "</h1>"),
              std::string::npos);
    const Result<RunResult> read = readResults(folder / "into");
    ASSERT_TRUE(read);
    EXPECT_EQ(shortfall(*read), missing) << "results that are merged keep it";
    const Result<RunResult> again = mergeResults(std::vector<fs::path>{folder / "into"}, folder / "again");
    ASSERT_TRUE(again);
    EXPECT_EQ(shortfall(*again), missing) << "also when they are merged once more";
}

TEST_F(Merge, ReportsAHugeNumberOfMissingShardsInOneLine) {
    add("1", run("1/2000000000", {shot("a", Verdict::passed)}));
    const Result<RunResult> result = merged();
    ASSERT_EQ(ids(result.diagnostics), "result-E03 ");
    EXPECT_LT(result.diagnostics[0].text.size(), 1000U);
    EXPECT_NE(result.diagnostics[0].text.find("1999999999 of 2000000000"), std::string::npos);
}

TEST_F(Merge, RefusesToCallShardsOfDifferentCountsWhole) {
    add("1", run("1/2", {}));
    add("2", run("2/3", {}));
    EXPECT_EQ(ids(merged().diagnostics), "result-E04 ");
    folders.clear();
    add("1", run("1/1", {}));
    add("2", run("", {}));
    EXPECT_EQ(ids(merged().diagnostics), "result-E04 ");
}

TEST_F(Merge, OfTwoVerdictsTheFailureCountsAndTheDifferenceIsReported) {
    add("a", run("", {shot("x", Verdict::passed), shot("y", Verdict::crashed), shot("z", Verdict::failed)}));
    add("b", run("", {shot("x", Verdict::failed), shot("y", Verdict::passed), shot("z", Verdict::failed)}));
    const Result<RunResult> result = merged();
    ASSERT_TRUE(result);
    EXPECT_EQ(verdicts(*result), "x:failed y:crashed z:failed ");
    EXPECT_EQ(ids(result.diagnostics), "result-W01 result-W01 ");
    EXPECT_NE(result.diagnostics[0].text.find("'s/x' is passed in"), std::string::npos)
        << result.diagnostics[0].text;
}

TEST_F(Merge, SkippedLosesAgainstAnythingAndSilently) {
    add("a", run("", {shot("x", Verdict::skipped), shot("y", Verdict::passed), shot("z", Verdict::skipped)}));
    add("b", run("", {shot("x", Verdict::passed), shot("y", Verdict::skipped), shot("z", Verdict::skipped)}));
    const Result<RunResult> result = merged();
    ASSERT_TRUE(result);
    EXPECT_EQ(verdicts(*result), "x:passed y:passed z:skipped ");
    EXPECT_EQ(ids(result.diagnostics), "result-E03 result-E03 ") << "both runs were stopped";
}

TEST_F(Merge, AKilledRunIsAnErrorWithTheShotsThatAreMissing) {
    const RunResult whole =
        run("1/2", {shot("a", Verdict::passed), shot("b", Verdict::passed), shot("c", Verdict::passed)});
    for (std::size_t after = 0; after <= 3; ++after) {
        folders.clear();
        add("1", killed(whole, after));
        add("2", run("2/2", {shot("d", Verdict::passed)}));
        const Result<RunResult> result = merged();
        ASSERT_TRUE(result) << after;
        ASSERT_EQ(ids(result.diagnostics), "result-E03 ") << after;
        EXPECT_FALSE(result->complete);
        EXPECT_EQ(missingShots(*result).size(), 3 - after);
        const std::string& text = result.diagnostics[0].text;
        EXPECT_NE(text.find((folder / "1").string()), std::string::npos) << text;
        EXPECT_EQ(text.find("s/c") != std::string::npos, after < 3) << text;
        // The merged folder is no better than what it was made of.
        const std::vector<fs::path> again{folder / "into"};
        EXPECT_EQ(mergeResults(again, folder / "again").diagnostics.empty(), false) << after;
    }
}

TEST_F(Merge, AKilledRunIsCoveredByOneThatIsWhole) {
    const RunResult whole = run("", {shot("a", Verdict::passed), shot("b", Verdict::passed)});
    add("1", killed(whole, 1));
    add("2", whole);
    const Result<RunResult> result = merged();
    ASSERT_TRUE(result);
    EXPECT_EQ(ids(result.diagnostics), "");
    EXPECT_TRUE(result->complete);
    EXPECT_TRUE(readResults(folder / "into")->complete);
}

TEST_F(Merge, AFileWithoutAPlanIsAnError) {
    RunResult old = run("", {shot("a", Verdict::passed)});
    old.planned.reset();
    add("1", old);
    EXPECT_EQ(ids(merged().diagnostics), "result-E03 ");
    folders.clear();
    add("2", killed(run("", {shot("a", Verdict::passed)}), 0));
    EXPECT_EQ(ids(merged().diagnostics), "result-E03 ") << "only a header";
}

TEST_F(Merge, NoCutOfAResultsFileMergesWithoutAnError) {
    add("1", run("", {shot("a", Verdict::passed), shot("b", Verdict::passed)}));
    const std::string whole = textOf(folder / "1/results.jsonl");
    for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
        writeText(folder / "1/results.jsonl", whole.substr(0, length));
        EXPECT_TRUE(hasError(merged().diagnostics)) << length;
    }
}

TEST_F(Merge, KeepsBothOfTwoPicturesWithOneName) {
    writeText(folder / "1/p.png", png(1));
    writeText(folder / "2/p.png", png(2));
    writeText(folder / "3/p.png", png(1));
    add("1", run("1/3", {shot("a", Verdict::failed, "p.png")}));
    add("2", run("2/3", {shot("b", Verdict::failed, "p.png")}));
    add("3", run("3/3", {shot("c", Verdict::failed, "./p.png")}));
    const Result<RunResult> result = merged();
    ASSERT_TRUE(result);
    EXPECT_EQ(textOf(folder / "into" / result->shots[0].got), png(1));
    EXPECT_EQ(textOf(folder / "into" / result->shots[1].got), png(2));
    EXPECT_EQ(result->shots[2].got, result->shots[0].got);
}

TEST_F(Merge, LeavesPicturesOutsideOfTheFoldersWhereTheyAre) {
    writeText(folder / "goldens/g.png", png(3));
    RunResult result = run("", {shot("a", Verdict::failed, "../goldens/g.png")});
    result.shots[0].expected = folder / "goldens/g.png";
    add("1", result);
    const Result<RunResult> joined = merged();
    ASSERT_TRUE(joined);
    EXPECT_EQ(joined->shots[0].got, "../goldens/g.png");
    EXPECT_EQ(joined->shots[0].expected, folder / "goldens/g.png");
}

TEST_F(Merge, SaysWhichDriverDrewAShotWhereTheyDiffer) {
    add("1", run("1/2", {shot("a", Verdict::passed)}));
    RunResult other = run("2/2", {shot("b", Verdict::passed)});
    other.driver = "NVIDIA";
    add("2", other);
    const Result<RunResult> result = merged();
    ASSERT_TRUE(result);
    EXPECT_EQ(result->driver, "llvmpipe; NVIDIA");
    EXPECT_EQ(result->shots[0].driver, "llvmpipe");
    EXPECT_EQ(result->shots[1].driver, "NVIDIA");
}

TEST_F(Merge, AFolderThatCannotBeReadIsReportedAndTheOthersAreMerged) {
    add("1", run("1/2", {shot("a", Verdict::passed)}));
    folders.push_back(folder / "died");
    const Result<RunResult> result = merged();
    ASSERT_TRUE(result);
    EXPECT_EQ(ids(result.diagnostics), "file-E01 result-E03 ");
    EXPECT_FALSE(mergeResults(std::vector{folder / "died"}, folder / "into"));
    EXPECT_EQ(ids(mergeResults({}, folder / "into").diagnostics), "result-E05 ");
}

TEST_F(Merge, GoesIntoOneOfItsOwnFoldersToo) {
    writeText(folder / "1/p.png", png(1));
    writeText(folder / "2/q.png", png(2));
    add("1", run("1/2", {shot("a", Verdict::failed, "p.png")}));
    add("2", run("2/2", {shot("b", Verdict::failed, "q.png")}));
    const Result<RunResult> result = mergeResults(folders, folder / "1");
    ASSERT_TRUE(result);
    EXPECT_EQ(textOf(folder / "1/p.png"), png(1));
    EXPECT_EQ(textOf(folder / "1" / result->shots[0].got), png(1));
    EXPECT_EQ(textOf(folder / "1" / result->shots[1].got), png(2));
    EXPECT_EQ(readResults(folder / "1")->shots.size(), 2U);
}

TEST_F(Merge, AFileThatIsNoPictureIsLeftOutAndNamed) {
    writeText(folder / "1/.git/hooks/post-checkout", "#!/bin/sh\n");
    writeText(folder / "1/evil.sh", "#!/bin/sh\n");
    writeText(folder / "1/cut.png", png(1).substr(0, 60));
    add("1", run("", {shot("a", Verdict::failed, ".git/hooks/post-checkout"),
                      shot("b", Verdict::failed, "evil.sh"), shot("c", Verdict::failed, "cut.png")}));
    const Result<RunResult> result = merged();
    ASSERT_TRUE(result);
    EXPECT_EQ(ids(result.diagnostics), "result-W02 result-W02 result-W02 ");
    EXPECT_NE(result.diagnostics[1].text.find("'s/b': 'evil.sh' is not a picture"), std::string::npos)
        << result.diagnostics[1].text;
    for (const ShotResult& each : result->shots) EXPECT_TRUE(each.got.empty());
    for (const auto& each : fs::directory_iterator(folder / "into"))
        EXPECT_EQ(each.path().filename(), "results.jsonl");
}

TEST_F(Merge, APictureWithTheNameOfAScriptIsStoredUnderANameOfOurs) {
    writeText(folder / "1/run.sh", png(1));
    add("1", run("", {shot("a", Verdict::failed, "run.sh")}));
    const Result<RunResult> result = merged();
    ASSERT_TRUE(result);
    EXPECT_EQ(result->shots[0].got.parent_path(), "pictures");
    EXPECT_EQ(result->shots[0].got.extension(), ".png");
    EXPECT_EQ(textOf(folder / "into" / result->shots[0].got), png(1));
    EXPECT_FALSE(fs::exists(folder / "into/run.sh"));
}

TEST_F(Merge, WritesThroughNoLinkOfAFolderThatSomebodyElseMade) {
    writeText(folder / "1/p.png", png(1));
    writeText(folder / "mine/results", "mine");
    add("1", run("", {shot("a", Verdict::failed, "p.png")}));
    fs::create_directory_symlink(folder / "mine", folder / "1/pictures");
    EXPECT_EQ(ids(mergeResults(folders, folder / "1").diagnostics), "file-E10 ");
    fs::remove(folder / "1/pictures");
    fs::rename(folder / "1/results.jsonl", folder / "2.jsonl");
    fs::create_symlink(folder / "mine/results", folder / "1/results.jsonl");
    folders = {folder / "2.jsonl"};
    fs::create_directories(folder / "into");
    fs::create_symlink(folder / "mine/results", folder / "into/results.jsonl");
    EXPECT_TRUE(merged());
    EXPECT_EQ(textOf(folder / "mine/results"), "mine");
    EXPECT_FALSE(fs::is_symlink(folder / "into/results.jsonl"));
    folders = {folder / "1"};
    EXPECT_EQ(ids(merged().diagnostics), "file-E14 ") << "a results file that is a link";
}

TEST_F(Merge, IsRefusedWhileARunWritesIntoItsFolder) {
    add("1", run("", {shot("a", Verdict::passed)}));
    const Result<ResultsWriter> writer = ResultsWriter::open(folder / "into", run("", {}));
    ASSERT_TRUE(writer);
    EXPECT_EQ(ids(merged().diagnostics), "result-E02 ");
}

TEST_F(Merge, PartsOfDifferentPlansOrSettingsDoNotBelongTogether) {
    RunResult first = run("1/2", {shot("a", Verdict::passed)}),
              second = run("2/2", {shot("b", Verdict::passed)});
    for (const char* plan : {"another plan", ""}) {
        folders.clear();
        second.plan = plan;
        add("1", first);
        add("2", second);
        for (int order = 0; order < 2; ++order, std::reverse(folders.begin(), folders.end())) {
            const Result<RunResult> result = merged();
            ASSERT_TRUE(result);
            EXPECT_EQ(ids(result.diagnostics), "result-E06 ") << plan;
            EXPECT_FALSE(result->complete);
            EXPECT_NE(toJunit(*result).find("errors=\"1\""), std::string::npos) << toJunit(*result);
            EXPECT_EQ(result->plan, "") << "a later merge must not take it for the whole";
        }
    }
    first.plan = second.plan = "";
    folders.clear();
    add("1", first);
    add("2", second);
    EXPECT_EQ(ids(merged().diagnostics), "result-E06 result-E06 ");
    // Whole runs on two machines are of one plan, too.
    folders.clear();
    first.shard = second.shard = "";
    first.plan = "a";
    second.plan = "b";
    add("1", first);
    add("2", second);
    EXPECT_EQ(ids(merged().diagnostics), "result-E06 ");
}

TEST_F(Merge, WhatWasMergedCanBeMergedAgain) {
    add("1", run("1/2", {shot("a", Verdict::passed)}));
    add("2", run("2/2", {shot("b", Verdict::passed)}));
    const Result<RunResult> all = merged();
    ASSERT_TRUE(all && all->complete);
    EXPECT_EQ(all->plan, "the plan");
    folders = {folder / "into"};
    EXPECT_TRUE(mergeResults(folders, folder / "again")->complete);
}

}  // namespace
}  // namespace glibra::suite
