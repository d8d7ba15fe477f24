#include "suite/results/merge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "base/contained.h"
#include "base/text.h"
#include "image/format.h"
#include "image/png/png_reader.h"
#include "suite/golden/hash_list.h"
#include "suite/number_of.h"
#include "suite/results/results_file.h"
#include "suite/write_below.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRemarks = 20;

struct MergedRun {
    fs::path folder;
    RunResult results;
};

/// A shot and its run.
struct ShotSource {
    ShotResult* shot;
    const MergedRun* run;
};

std::optional<std::pair<int, int>> shardNumbers(const std::string& text) {
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto index = numberOf<int>(std::string_view(text).substr(0, slash));
    const auto count = numberOf<int>(std::string_view(text).substr(std::min(slash + 1, text.size())));
    if (!index || !count || *index < 1 || *index > *count) return std::nullopt;
    return std::pair(*index, *count);
}

/// result-E03 and result-E04: whether all shards of a run are there, and only those. `missing` names
/// the missing ones.
Diagnostics checkShards(const std::vector<MergedRun>& runs, std::string& missing) {
    std::map<int, std::set<int>> parts;  // by count
    bool undivided = false;
    for (const MergedRun& run : runs)
        if (const auto shard = shardNumbers(run.results.shard))
            parts[shard->second].insert(shard->first);
        else
            undivided = true;
    if (parts.empty()) return {};
    Diagnostics problems;
    if (parts.size() > 1 || undivided) {
        std::string list;
        for (const auto& [count, ignored] : parts)
            list += fmt::format("{}{}", list.empty() ? "" : ", ", count);
        problems.push_back(diagnose(
            "result-E04",
            fmt::format("these runs do not belong together: shards of {}{}; give the folders of one run",
                        list, undivided ? " and a whole run" : "")));
        return problems;
    }
    const auto& [count, present] = *parts.begin();
    std::string absent;
    int absentCount = 0;
    constexpr int kMostNames = 20;
    for (int part = 1; part <= count && absentCount <= kMostNames; ++part)
        if (!present.contains(part) && ++absentCount <= kMostNames)
            absent += fmt::format("{}{}/{}", absent.empty() ? "" : ", ", part, count);
    if (absentCount > kMostNames) absent += ", ...";
    if (absentCount == 0) return problems;
    const std::size_t missingCount = static_cast<std::size_t>(count) - present.size();
    missing = fmt::format("{} of {} shards {} missing: {}", missingCount, count,
                          missingCount == 1 ? "is" : "are", absent);
    problems.push_back(diagnose("result-E03", missing + "; their shots are not in this result"));
    return problems;
}

/// result-E06 unless all runs are of one plan with one set of settings.
Diagnostics checkSettings(std::span<const MergedRun> runs) {
    if (runs.size() < 2) return {};
    Diagnostics problems;
    for (const MergedRun& run : runs) {
        if (run.results.plan.empty())
            problems.push_back(diagnose(
                "result-E06", fmt::format("results in '{}': the file does not say what the whole run was to "
                                          "judge; run the suite again with this glibra",
                                          run.folder.generic_string())));
        else if (!runs.front().results.plan.empty() && run.results.plan != runs.front().results.plan)
            problems.push_back(diagnose(
                "result-E06",
                fmt::format(
                    "'{}' and '{}' are not parts of one run: their shots or settings differ; run both "
                    "with the same suites and options",
                    runs.front().folder.generic_string(), run.folder.generic_string())));
    }
    return problems;
}

/// result-E03 for every run with planned shots that have no verdict. A run that was killed falls short unless
/// runs that reached their end have verdicts on all of its shots.
Diagnostics checkPlans(const std::vector<MergedRun>& runs) {
    std::set<ShotKey> judged;
    for (const MergedRun& run : runs)
        for (const ShotResult& shot : run.results.shots)
            if (run.results.complete && shot.verdict != Verdict::skipped)
                judged.emplace(shot.suite, shot.shot);
    Diagnostics problems;
    const auto report = [&](const MergedRun& run, const std::string& why) {
        problems.push_back(
            diagnose("result-E03", fmt::format("results in '{}': {}", run.folder.generic_string(), why)));
    };
    for (const MergedRun& run : runs) {
        if (!run.results.planned) {
            report(run, "the file does not say which shots were planned; run the suite again");
            continue;
        }
        bool isCovered = true;
        for (const PlannedShots& suite : *run.results.planned)
            for (const std::string& shot : suite.shots) isCovered &= judged.contains({suite.suite, shot});
        if (isCovered) continue;
        const std::string why = shortfall(run.results);
        report(run, (why.empty() ? "the run did not reach its end" : why) + "; continue it with --resume");
    }
    return problems;
}

