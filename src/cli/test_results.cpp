#include "cli/test_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <system_error>
#include <thread>

#include "base/contained.h"
#include "base/files.h"
#include "base/text.h"
#include "cli/commands.h"
#include "image/file.h"
#include "scene/file_lookup.h"
#include "suite/file/shot_name.h"
#include "suite/golden/golden_store.h"
#include "suite/golden/picture_store.h"
#include "suite/report/report_files.h"
#include "suite/report/terminal_report.h"
#include "suite/run/fingerprint.h"
#include "suite/run/verdict.h"
#include "system/folder.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

/// True if the file is there and has that text in its first kilobytes.
bool hasMark(const fs::path& file, std::string_view mark) {
    constexpr std::uint64_t kLargest = 1ULL << 30;
    constexpr std::size_t kSearched = 4096;
    std::error_code failure;
    if (!fs::is_regular_file(file, failure)) return false;
    const auto bytes = image::readFile(file, {file.generic_string(), {}}, kLargest);
    if (!bytes) return false;
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    return text.substr(0, kSearched).find(mark) != std::string_view::npos;
}

/// Cuts off the line that says that the run is complete. That takes no room on a disk that may be full.
void markResults(const fs::path& folder) {
    const fs::path file = suite::resultsFile(folder);
    std::error_code failure;
    if (!fs::is_regular_file(fs::symlink_status(file, failure))) return;
    const Result<suite::ResultsLock> lock = suite::lockResults(folder);
    if (!lock) return;
    const Result<suite::RunResult> earlier = suite::readResults(folder);
    if (!earlier || !earlier->complete) return;
    const std::size_t cut = suite::endLine(earlier->shots.size()).size() + 1;
    const std::uintmax_t size = fs::file_size(file, failure);
    if (!failure && size > cut) fs::resize_file(file, size - cut, failure);
    if (failure)
        print({diagnose("file-E10",
                        fmt::format("cannot write '{}': {}", file.generic_string(), failure.message()))});
}

/// Prints why a file could not be written, and removes the old one then.
void orRemove(const Diagnostics& problems, const fs::path& old) {
    std::error_code failure;
    if (printErrors(problems)) fs::remove(old, failure);
}

Diagnostics writeText(const std::string& file, const std::string& text) {
    std::error_code ignored;  // reported with the file that cannot be written
    if (const fs::path folder = fs::path(file).parent_path(); !folder.empty())
        fs::create_directories(folder, ignored);
    return image::writeFileAtomically(file, std::as_bytes(std::span(text)));
}

/// True for names that only a run gives to its pictures: "SHOT.got.png".
bool isOfRun(const fs::path& file) {
    const std::string what = file.stem().extension().generic_string(),
                      ending = file.extension().generic_string();
    return (ending == ".png" || ending == ".exr") &&
           (what == ".got" || what == ".expected" || what == ".difference" || what == ".again" ||
            what == ".partner");
}

/// Removes the pictures that an earlier run wrote into its own folder. Its results may come from somebody
/// else, so nothing else that they name is removed.
void removePictures(const suite::RunResult& earlier, const fs::path& folder) {
    for (const suite::ShotResult& shot : earlier.shots)
        for (const fs::path* each : {&shot.got, &shot.expected, &shot.difference}) {
            const fs::path relative = each->lexically_normal();
            if (relative.empty() || *relative.begin() != shot.suite || !isOfRun(relative)) continue;
            base::removeBeneath(folder, relative);  // a picture that stays does no harm
        }
}

bool isOfUpdate(suite::Verdict verdict) {
    return verdict == suite::Verdict::updated || verdict == suite::Verdict::refused;
}

bool isLocked(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& each) { return each.id == "result-E02"; });
}

}  // namespace

void markUnfinished(const ResultFiles& files) {
    if (!files.results.empty()) markResults(files.results);
    suite::RunResult unfinished;
    unfinished.missingShards = "this run has not reached its end";
    if (!files.junit.empty() && hasMark(files.junit, "<testsuites name=\"glibra\"")) {
        const std::string xml = suite::toJunit(unfinished);
        orRemove(image::writeFileAtomically(files.junit, std::as_bytes(std::span(xml))), files.junit);
    }
    if (!files.report.empty() && hasMark(files.report / "index.html", "- glibra</title>"))
        orRemove(suite::writeHtmlReport(unfinished, files.results, files.report),
                 files.report / "index.html");
}

