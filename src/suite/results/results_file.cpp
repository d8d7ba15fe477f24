#include "suite/results/results_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <span>
#include <system_error>
#include <utility>

#include "image/file.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostMistakes = 20;
constexpr std::uint64_t kLargestResults = 1ULL << 30;
/// A loss of power costs the results since the last write to the disk. Writing each of them there would take
/// longer than drawing it on some disks.
constexpr std::chrono::seconds kSyncInterval{1};

Diagnostic cannotWrite(const fs::path& path, int problem) {
    return diagnose("file-E10", fmt::format("cannot write '{}': {}", path.string(),
                                            std::generic_category().message(problem)));
}

Diagnostics makeFolder(const fs::path& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    std::error_code unknown;
    if (failed && !fs::is_directory(folder, unknown)) return {cannotWrite(folder, failed.value())};
    return {};
}

Diagnostic isBusy(const fs::path& folder) {
    return diagnose(
        "result-E02",
        fmt::format("another run is writing its results to '{}'; give each run a folder of its own",
                    folder.string()));
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

/// The folder of a results file, and its name there.
std::pair<fs::path, fs::path> placeOf(const fs::path& file) {
    return {file.parent_path(), file.filename()};
}

Diagnostics writeWhole(const RunResult& run, const fs::path& file) {
    std::string text = toJsonLine(run) + '\n';
    for (const ShotResult& shot : run.shots) text += toJsonLine(shot) + '\n';
    if (run.complete) text += endLine(run.shots.size()) + '\n';
    const auto [folder, name] = placeOf(file);
    const int problem = base::writeBeneath(folder, name, std::as_bytes(std::span(text)));
    return problem == 0 ? Diagnostics{} : Diagnostics{cannotWrite(file, problem)};
}

/// The lines of a file with their numbers, one after the other.
class Lines {
  public:
    explicit Lines(std::string_view text) : rest_(text) {}

    bool next() {
        if (rest_.empty()) return false;
        const std::size_t end = rest_.find('\n');
        torn_ = end == std::string_view::npos;
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(torn_ ? rest_.size() : end + 1);
        if (line_.ends_with('\r')) line_.remove_suffix(1);
        ++number_;
        return true;
    }
    [[nodiscard]] std::string_view line() const { return line_; }
    [[nodiscard]] int number() const { return number_; }
    /// The last line, without a line end.
    [[nodiscard]] bool torn() const { return torn_; }

  private:
    std::string_view rest_, line_;
    int number_ = 0;
    bool torn_ = false;
};

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
                "file-E02",
                fmt::format("cannot read '{}': it is not in the folder of the results, nor below the "
                            "folders of the suite, its scenes and the library",
                            name));
        case ELOOP:
            return diagnose("file-E02", fmt::format("cannot read '{}': links are not followed here", name));
        case ENOTSUP:
            return diagnose("file-E02", fmt::format("cannot read '{}': it is not an ordinary file", name));
        case EFBIG:
            return diagnose("file-E09", fmt::format("'{}' is too large to be shown", name));
        default:
            return diagnose("file-E02", fmt::format("cannot read '{}': {}", name,
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
    Lines lines({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    Result<RunResult> result;
    std::map<std::pair<std::string, std::string>, std::size_t> known;
    while (lines.next() && result.diagnostics.size() < kMostMistakes) {
        const Place place{file, lines.number(), 1};
        if (lines.number() == 1) {
            Result<RunResult> run = parseRunLine(lines.line(), place);
            if (!run) return run.diagnostics;
            result.value = std::move(run.value);
            continue;
        }
        if (result->complete) {
            result.diagnostics.push_back(
                diagnose("result-E01", "this line stands after the end line", place));
            break;
        }
        if (const std::optional<std::size_t> count = parseEndLine(lines.line())) {
            result->complete = true;
            if (*count != result->shots.size())
                result.diagnostics.push_back(
                    diagnose("result-E01",
                             fmt::format("the end line counts {} shots, but the file has {}", *count,
                                         result->shots.size()),
                             place));
            continue;
        }
        Result<ShotResult> shot = parseJsonLine(lines.line(), place);
        if (!shot && lines.torn()) {
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

Result<base::Descriptor> lockResults(const fs::path& folder) {
    if (Diagnostics problems = makeFolder(folder); !problems.empty()) return problems;
    base::Descriptor locked(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (::flock(locked.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return isBusy(folder);
    return locked;
}

Result<ResultsWriter> ResultsWriter::open(const fs::path& folder, const RunResult& run, Start start) {
    if (Diagnostics problems = makeFolder(folder); !problems.empty()) return problems;
    const fs::path path = resultsFile(folder);
    ResultsWriter writer(path, ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC), -1);
    // Only a lock that another process holds is a reason to stop, because some file systems have no locks.
    if (::flock(writer.folder_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return isBusy(folder);
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
    writer.file_ = ::open(path.c_str(), O_RDWR | O_APPEND | O_CLOEXEC | O_NOFOLLOW);
    if (writer.file_ < 0) return cannotWrite(path, errno);
    return writer;
}

Diagnostics ResultsWriter::add(const ShotResult& shot) {
    if (const int problem = appendLine(file_, toJsonLine(shot) + '\n'); problem != 0)
        return {cannotWrite(path_, problem)};
    if (const auto now = std::chrono::steady_clock::now(); now - synced_ >= kSyncInterval) {
        ::fdatasync(file_);  // a disk that fails is reported by the write of the whole file at the end
        synced_ = now;
    }
    return {};
}

ResultsWriter::ResultsWriter(fs::path path, int folder, int file)
    : path_(std::move(path)),
      folder_(folder),
      owner_(::getpid()),
      file_(file),
      synced_(std::chrono::steady_clock::now()) {}

ResultsWriter::ResultsWriter(ResultsWriter&& other) noexcept
    : path_(std::move(other.path_)),
      folder_(std::exchange(other.folder_, -1)),
      owner_(other.owner_),
      file_(std::exchange(other.file_, -1)),
      synced_(other.synced_) {}

ResultsWriter& ResultsWriter::operator=(ResultsWriter&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(folder_, other.folder_);
    std::swap(owner_, other.owner_);
    std::swap(file_, other.file_);
    std::swap(synced_, other.synced_);
    return *this;
}

ResultsWriter::~ResultsWriter() {
    if (file_ >= 0) ::close(file_);
    if (folder_ < 0) return;
    // A process that was forked meanwhile shares the lock. Closing alone would leave the lock with it, and
    // that process must not release it.
    if (::getpid() == owner_) ::flock(folder_, LOCK_UN);
    ::close(folder_);
}

}  // namespace glibra::suite