/// result-E03 if runs that are the whole run plan other shots than the plan says, or none: somebody has taken
/// some away.
Diagnostics checkCount(const RunResult& merged) {
    const std::size_t planned = plannedCount(merged);
    const auto count =
        numberOf<std::size_t>(std::string_view(merged.plan).substr(merged.plan.rfind('-') + 1));
    if (planned == 0) return {diagnose("result-E03", "these results planned no shot, so nothing was tested")};
    if (!count || *count == planned) return {};
    return {diagnose("result-E03", fmt::format("the run has {}, and the plans of these results name {}",
                                               base::counted(*count, "shot"), planned))};
}

/// All that the runs planned, each shot once.
std::vector<PlannedShots> joinedPlans(std::span<const MergedRun> runs) {
    std::map<std::string, std::set<std::string>> bySuite;
    std::map<std::string, std::string> files;
    for (const MergedRun& run : runs)
        if (run.results.planned)
            for (const PlannedShots& suite : *run.results.planned) {
                bySuite[suite.suite].insert(suite.shots.begin(), suite.shots.end());
                files.emplace(suite.suite, suite.file);
            }
    std::vector<PlannedShots> planned;
    for (const auto& [suite, shots] : bySuite)
        planned.push_back({suite, {shots.begin(), shots.end()}, files[suite]});
    return planned;
}

/// Of two verdicts the heavier counts.
std::ptrdiff_t weight(Verdict verdict) {
    if (verdict == Verdict::skipped) return -1;
    return std::end(kVerdictsByConcern) - std::ranges::find(kVerdictsByConcern, verdict);
}

/// Chooses one source per shot; the warnings name those on which runs differ.
Diagnostics choose(std::vector<MergedRun>& runs, std::map<ShotKey, ShotSource>& chosen) {
    Diagnostics remarks;
    for (MergedRun& run : runs)
        for (ShotResult& shot : run.results.shots) {
            const auto [at, isNew] = chosen.try_emplace({shot.suite, shot.shot}, ShotSource{&shot, &run});
            if (isNew) continue;
            ShotSource& old = at->second;
            const Verdict before = old.shot->verdict;
            const bool takes = weight(shot.verdict) > weight(before);
            if (before != shot.verdict && before != Verdict::skipped && shot.verdict != Verdict::skipped)
                remarks.push_back(diagnose(
                    "result-W01",
                    fmt::format("'{}/{}' is {} in '{}' and {} in '{}'; it counts as {}", shot.suite,
                                shot.shot, name(before), old.run->folder.generic_string(), name(shot.verdict),
                                run.folder.generic_string(), name(takes ? shot.verdict : before))));
            if (takes) old = {&shot, &run};
        }
    return remarks;
}

/// Copies the pictures of shots into one folder. A copy is named after its content, so that no name in a
/// results file decides what is written.
class PictureCopier {
  public:
    explicit PictureCopier(const fs::path& into) : into_(into) {}

    /// Replaces the path by that of the copy. A path that leads out of the folder of the run, or to nothing
    /// in it, stays as it is; what is not a picture loses its path, and the remark says why. Error: file-E10.
    Diagnostics copy(fs::path& picture, const MergedRun& run) {
        if (picture.empty()) return {};
        const system::File file = base::openBeneath(run.folder, picture.lexically_normal());
        if (!file && (errno == EINVAL || errno == ENOENT || errno == ENOTDIR)) return {};
        if (!file) return drop(picture, cannotShow(picture, errno).text);
        std::vector<std::byte> bytes;
        if (const int problem = base::readAll(file, kLargestShownPicture, bytes); problem != 0)
            return drop(picture, cannotShow(picture, problem).text);
        const char* ending = endingOf(bytes);
        if (ending == nullptr)
            return drop(picture, fmt::format("'{}' is not a picture", picture.generic_string()));
        const fs::path name = fs::path("pictures") / (toText(hashOf(bytes)) + ending);
        if (written_.insert(name).second)
            if (const int problem = base::writeBeneath(into_, name, bytes); problem != 0)
                return {cannotWrite(into_ / name, problem)};
        picture = name;
        return {};
    }