bool writeReports(const suite::RunResult& run, const ReportRequest& request, const fs::path& results,
                  const suite::ReportRoots& roots) {
    Diagnostics problems;
    if (!request.report.empty()) {
        append(problems, suite::writeHtmlReport(run, results, request.report, roots));
        if (!hasError(problems))
            printLine("report: " + (fs::path(request.report) / "index.html").generic_string());
    }
    if (!request.junit.empty()) append(problems, writeText(request.junit, suite::toJunit(run)));
    if (!request.summary.empty())
        append(problems,
               writeText(request.summary,
                         suite::toMarkdown(run, {.results = results, .picturesAt = request.picturesAt})));
    return !printErrors(problems);
}

std::optional<RunRecord> RunRecord::open(const fs::path& folder, const suite::RunResult& run, bool resume,
                                         bool update, const std::function<bool()>& stop) {
    using Start = suite::ResultsWriter::Start;
    for (bool reported = false;; reported = true) {
        const Result<suite::RunResult> earlier = suite::readResults(folder);
        Result<suite::ResultsWriter> writer =
            suite::ResultsWriter::open(folder, run, resume ? Start::resumed : Start::anew);
        if (!writer && isLocked(writer.diagnostics) && !stop()) {
            if (!reported)
                printLine("another run is writing to '" + folder.generic_string() +
                          "'; waiting for it (or choose another folder with --results)");
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            continue;
        }
        print(writer.diagnostics);
        if (!writer) return std::nullopt;
        RunRecord record(folder, std::move(*writer));
        if (!earlier) return record;
        if (!resume) {
            removePictures(*earlier, folder);
            return record;
        }
        for (const suite::ShotResult& each : earlier->shots)
            if (each.verdict != suite::Verdict::skipped && (update || !isOfUpdate(each.verdict)))
                record.results_.emplace(Key(each.suite, each.shot), each);
        return record;
    }
}

bool RunRecord::isDone(const suite::Suite& suite, const suite::ShotReference& shot, const Basis& basis) {
    const auto found = results_.find({suite.name, suite.shots[shot.shot].name});
    if (found == results_.end()) return false;
    // Pictures that were lacking may be there now.
    if (found->second.awaits.empty() && !basis.fingerprint.empty() &&
        found->second.fingerprint == suite::sealed(basis.fingerprint, found->second.verdict) &&
        !basis.driverKey.empty() && found->second.driverKey == basis.driverKey)
        return true;
    results_.erase(found);
    ++droppedCount_;
    return false;
}

void RunRecord::add(const suite::ShotResult& shot) {
    if (!failed_) {
        failed_ = printErrors(writer_.add(shot));
    }
    results_.insert_or_assign({shot.suite, shot.shot}, shot);
}

void RunRecord::collect(suite::RunResult& run, std::span<const suite::Suite> suites,
                        std::span<const suite::ShotReference> shots) const {
    run.shots.reserve(shots.size());
    for (const suite::ShotReference& each : shots) {
        const suite::Suite& suite = suites[each.suite];
        const suite::Shot& shot = suite.shots[each.shot];
        const auto found = results_.find({suite.name, shot.name});
        run.shots.push_back(found != results_.end()
                                ? found->second
                                : suite::ShotJudge::broken(suite, shot, suite::Verdict::skipped,
                                                           "the run was stopped before this shot"));
    }
}

void RunRecord::finish(suite::RunResult& run) {
    if (failed_) return;
    run.complete = suite::missingShots(run).empty();
    failed_ = printErrors(suite::writeResults(run, folder_));
}

bool mayBeForged(const fs::path& results, std::span<const suite::Suite> suites) {
    return std::any_of(suites.begin(), suites.end(), [&](const suite::Suite& each) {
        std::error_code failure;
        return system::isBelow(
            results, fs::is_directory(each.file, failure) ? each.file : fs::path(each.file).parent_path());
    });
}

bool lacksGolden(const suite::Suite& suite, std::size_t shot, const fs::path& goldens) {
    const suite::Shot& asked = suite.shots[shot];
    return asked.golden && !asked.expectedError &&
           !suite::hasGolden(suite::goldenFolder(suite, goldens), asked);
}

