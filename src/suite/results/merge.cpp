#include "suite/results/merge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "image/file.h"
#include "suite/results/results_file.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

struct Run {
    fs::path folder;
    RunResult results;
};

/// A shot and its run.
struct Source {
    ShotResult* shot;
    const Run* run;
};

std::optional<std::pair<int, int>> shardOf(const std::string& text) {
    std::pair<int, int> shard;
    const char* const end = text.data() + text.size();
    const auto [slash, problem] = std::from_chars(text.data(), end, shard.first);
    if (problem != std::errc{} || slash == end || *slash != '/') return std::nullopt;
    const auto [last, problemToo] = std::from_chars(slash + 1, end, shard.second);
    if (problemToo != std::errc{} || last != end || shard.first < 1 || shard.first > shard.second)
        return std::nullopt;
    return shard;
}

/// result-E03 and result-E04: whether all shards of a run are there, and only those.
Diagnostics checkShards(const std::vector<Run>& runs) {
    std::map<int, std::set<int>> parts;  // by count
    bool undivided = false;
    for (const Run& run : runs)
        if (const auto shard = shardOf(run.results.shard))
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
    if (absentCount > 0)
        problems.push_back(diagnose(
            "result-E03", fmt::format("{} of {} shards are missing: {}; their shots are not in this result",
                                      static_cast<std::size_t>(count) - present.size(), count, absent)));
    return problems;
}