  private:
    /// The ending for a picture of the kinds that runs write, by its first bytes; null if it is another file.
    static const char* endingOf(std::span<const std::byte> bytes) {
        if (image::formatOf(bytes) == image::Format::png && image::shownOtherwise(bytes).empty())
            return ".png";
        return image::formatOf(bytes) == image::Format::openExr ? ".exr" : nullptr;
    }

    static Diagnostics drop(fs::path& picture, const std::string& why) {
        picture.clear();
        return {diagnose("result-W02", why)};
    }

    const fs::path& into_;
    std::set<fs::path> written_;
};

/// Page and JUnit file of a merge that is not whole say so, too.
std::string firstErrorOf(const Diagnostics& remarks) {
    const auto first = std::ranges::find(remarks, Severity::error, &Diagnostic::severity);
    return first == remarks.end() ? "" : first->text;
}

/// The values of a member in all runs, each once.
std::string joined(std::span<const MergedRun> runs, std::string RunResult::* member,
                   std::string_view between) {
    std::vector<std::string_view> values;
    for (const MergedRun& run : runs) {
        const std::string& value = run.results.*member;
        if (!value.empty() && std::ranges::find(values, value) == values.end()) values.push_back(value);
    }
    return fmt::format("{}", fmt::join(values, between));
}

RunResult header(std::span<const MergedRun> runs) {
    RunResult merged;
    merged.driver = joined(runs, &RunResult::driver, "; ");
    merged.machine = joined(runs, &RunResult::machine, "; ");
    merged.command = joined(runs, &RunResult::command, "\n");
    // Parts that do not belong together have no plan, so that no later merge takes the result for one.
    if (checkSettings(runs).empty()) merged.plan = runs.front().results.plan;
    std::set<OrphanGolden> orphans;
    for (const MergedRun& run : runs) {
        orphans.insert(run.results.orphans.begin(), run.results.orphans.end());
        merged.seconds = std::max(merged.seconds, run.results.seconds);
        const std::string& began = run.results.began;
        if (!began.empty() && (merged.began.empty() || began < merged.began)) merged.began = began;
    }
    merged.orphans.assign(orphans.begin(), orphans.end());
    merged.planned = joinedPlans(runs);
    return merged;
}

}  // namespace

Result<RunResult> mergeResults(std::span<const fs::path> folders, const fs::path& into) {
    if (folders.empty()) return diagnose("result-E05", "no folder of results is given");
    const Result<ResultsLock> lock = lockResults(into);
    if (!lock) return lock.diagnostics;
    Diagnostics remarks;
    std::vector<MergedRun> runs;
    for (const fs::path& folder : folders) {
        Result<RunResult> results = readResults(folder);
        append(remarks, std::move(results.diagnostics));
        if (!results) continue;
        std::error_code ignored;
        runs.push_back(
            {fs::is_directory(folder, ignored) ? folder : folder.parent_path(), std::move(*results)});
    }
    if (runs.empty()) return remarks;

    std::string missing;
    append(remarks, checkShards(runs, missing));
    append(remarks, checkSettings(runs));
    append(remarks, checkPlans(runs));
    RunResult merged = header(runs);
    if (!hasError(remarks)) append(remarks, checkCount(merged));
    const bool isWhole = !hasError(remarks);
    std::map<ShotKey, ShotSource> chosen;
    append(remarks, choose(runs, chosen));
    // Results that were merged before lack what they lacked then.
    merged.missingShards =
        missing.empty() ? joined(runs, &RunResult::missingShards, "; ") : std::move(missing);
    merged.complete = isWhole;
    PictureCopier copier(into);
    std::size_t dropped = 0;
    for (const auto& [key, source] : chosen) {
        ShotResult shot = std::move(*source.shot);
        if (shot.driver.empty() && source.run->results.driver != merged.driver)
            shot.driver = source.run->results.driver;
        for (fs::path* picture : {&shot.got, &shot.expected, &shot.difference}) {
            Diagnostics problems = copier.copy(*picture, *source.run);
            if (hasError(problems)) return problems;
            for (Diagnostic& each : problems) {
                each.text = fmt::format("report of '{}/{}': {}", shot.suite, shot.shot, each.text);
                if (++dropped <= kMostRemarks) remarks.push_back(std::move(each));
            }
        }
        merged.shots.push_back(std::move(shot));
    }
    if (!isWhole && shortfall(merged).empty()) merged.missingShards = firstErrorOf(remarks);
    if (Diagnostics problems = writeResults(merged, into); !problems.empty()) return problems;
    return {std::move(merged), std::move(remarks)};
}

}  // namespace glibra::suite
