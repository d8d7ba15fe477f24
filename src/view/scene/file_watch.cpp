#include "view/scene/file_watch.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <ranges>
#include <system_error>
#include <utility>

#include "base/text.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

/// Some programs save several files, or one file in several steps. After each event the watch waits this long
/// for another one before it reports.
constexpr int kQuietMilliseconds = 1;
constexpr int kMostQuietWaits = 20;
/// A removed file that an editor writes anew is there again after this time.
constexpr std::chrono::milliseconds kAway{200};

fs::path absolutePath(const fs::path& path) {
    std::error_code failure;
    return fs::absolute(path, failure).lexically_normal();
}

bool isReadable(int descriptor, int milliseconds) {
    pollfd wanted{descriptor, POLLIN, 0};
    return ::poll(&wanted, 1, milliseconds) > 0;
}

}  // namespace

FileWatch::FileWatch(std::function<void()> wake)
    : wake_(std::move(wake)),
      inotify_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)),
      stop_(::eventfd(0, EFD_CLOEXEC)) {
    if (inotify_ < 0 || stop_ < 0) return;
    try {
        thread_ = std::thread([this] { run(); });
    } catch (const std::system_error&) {
        // Without a thread nothing is watched, and isWorking() is false.
    }
}

FileWatch::~FileWatch() {
    if (thread_.joinable()) {
        const std::uint64_t one = 1;
        if (::write(stop_, &one, sizeof one) == sizeof one)
            thread_.join();
        else
            thread_.detach();
    }
    if (inotify_ >= 0) ::close(inotify_);
    if (stop_ >= 0) ::close(stop_);
}

FileWatch::Identity FileWatch::identityOf(const fs::path& file) {
    struct stat found{};
    if (::stat(file.c_str(), &found) != 0) return {};
    return {found.st_dev, found.st_ino, found.st_size, found.st_mtim.tv_sec, found.st_mtim.tv_nsec};
}

void FileWatch::watch(const std::vector<fs::path>& files) {
    if (!isWorking()) return;
    const std::scoped_lock lock(mutex_);
    files_.clear();
    for (const fs::path& each : files) {
        const fs::path file = absolutePath(each);
        const Identity identity = files_[file] = identityOf(file);
        if (identity != Identity()) gone_.erase(file);
    }
    for (const fs::path& each : gone_) files_.emplace(each, Identity());
    findWays();
}

/// Follows the path of a file from the root, through links, as far as it exists.
void FileWatch::findWay(const fs::path& file, std::set<fs::path>& folders) {
    constexpr int kMostLinks = 40;  // as many as Linux follows
    int links = 0;
    fs::path folder = "/";
    std::vector<fs::path> rest;  // the next part is the last one
    const auto prepend = [&](const fs::path& path) {
        const std::size_t before = rest.size();
        for (const fs::path& part : path.relative_path())
            if (!part.empty() && part != ".") rest.push_back(part);
        std::reverse(rest.begin() + static_cast<std::ptrdiff_t>(before), rest.end());
    };
    prepend(file);
    while (!rest.empty()) {
        const fs::path part = std::exchange(rest.back(), {});
        rest.pop_back();
        if (part == "..") {
            folder = folder.parent_path();
            continue;
        }
        const fs::path path = folder / part;
        std::error_code failure;
        const fs::file_type type = fs::symlink_status(path, failure).type();
        const bool isLink = type == fs::file_type::symlink && ++links <= kMostLinks;
        folders.insert(folder);
        Name& name = names_[path];
        if (rest.empty()) name.files.insert(file);
        name.isPassed = name.isPassed || !rest.empty() || isLink;
        if (isLink) {
            const fs::path target = fs::read_symlink(path, failure);
            if (target.is_absolute()) folder = "/";
            prepend(target);
            continue;
        }
        if (type == fs::file_type::not_found && rest.empty())
            missing_[base::lower(path.native())].files.insert(file);
        if (type != fs::file_type::directory) return;
        folder = path;
    }
}

void FileWatch::findWays() {
    constexpr std::uint32_t kEvents = IN_CLOSE_WRITE | IN_CREATE | IN_MOVED_TO | IN_DELETE | IN_MOVED_FROM |
                                      IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;
    names_.clear();
    missing_.clear();
    std::set<fs::path> folders;
    for (const auto& each : files_) findWay(each.first, folders);
    std::map<int, fs::path> watched;
    for (const fs::path& each : folders)
        if (const int descriptor = ::inotify_add_watch(inotify_, each.c_str(), kEvents); descriptor >= 0)
            watched[descriptor] = each;
    for (const auto& each : folders_)
        if (!watched.contains(each.first)) ::inotify_rm_watch(inotify_, each.first);
    folders_ = std::move(watched);
}