/// result-E03 for every run with planned shots that have no verdict. A run that was killed falls short unless
/// runs that reached their end have verdicts on all of its shots.
Diagnostics checkPlans(const std::vector<Run>& runs) {
    std::set<ShotKey> judged;
    for (const Run& run : runs)
        for (const ShotResult& shot : run.results.shots)
            if (run.results.complete && shot.verdict != Verdict::skipped)
                judged.emplace(shot.suite, shot.shot);
    Diagnostics problems;
    const auto report = [&](const Run& run, const std::string& why) {
        problems.push_back(
            diagnose("result-E03", fmt::format("results in '{}': {}", run.folder.string(), why)));
    };
    for (const Run& run : runs) {
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

/// All that the runs planned, each shot once.
std::vector<PlannedShots> joinedPlans(std::span<const Run> runs) {
    std::map<std::string, std::set<std::string>> bySuite;
    for (const Run& run : runs)
        if (run.results.planned)
            for (const PlannedShots& suite : *run.results.planned)
                bySuite[suite.suite].insert(suite.shots.begin(), suite.shots.end());
    std::vector<PlannedShots> planned;
    for (const auto& [suite, shots] : bySuite) planned.push_back({suite, {shots.begin(), shots.end()}});
    return planned;
}

/// Of two verdicts the heavier counts.
std::ptrdiff_t weight(Verdict verdict) {
    if (verdict == Verdict::skipped) return -1;
    return std::end(kVerdictsByConcern) -
           std::find(std::begin(kVerdictsByConcern), std::end(kVerdictsByConcern), verdict);
}

/// Chooses one source per shot; the warnings name those on which runs differ.
Diagnostics choose(std::vector<Run>& runs, std::map<ShotKey, Source>& chosen) {
    Diagnostics remarks;
    for (Run& run : runs)
        for (ShotResult& shot : run.results.shots) {
            const auto [at, isNew] = chosen.try_emplace({shot.suite, shot.shot}, Source{&shot, &run});
            if (isNew) continue;
            Source& old = at->second;
            const Verdict before = old.shot->verdict;
            const bool takes = weight(shot.verdict) > weight(before);
            if (before != shot.verdict && before != Verdict::skipped && shot.verdict != Verdict::skipped)
                remarks.push_back(diagnose(
                    "result-W01",
                    fmt::format("'{}/{}' is {} in '{}' and {} in '{}'; it counts as {}", shot.suite,
                                shot.shot, name(before), old.run->folder.string(), name(shot.verdict),
                                run.folder.string(), name(takes ? shot.verdict : before))));
            if (takes) old = {&shot, &run};
        }
    return remarks;
}

/// Copies the pictures of shots into one folder, each once.
class PictureCopier {
  public:
    PictureCopier(const fs::path& into, std::span<const Run> runs) : into_(into), runs_(runs) {}

    /// Returns the path relative to the new folder. Pictures outside the folder of the run keep their path.
    Result<fs::path> copy(const fs::path& picture, const Run& run) {
        const fs::path relative = picture.lexically_normal();
        std::error_code failed;
        const fs::path from = run.folder / relative;
        if (picture.empty() || relative.is_absolute() || *relative.begin() == ".." ||
            !fs::is_regular_file(from, failed))
            return picture;
        fs::path name = relative;
        auto [taken, isNew] = sources_.try_emplace(name, from);
        if (!isNew && taken->second == from) return name;
        if (!isNew && haveSameContent(taken->second, from)) return name;
        if (!isNew) {  // another picture of the same name
            name = fs::path(fmt::format("run{}", &run - runs_.data() + 1)) / relative;
            sources_[name] = from;
        }
        const fs::path to = into_ / name;
        if (fs::equivalent(from, to, failed)) return name;
        fs::create_directories(to.parent_path(), failed);
        const Result<std::vector<std::byte>> bytes = image::readFile(from, {from.string(), {}});
        if (!bytes) return bytes.diagnostics;
        if (Diagnostics problems = image::writeFileAtomically(to, *bytes); !problems.empty()) return problems;
        return name;
    }

  private:
    static bool haveSameContent(const fs::path& a, const fs::path& b) {
        std::error_code failed;
        if (fs::file_size(a, failed) != fs::file_size(b, failed)) return false;
        const auto first = image::readFile(a, {a.string(), {}}),
                   second = image::readFile(b, {b.string(), {}});
        return first && second && *first == *second;
    }

    const fs::path& into_;
    std::span<const Run> runs_;
    std::map<fs::path, fs::path> sources_;  ///< key: the name in the new folder
};

/// The values of a member in all runs, each once.
std::string joined(std::span<const Run> runs, std::string RunResult::*member, std::string_view between) {
    std::vector<std::string_view> values;
    for (const Run& run : runs) {
        const std::string& value = run.results.*member;
        if (!value.empty() && std::find(values.begin(), values.end(), value) == values.end())
            values.push_back(value);
    }
    return fmt::format("{}", fmt::join(values, between));
}

RunResult header(std::span<const Run> runs) {
    RunResult merged;
    merged.driver = joined(runs, &RunResult::driver, "; ");
    merged.machine = joined(runs, &RunResult::machine, "; ");
    merged.command = joined(runs, &RunResult::command, "\n");
    for (const Run& run : runs) {
        merged.seconds = std::max(merged.seconds, run.results.seconds);
        const std::string& began = run.results.began;
        if (!began.empty() && (merged.began.empty() || began < merged.began)) merged.began = began;
    }
    return merged;
}

}  // namespace

Result<RunResult> mergeResults(std::span<const fs::path> folders, const fs::path& into) {
    if (folders.empty()) return diagnose("result-E05", "no folder of results is given");
    Diagnostics remarks;
    std::vector<Run> runs;
    for (const fs::path& folder : folders) {
        Result<RunResult> results = readResults(folder);
        append(remarks, std::move(results.diagnostics));
        if (!results) continue;
        std::error_code ignored;
        runs.push_back(
            {fs::is_directory(folder, ignored) ? folder : folder.parent_path(), std::move(*results)});
    }
    if (runs.empty()) return remarks;

    append(remarks, checkShards(runs));
    append(remarks, checkPlans(runs));
    const bool isWhole = !hasError(remarks);
    std::map<ShotKey, Source> chosen;
    append(remarks, choose(runs, chosen));
    RunResult merged = header(runs);
    merged.planned = joinedPlans(runs);
    merged.complete = isWhole;
    PictureCopier copier(into, runs);
    for (const auto& [key, source] : chosen) {
        ShotResult shot = std::move(*source.shot);
        if (shot.driver.empty() && source.run->results.driver != merged.driver)
            shot.driver = source.run->results.driver;
        for (fs::path* picture : {&shot.got, &shot.expected, &shot.difference}) {
            Result<fs::path> copied = copier.copy(*picture, *source.run);
            if (!copied) return copied.diagnostics;
            *picture = std::move(*copied);
        }
        merged.shots.push_back(std::move(shot));
    }
    if (Diagnostics problems = writeResults(merged, into); !problems.empty()) return problems;
    return {std::move(merged), std::move(remarks)};
}

}  // namespace glibra::suite
