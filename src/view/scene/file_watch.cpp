#include "view/scene/file_watch.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <ranges>
#include <system_error>
#include <utility>

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

void FileWatch::watch(const std::vector<fs::path>& files, const std::set<std::string>& names) {
    if (!isWorking()) return;
    const std::scoped_lock lock(mutex_);
    files_.clear();
    names_ = names;
    std::set<fs::path> folders;
    for (const fs::path& each : files) {
        const fs::path file = absolutePath(each);
        files_.insert(file);
        folders.insert(file.parent_path());
        gone_.erase(file);
        std::error_code failure;
        const fs::path target = fs::canonical(file, failure);
        if (failure || target == file) continue;
        files_.insert(target);
        folders.insert(target.parent_path());
    }
    for (const fs::path& each : gone_) {
        files_.insert(each);
        folders.insert(each.parent_path());
    }
    std::erase_if(folders_, [&](const auto& watched) {
        if (folders.erase(watched.second) != 0) return false;
        ::inotify_rm_watch(inotify_, watched.first);
        return true;
    });
    for (const fs::path& each : folders) {
        const int descriptor = ::inotify_add_watch(inotify_, each.c_str(),
                                                   IN_CLOSE_WRITE | IN_MOVED_TO | IN_DELETE | IN_MOVED_FROM);
        if (descriptor >= 0) folders_[descriptor] = each;
    }
}

FileWatch::Change FileWatch::takeChanged() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(changed_, {});
}

void FileWatch::noteSaved(const fs::path& file) {
    removed_.erase(file);
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

bool FileWatch::readEvents() {
    constexpr std::size_t kBufferBytes = 16384;
    alignas(inotify_event) std::array<char, kBufferBytes> buffer{};
    bool isWatched = false;
    for (;;) {
        const ssize_t length = ::read(inotify_, buffer.data(), buffer.size());
        if (length <= 0) return isWatched;
        const std::scoped_lock lock(mutex_);
        for (ssize_t at = 0; at < length;) {
            const auto* event = reinterpret_cast<const inotify_event*>(buffer.data() + at);
            at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
            const auto folder = folders_.find(event->wd);
            if (folder == folders_.end() || event->len == 0) continue;
            const fs::path file = folder->second / event->name;
            const bool isKnown = files_.contains(file);
            if ((event->mask & (IN_DELETE | IN_MOVED_FROM)) != 0) {
                if (isKnown) removed_[file] = std::chrono::steady_clock::now();
                continue;
            }
            if (!isKnown && !names_.contains(file.filename().string())) continue;
            noteSaved(file);
            isWatched = true;
        }
    }
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
