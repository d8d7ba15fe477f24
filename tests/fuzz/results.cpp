// Any bytes as the results of up to four runs, which are read, merged, continued and reported. A line that
// begins with "=" begins the next run.

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "check.h"
#include "scratch_folder.h"
#include "suite/report/terminal_report.h"
#include "suite/results/merge.h"
#include "suite/results/results_file.h"
#include "text_mutator.h"

namespace {

namespace fs = std::filesystem;
using namespace glibra;
using fuzz::check;

/// A pixel as PNG would be copied; what merges do with other files is in the tests of suite.
constexpr std::string_view kPicture = "\x89PNG\r\n\x1a\n of one pixel";
constexpr std::size_t kMostRuns = 4;

suite::ShotResult fullShot() {
    suite::ShotResult shot;
    shot.suite = "start";
    shot.shot = "teapot@uTol=0.1";
    shot.verdict = suite::Verdict::failed;
    shot.reason = "12 pixels differ";
    shot.script = "glib/start/teapot.glib";
    shot.got = "got/a.png";
    shot.expected = "got/b.png";
    shot.difference = "c.png";
    shot.goldenVariant = "llvmpipe";
    shot.width = 800;
    shot.height = 600;
    shot.judgement.reason = "12 pixels differ";
    shot.diagnostics.push_back(diagnose("glib-W04", "text after the number '1x'", {"a.glib", 3, 5}));
    shot.milliseconds = 12.5;
    shot.reproduce = "glibra render a.glib";
    shot.accept = "cp a b";
    shot.driver = "llvmpipe";
    return shot;
}

suite::RunResult fullRun(std::string shard) {
    suite::RunResult run;
    run.driver = "llvmpipe";
    run.machine = "x86_64";
    run.shard = std::move(shard);
    run.command = "glibra test";
    run.seconds = 1;
    run.began = "2026-01-31T12:00:00Z";
    run.planned = {{"start", {"teapot@uTol=0.1", "table"}}};
    return run;
}

struct Folders {
    fuzz::ScratchFolder scratch;
    std::array<fs::path, kMostRuns> runs;
    fs::path into = scratch.path() / "into";
    Folders() {
        for (std::size_t i = 0; i < kMostRuns; ++i) {
            runs[i] = scratch.path() / ("run" + std::to_string(i));
            for (const char* picture : {"a.png", "got/a.png", "got/b.png", "c.png"})
                scratch.write(runs[i].filename() / picture, std::string(kPicture) + std::to_string(i % 2));
        }
    }
};

std::vector<fs::path> writeRuns(std::string_view text, const Folders& folders) {
    std::vector<std::string> runs(1);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        if (text.front() != '=')
            runs.back() += text.substr(0, end);
        else if (runs.size() < kMostRuns)
            runs.emplace_back();
        text.remove_prefix(end);
    }
    std::vector<fs::path> written;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        folders.scratch.write(folders.runs[i].filename() / "results.jsonl", runs[i]);
        written.push_back(folders.runs[i]);
    }
    return written;
}

/// Each line of a run is read as it was written.
void checkLines(const suite::RunResult& run) {
    const std::string header = suite::toJsonLine(run);
    check(header.find('\n') == header.npos, "the line of a run is one line");
    const auto again = suite::parseRunLine(header, {});
    check(again && suite::toJsonLine(*again) == header, "the line of a run is read as it was written");
    for (const suite::ShotResult& shot : run.shots) {
        const std::string line = suite::toJsonLine(shot);
        check(line.find('\n') == line.npos, "a result is one line");
        const auto same = suite::parseJsonLine(line, {});
        check(same && suite::toJsonLine(*same) == line, "a result is read as it was written");
    }
}

/// Without an error there is a verdict on everything that any run planned.
void checkMerge(const std::vector<fs::path>& runs, const fs::path& into) {
    std::error_code ignored;
    fs::remove_all(into, ignored);
    const Result<suite::RunResult> merged = suite::mergeResults(runs, into);
    fuzz::checkMessages(merged.diagnostics);
    if (!merged) return check(hasError(merged.diagnostics), "a merge without a value has an error");
    check(merged->complete == !hasError(merged.diagnostics), "a merge is complete if it has no error");
    std::set<suite::ShotKey> judged;
    for (const suite::ShotResult& shot : merged->shots)
        if (shot.verdict != suite::Verdict::skipped) judged.emplace(shot.suite, shot.shot);
    for (const fs::path& folder : runs) {
        const Result<suite::RunResult> run = suite::readResults(folder);
        if (!merged->complete) break;
        check(run && run->planned.has_value(), "a merge without an error has read all runs");
        for (const suite::PlannedShots& suite : *run->planned)
            for (const std::string& shot : suite.shots)
                check(judged.contains({suite.suite, shot}), "a merge without an error has all verdicts");
    }
    const Result<suite::RunResult> again = suite::readResults(into);
    check(again && again->complete == merged->complete && again->shots.size() == merged->shots.size(),
          "merged results are read as they were written");
    (void)suite::toText(*merged, {.color = false, .resultsFolder = into, .mapColumns = 8});
    (void)suite::toJunit(*merged);
}

/// What a run has is still there after it is continued.
void checkResumed(const fs::path& folder) {
    const Result<suite::RunResult> before = suite::readResults(folder);
    fuzz::checkMessages(before.diagnostics);
    if (!before) return;
    checkLines(*before);
    {
        Result<suite::ResultsWriter> writer =
            suite::ResultsWriter::open(folder, fullRun({}), suite::ResultsWriter::Start::resumed);
        if (!writer) return check(hasError(writer.diagnostics), "results are continued or there is an error");
        check(writer->add(fullShot()).empty(), "a result is added");
    }
    const Result<suite::RunResult> after = suite::readResults(folder);
    check(after && after->shots.size() >= before->shots.size() &&
              after->shots.size() <= before->shots.size() + 1,
          "a run that is continued keeps its results");
}

}  // namespace

const fuzz::Grammar& fuzz::grammar() {
    static const Grammar kGrammar = [] {
        Grammar made;
        const std::string shot = suite::toJsonLine(fullShot());
        made.statements = {shot, suite::endLine(0), suite::endLine(1), suite::endLine(2), "=", "="};
        for (const char* shard : {"", "1/2", "2/2", "2/3"})
            made.statements.push_back(suite::toJsonLine(fullRun(shard)));
        made.separators = " \t,:{}[]";
        for (std::size_t at = 0; at < shot.size();) {  // keys and values, as its own writer spells them
            const std::size_t end = std::min(shot.find_first_of(",:{}[]", at), shot.size());
            if (end > at) made.words.push_back(shot.substr(at, end - at));
            at = end + 1;
        }
        for (const suite::Verdict verdict : suite::kVerdictsByConcern)
            made.words.push_back('"' + std::string(suite::name(verdict)) + '"');
        for (const char* word :
             {"null", "true", "false", "{}", "[]", R"({"bytes":"\u00ff"})", R"("inf")", R"("nan")",
              R"("\u0000")", R"("\ud800")", R"("../a.png")", R"("/a.png")", R"("table")", R"("a.png")",
              "\"planned\"", "\"shots\"", "\"end\"", "\"run\""})
            made.words.emplace_back(word);
        return made;
    }();
    return kGrammar;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Folders kFolders;
    const std::vector<fs::path> runs = writeRuns(fuzz::textOf(data, size), kFolders);
    checkMerge(runs, kFolders.into);
    if (runs.size() > 1) checkMerge({runs.rbegin(), runs.rend()}, kFolders.into);
    checkResumed(runs.front());
    return 0;
}