suite::ReportRoots shownRoots(std::span<const suite::Suite> suites,
                              std::span<const suite::ShotReference> shots, const fs::path& goldens) {
    suite::ReportRoots roots;
    std::error_code ignored;
    for (const suite::Suite& suite : suites) {
        const fs::path folder = fs::is_directory(suite.file, ignored) ? suite.file : suite.file.parent_path();
        roots.texts.add(folder);
        roots.pictures.add(folder);
        roots.pictures.add(goldens.empty() ? suite.goldens : goldens / suite.name);
    }
    std::set<std::pair<fs::path, std::vector<fs::path>>> seen;
    for (const suite::ShotReference& each : shots) {
        const suite::Shot& shot = suites[each.suite].shots[each.shot];
        if (!seen.emplace(shot.script.parent_path(), shot.options.libraryRoots).second) continue;
        const scene::SearchFolders folders =
            scene::searchFolders(shot.script, {.libraryRoots = shot.options.libraryRoots});
        roots.texts.add(folders.beside.back());
        for (std::size_t i = 0; i < folders.library.size(); ++i)
            roots.texts.addBelow(folders.roots[i], folders.library[i]);
    }
    return roots;
}

int exitStatus(const suite::RunResult& run) {
    int status = run.orphansFail && !run.orphans.empty() ? kDiffers : kDone;
    for (const suite::ShotResult& each : run.shots) {
        if (!suite::isFailure(each.verdict)) continue;
        status = std::max(status, suite::wasNotDrawn(each) ? kSceneIsWrong : kDiffers);
    }
    return status;
}

bool mayDownload(const suite::ShotResult& shot, const Selection& selection,
                 const suite::RunOptions& options) {
    if (shot.awaits.empty() || !shot.awaitsStore || options.sandbox != nullptr) return false;
    const auto found = std::ranges::find(selection.suites, shot.suite, &suite::Suite::name);
    return found != selection.suites.end() && suite::isAddress(found->store);
}

std::set<suite::ShotKey> downloadFor(std::vector<suite::ShotResult>& waiting, const Selection& selection,
                                     const suite::RunOptions& options, const std::function<bool()>& stop) {
    std::map<std::string, std::size_t> known;  // by address
    std::vector<suite::Download> wanted;
    std::map<suite::ShotKey, std::vector<std::string>> addressesOf;
    for (const suite::ShotResult& shot : waiting) {
        const suite::Suite& suite = *std::ranges::find(selection.suites, shot.suite, &suite::Suite::name);
        const suite::PictureStore store(suite.store, {});
        for (const fs::path& golden : shot.awaits) {
            const fs::path inside = golden.lexically_relative(suite::goldenFolder(suite, options.goldens));
            if (inside.empty() || *inside.begin() == "..") continue;
            constexpr std::uint64_t kLongest = 4096;
            const auto bytes = image::readFile(golden, {golden.generic_string(), {}}, kLongest);
            const auto pointer = bytes ? suite::parsePointer(*bytes) : std::nullopt;
            if (!pointer) continue;
            const std::string address = store.placeOf(*pointer, golden.extension().generic_string());
            if (known.try_emplace(address, wanted.size()).second) wanted.push_back({*pointer, address});
            addressesOf[{shot.suite, shot.shot}].push_back(address);
        }
    }
    printLine(fmt::format("downloading {} of goldens", base::counted(wanted.size(), "picture")));
    suite::download(wanted, stop);
    std::set<suite::ShotKey> ready;
    for (suite::ShotResult& shot : waiting) {
        const suite::ShotKey key(shot.suite, shot.shot);
        std::string why;
        for (const std::string& each : addressesOf[key])
            if (const suite::Download& one = wanted[known.at(each)]; why.empty() && !one.whyNot.empty())
                why = fmt::format("the picture of its golden cannot be downloaded from '{}': {}", each,
                                  one.whyNot);
        if (why.empty()) {
            ready.insert(key);
            continue;
        }
        shot.reason = why;
        std::erase_if(shot.diagnostics, [](const Diagnostic& each) { return each.id == "suite-E34"; });
        shot.diagnostics.push_back(diagnose("suite-E34", why, {shot.awaits.front().generic_string(), 1, 1}));
    }
    return ready;
}

void noteUploads(const std::vector<suite::Suite>& suites, const fs::path& results) {
    const fs::path folder = results / suite::kUploads;
    const std::size_t count = base::entriesOf(folder).size();
    std::set<std::string> stores;
    for (const suite::Suite& each : suites)
        if (suite::isAddress(each.store)) stores.insert(each.store);
    for (const std::string& each : stores)
        if (count > 0)
            print({withoutId(Severity::note,
                             fmt::format("'{}' has {} for {}: upload {}, then commit the pointers",
                                         folder.generic_string(), base::counted(count, "picture"), each,
                                         count == 1 ? "it" : "them"))});
}

}  // namespace glibra::cli
