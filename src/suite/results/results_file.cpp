#include "suite/results/results_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <map>
#include <span>
#include <system_error>
#include <utility>

#include "base/whole_file.h"
#include "image/file.h"
#include "suite/write_below.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostMistakes = 20;
constexpr std::uint64_t kLargestResults = 1ULL << 30;
/// A loss of power costs the results since the last write to the disk. Writing each of them there would take
/// longer than drawing it on some disks.
constexpr std::chrono::seconds kSyncInterval{1};

Diagnostics makeFolder(const fs::path& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    std::error_code unknown;
    if (failed && !fs::is_directory(folder, unknown)) return {cannotWrite(folder, failed.value())};
    return {};
}

/// Appends in one piece. Returns 0, or the error number; the file is then as before.
int appendLine(int file, std::string_view line) {
    const off_t before = ::lseek(file, 0, SEEK_END);
    while (!line.empty()) {
        const ssize_t count = ::write(file, line.data(), line.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) {
            const int problem = count < 0 ? errno : ENOSPC;
            if (before >= 0 && ::ftruncate(file, before) != 0) return problem;
            return problem;
        }
        line.remove_prefix(static_cast<std::size_t>(count));
    }
    return 0;
}

Diagnostics writeWhole(const RunResult& run, const fs::path& file) {
    std::string text = toJsonLine(run) + '\n';
    for (const ShotResult& shot : run.shots) text += toJsonLine(shot) + '\n';
    if (run.complete) text += endLine(run.shots.size()) + '\n';
    const int problem =
        base::writeBeneath(file.parent_path(), file.filename(), std::as_bytes(std::span(text)));
    return problem == 0 ? Diagnostics{} : Diagnostics{cannotWrite(file, problem)};
}

}  // namespace

fs::path resultsFile(const fs::path& folder) {
    std::error_code ignored;
    return fs::is_regular_file(folder, ignored) ? folder : folder / "results.jsonl";
}

Diagnostic cannotShow(const fs::path& path, int problem) {
    const std::string name = path.string();
    switch (problem) {
        case ENOENT:
        case ENOTDIR:
            return diagnose("file-E01", fmt::format("cannot find '{}'", name));
        case EACCES:
        case EINVAL:
            return diagnose(
                "file-E14",
                fmt::format("cannot read '{}': it is not in the folder of the results, nor below the "
                            "folders of the suite, its scenes and the library",
                            name));
        case ELOOP:
            return diagnose("file-E14", fmt::format("cannot read '{}': links are not followed here", name));
        case ENOTSUP:
            return diagnose("file-E14", fmt::format("cannot read '{}': it is not an ordinary file", name));
        case EFBIG:
            return diagnose("file-E09", fmt::format("'{}' is too large to be shown", name));
        default:
            return diagnose("file-E14", fmt::format("cannot read '{}': {}", name,
                                                    std::generic_category().message(problem)));
    }
}

Result<std::vector<std::byte>> readNamed(const fs::path& path, const fs::path& resultsFolder,
                                         const base::Roots& roots, std::uint64_t largest) {
    base::Roots results;
    results.add(resultsFolder);
    base::Descriptor file = results.open(resultsFolder / path);  // the path itself if it is absolute
    int problem = file ? 0 : errno;
    if (!file && (problem == ENOENT || problem == ENOTDIR || problem == EACCES)) {
        file = roots.open(path);
        // What is neither in the results nor below a root is missing for a path into the results.
        if (!file && (errno != EACCES || problem == EACCES)) problem = errno;
    }
    if (!file) return cannotShow(path, problem);
    std::vector<std::byte> bytes;
    problem = base::readAll(file, largest, bytes);
    if (problem != 0) return cannotShow(path, problem);
    return bytes;
}

Diagnostics writeResults(const RunResult& run, const fs::path& folder) {
    if (Diagnostics problems = makeFolder(folder); !problems.empty()) return problems;
    return writeWhole(run, resultsFile(folder));
}

