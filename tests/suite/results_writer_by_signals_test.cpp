// What is left of results whose writer is killed or finds no room, by the calls of POSIX.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "folder.h"
#include "small_run.h"
#include "suite/results/results_file.h"

namespace glibra::suite {
namespace {

TEST(ResultsWriterBySignals, EveryAddedResultSurvivesAKill) {
    const Folder folder;
    const RunResult run = smallRun(5);
    const pid_t child = ::fork();
    if (child == 0) {
        Result<ResultsWriter> writer = ResultsWriter::open(folder.path(), run);
        for (const ShotResult& shot : run.shots) (void)writer->add(shot);
        ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    const Result<RunResult> back = readResults(folder.path());
    ASSERT_TRUE(back);
    EXPECT_EQ(back->shard, "2/8");
    ASSERT_EQ(back->shots.size(), 5U);
    EXPECT_EQ(back->shots[4].shot, "shot4");
}

TEST(ResultsWriterBySignals, AWorkerThatOutlivesTheRunDoesNotKeepTheFolder) {
    const Folder folder;
    pid_t child = 0;
    {
        const Result<ResultsWriter> writer = ResultsWriter::open(folder.path(), smallRun(0));
        child = ::fork();
        if (child == 0) {
            ::pause();
            ::_exit(0);
        }
    }
    EXPECT_TRUE(ResultsWriter::open(folder.path(), smallRun(0)));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
}

TEST(ResultsWriterBySignals, AFullDiskIsReportedAndLeavesWholeLines) {
    const Folder folder;
    const RunResult run = smallRun(50);
    const pid_t child = ::fork();
    if (child == 0) {
        // A limit of the file length simulates a full disk.
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{5000, 5000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        Result<ResultsWriter> writer = ResultsWriter::open(folder.path(), run);
        int told = 0;
        for (const ShotResult& shot : run.shots) {
            const Diagnostics problems = writer->add(shot);
            if (!problems.empty() && problems.front().id == "file-E10") ++told;
        }
        ::_exit(told > 0 ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    const Result<RunResult> back = readResults(folder.path());
    ASSERT_TRUE(back);
    EXPECT_TRUE(back.diagnostics.empty()) << "no torn line";
    EXPECT_GT(back->shots.size(), 2U);
    EXPECT_LT(back->shots.size(), 50U);
}

}  // namespace
}  // namespace glibra::suite