bool FileWatch::followWays() {
    findWays();
    const auto now = std::chrono::steady_clock::now();
    bool isAny = false;
    for (auto& [file, identity] : files_) {
        const Identity before = std::exchange(identity, identityOf(file));
        if (identity == before) continue;
        if (identity == Identity()) {
            removed_.emplace(file, now);
            continue;
        }
        noteSaved(file);
        isAny = true;
    }
    return isAny;
}

FileWatch::Change FileWatch::takeChanged() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(changed_, {});
}

void FileWatch::noteSaved(const fs::path& file) {
    removed_.erase(file);
    gone_.erase(file);
    if (const auto known = files_.find(file); known != files_.end()) known->second = identityOf(file);
    if (changed_.files.empty()) changed_.saved = std::chrono::steady_clock::now();
    if (std::ranges::find(changed_.files, file) == changed_.files.end()) changed_.files.push_back(file);
}

bool FileWatch::reportRemoved() {
    const std::scoped_lock lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    bool isAny = false;
    std::vector<fs::path> due;
    for (const auto& [file, since] : removed_)
        if (now - since >= kAway) due.push_back(file);
    for (const fs::path& file : due) {
        removed_.erase(file);
        std::error_code failure;
        if (fs::exists(file, failure)) continue;
        noteSaved(file);
        gone_.insert(file);
        isAny = true;
    }
    return isAny;
}

int FileWatch::millisecondsToRemoved() {
    const std::scoped_lock lock(mutex_);
    if (removed_.empty()) return -1;
    const auto first = std::ranges::min(std::views::values(removed_));
    const auto left = first + kAway - std::chrono::steady_clock::now();
    const auto milliseconds = std::chrono::ceil<std::chrono::milliseconds>(left).count();
    return static_cast<int>(std::clamp<std::int64_t>(milliseconds, 0, kAway.count()));
}

/// One event about the name in a folder, or about the folder itself. Seen::moved: the paths lead elsewhere
/// now.
FileWatch::Seen FileWatch::readEvent(int descriptor, std::uint32_t what, const std::string& name) {
    if ((what & IN_Q_OVERFLOW) != 0) return Seen::moved;
    const auto folder = folders_.find(descriptor);
    if (folder == folders_.end()) return Seen::nothing;
    if ((what & (IN_IGNORED | IN_UNMOUNT | IN_DELETE_SELF | IN_MOVE_SELF)) != 0) return Seen::moved;
    const fs::path path = folder->second / name;
    const auto known = names_.find(path);
    const auto similar = missing_.find(base::lower(path.native()));
    if (known == names_.end() && similar == missing_.end()) return Seen::nothing;
    const Name& meant = known == names_.end() ? similar->second : known->second;
    if (meant.isPassed && (what & IN_CLOSE_WRITE) == 0) return Seen::moved;
    if ((what & (IN_DELETE | IN_MOVED_FROM)) != 0) {
        for (const fs::path& file : meant.files) removed_[file] = std::chrono::steady_clock::now();
        return Seen::nothing;
    }
    if ((what & (IN_CREATE | IN_MOVED_TO)) != 0) {
        struct stat made{};
        if (::lstat(path.c_str(), &made) == 0 && S_ISLNK(made.st_mode)) return Seen::moved;
        // A new file is written and closed; only a further name of one is complete as it is made.
        if ((what & IN_CREATE) != 0 && made.st_nlink < 2) return Seen::nothing;
    }
    for (const fs::path& file : meant.files) noteSaved(file);
    return meant.files.empty() ? Seen::nothing : Seen::saved;
}

bool FileWatch::readEvents() {
    constexpr std::size_t kBufferBytes = 16384;
    alignas(inotify_event) std::array<char, kBufferBytes> buffer{};
    bool isWatched = false, isMoved = false;
    const std::scoped_lock lock(mutex_);
    for (;;) {
        const ssize_t length = ::read(inotify_, buffer.data(), buffer.size());
        if (length <= 0) break;
        for (ssize_t at = 0; at < length;) {
            const auto* event = reinterpret_cast<const inotify_event*>(buffer.data() + at);
            at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
            const Seen seen = readEvent(event->wd, event->mask, event->len > 0 ? event->name : "");
            isWatched = isWatched || seen == Seen::saved;
            isMoved = isMoved || seen == Seen::moved;
        }
    }
    return (isMoved && followWays()) || isWatched;
}

void FileWatch::run() {
    for (;;) {
        std::array<pollfd, 2> wanted{{{inotify_, POLLIN, 0}, {stop_, POLLIN, 0}}};
        if (::poll(wanted.data(), wanted.size(), millisecondsToRemoved()) < 0) continue;
        if (wanted[1].revents != 0) return;
        try {
            bool isWatched = readEvents();
            for (int i = 0; isWatched && i < kMostQuietWaits && isReadable(inotify_, kQuietMilliseconds); ++i)
                isWatched = readEvents() || isWatched;
            isWatched = reportRemoved() || isWatched;
            if (isWatched) wake_();
        } catch (const std::bad_alloc&) {
            // These events are lost. The next save of a file is reported again.
        }
    }
}

}  // namespace glibra::view