Result<RunResult> readResults(const fs::path& folder) {
    const std::string file = resultsFile(folder).string();
    std::error_code ignored;
    if (fs::is_symlink(file, ignored)) return cannotShow(file, ELOOP);
    const Result<std::vector<std::byte>> bytes = image::readFile(file, {file, {}}, kLargestResults);
    if (!bytes) return bytes.diagnostics;
    std::string_view rest = base::asText(*bytes);
    Result<RunResult> result;
    std::map<ShotKey, std::size_t> known;
    for (int number = 1; !rest.empty() && result.diagnostics.size() < kMostMistakes; ++number) {
        const std::size_t end = rest.find('\n');
        const bool isTorn = end == std::string_view::npos;
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(isTorn ? rest.size() : end + 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        const Place place{file, number, 1};
        if (number == 1) {
            Result<RunResult> run = parseRunLine(line, place);
            if (!run) return run.diagnostics;
            result.value = std::move(run.value);
            continue;
        }
        if (result->complete) {
            result.diagnostics.push_back(
                diagnose("result-E01", "this line stands after the end line", place));
            break;
        }
        if (const std::optional<std::size_t> count = parseEndLine(line)) {
            result->complete = true;
            if (*count != result->shots.size())
                result.diagnostics.push_back(
                    diagnose("result-E01",
                             fmt::format("the end line counts {} shots, but the file has {}", *count,
                                         result->shots.size()),
                             place));
            continue;
        }
        Result<ShotResult> shot = parseJsonLine(line, place);
        if (!shot && isTorn) {
            result.diagnostics.push_back(
                diagnose("result-N01", "the last line is torn, so its shot is not counted", place));
        } else if (!shot) {
            append(result.diagnostics, std::move(shot.diagnostics));
        } else {
            std::vector<ShotResult>& shots = result->shots;
            const auto [at, isNew] = known.try_emplace({shot->suite, shot->shot}, shots.size());
            if (isNew)
                shots.push_back(std::move(*shot));
            else
                shots[at->second] = std::move(*shot);
        }
    }
    if (hasError(result.diagnostics)) result.value.reset();
    return result;
}

ResultsLock::ResultsLock(base::Descriptor folder) : folder_(std::move(folder)), owner_(::getpid()) {}

ResultsLock::~ResultsLock() {
    // A process that was forked meanwhile shares the lock. Closing alone would leave the lock with it, and
    // that process must not release it.
    if (folder_ && ::getpid() == owner_) ::flock(folder_.number(), LOCK_UN);
}

Result<ResultsLock> lockResults(const fs::path& folder) {
    if (Diagnostics problems = makeFolder(folder); !problems.empty()) return problems;
    base::Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    // Only a lock that another process holds is a reason to stop, because some file systems have no locks.
    if (::flock(opened.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return diagnose(
            "result-E02",
            fmt::format("another run is writing its results to '{}'; give each run a folder of its own",
                        folder.string()));
    return ResultsLock(std::move(opened));
}

Result<ResultsWriter> ResultsWriter::open(const fs::path& folder, const RunResult& run, Start start) {
    Result<ResultsLock> lock = lockResults(folder);
    if (!lock) return std::move(lock.diagnostics);
    const fs::path path = resultsFile(folder);
    RunResult beginning = run;
    beginning.shots.clear();
    beginning.complete = false;
    std::error_code failed;
    if (start == Start::resumed && fs::exists(path, failed) && fs::file_size(path, failed) > 0) {
        Result<RunResult> earlier = readResults(path);
        if (!earlier) return earlier.diagnostics;
        beginning.shots = std::move(earlier->shots);
    }
    if (Diagnostics problems = writeWhole(beginning, path); !problems.empty()) return problems;
    base::Descriptor file(::open(path.c_str(), O_RDWR | O_APPEND | O_CLOEXEC | O_NOFOLLOW));
    if (!file) return cannotWrite(path, errno);
    return ResultsWriter(path, std::move(*lock), std::move(file));
}

Diagnostics ResultsWriter::add(const ShotResult& shot) {
    if (const int problem = appendLine(file_.number(), toJsonLine(shot) + '\n'); problem != 0)
        return {cannotWrite(path_, problem)};
    if (const auto now = std::chrono::steady_clock::now(); now - synced_ >= kSyncInterval) {
        // A disk that fails is reported by the write of the whole file at the end.
        ::fdatasync(file_.number());
        synced_ = now;
    }
    return {};
}

ResultsWriter::ResultsWriter(fs::path path, ResultsLock lock, base::Descriptor file)
    : path_(std::move(path)),
      lock_(std::move(lock)),
      file_(std::move(file)),
      synced_(std::chrono::steady_clock::now()) {}

}  // namespace glibra::suite
