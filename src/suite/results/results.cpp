#include "suite/results/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "base/text.h"
#include "suite/golden/picture_store.h"

namespace glibra::suite {
namespace {

struct VerdictRow {
    const char* word;
    Verdict verdict;
    bool failure;
    const char* meaning;
};

constexpr VerdictRow kVerdicts[] = {
    {"passed", Verdict::passed, false, ""},
    {"failed", Verdict::failed, true, "the picture is not as expected"},
    {"missing", Verdict::missing, true, "there is no golden picture yet"},
    {"unstable", Verdict::unstable, true, "two renderings on this machine differ"},
    {"updated", Verdict::updated, false, "the golden picture was written"},
    {"refused", Verdict::refused, true,
     "the golden picture was kept: the new one is blank, of one colour or not finite"},
    {"crashed", Verdict::crashed, true, "the process that drew it ended"},
    {"timed-out", Verdict::timedOut, true, "it was not drawn in time"},
    {"flaky", Verdict::flaky, false, "one of its drawings was right, others were not"},
    {"quarantined", Verdict::quarantined, false, "it failed during its quarantine"},
    {"skipped", Verdict::skipped, false, "it was not run"},
};

const VerdictRow& rowOf(Verdict verdict) {
    const auto* row = std::ranges::find(kVerdicts, verdict, &VerdictRow::verdict);
    return row != std::end(kVerdicts) ? *row : kVerdicts[1];  // a verdict without a row counts as failed
}

}  // namespace

const char* name(Verdict verdict) {
    return rowOf(verdict).word;
}

const char* meaning(Verdict verdict) {
    return rowOf(verdict).meaning;
}

std::optional<Verdict> verdictOf(std::string_view word) {
    for (const VerdictRow& row : kVerdicts)
        if (row.word == word) return row.verdict;
    return std::nullopt;
}

bool isFailure(Verdict verdict) {
    return rowOf(verdict).failure;
}

bool wasNotDrawn(const ShotResult& shot) {
    return shot.verdict == Verdict::crashed || shot.verdict == Verdict::timedOut ||
           (shot.verdict == Verdict::failed && shot.width == 0);
}

bool isChangedPass(const ShotResult& shot) {
    return shot.verdict == Verdict::passed && shot.changed;
}

bool needsALook(const ShotResult& shot) {
    return isFailure(shot.verdict) || shot.verdict == Verdict::flaky ||
           shot.verdict == Verdict::quarantined || isChangedPass(shot);
}

void makeFlaky(ShotResult& shot, int drawing, const ShotResult& before) {
    shot.reason =
        fmt::format("drawing {} is right; before: {}, {}", drawing, name(before.verdict), before.reason);
    shot.verdict = Verdict::flaky;
    shot.accept.clear();
}

void countFlakyAsFailure(ShotResult& shot) {
    if (shot.verdict == Verdict::flaky) shot.verdict = Verdict::unstable;
}

std::vector<ShotKey> missingShots(const RunResult& run) {
    std::set<ShotKey> judged;
    for (const ShotResult& each : run.shots)
        if (each.verdict != Verdict::skipped) judged.emplace(each.suite, each.shot);
    std::vector<ShotKey> missing;
    if (run.planned)
        for (const PlannedShots& suite : *run.planned)
            for (const std::string& shot : suite.shots)
                if (!judged.contains({suite.suite, shot})) missing.emplace_back(suite.suite, shot);
    return missing;
}

std::string shortfall(const RunResult& run) {
    const std::string shots = shortfall(missingShots(run), plannedCount(run));
    return run.missingShards + (run.missingShards.empty() || shots.empty() ? "" : "; ") + shots;
}

std::string shortfall(const std::vector<ShotKey>& missing, std::size_t planned) {
    if (missing.empty()) return {};
    constexpr std::size_t kMostNames = 5;
    std::string names;
    for (std::size_t i = 0; i < std::min(missing.size(), kMostNames); ++i)
        names += fmt::format("{}{}/{}", i == 0 ? "" : ", ", missing[i].first, missing[i].second);
    return fmt::format("{} of {} planned shots have no verdict: {}{}", missing.size(), planned, names,
                       missing.size() > kMostNames ? ", ..." : "");
}

std::vector<std::string> orphanLines(const RunResult& run, std::size_t most) {
    std::map<std::string, std::vector<std::string>> bySuite;
    for (const OrphanGolden& each : run.orphans) bySuite[each.suite].push_back(each.file);
    std::vector<std::string> lines;
    for (const auto& [suite, files] : bySuite) {
        std::string line = fmt::format(
            "{} of no shot of '{}' (--prune removes them):", base::counted(files.size(), "golden"), suite);
        for (std::size_t i = 0; i < std::min(files.size(), most); ++i) line += " " + files[i];
        if (files.size() > most) line += fmt::format(" and {} more", files.size() - most);
        lines.push_back(std::move(line));
    }
    return lines;
}

std::string awaitedLine(const RunResult& run) {
    std::set<std::filesystem::path> goldens;
    for (const ShotResult& each : run.shots)
        if (!each.awaitsStore) goldens.insert(each.awaits.begin(), each.awaits.end());
    if (goldens.empty()) return {};
    return fmt::format("{} of Git LFS {} downloaded for a comparison; run `{}`, then continue with --resume",
                       base::counted(goldens.size(), "picture"),
                       goldens.size() == 1 ? "has to be" : "have to be",
                       pullCommand(std::vector(goldens.begin(), goldens.end())));
}

std::size_t plannedCount(const RunResult& run) {
    std::size_t count = 0;
    if (run.planned)
        for (const PlannedShots& each : *run.planned) count += each.shots.size();
    return count;
}

}  // namespace glibra::suite
