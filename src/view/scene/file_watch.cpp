#include "view/scene/file_watch.h"

#include <algorithm>
#include <cstdint>
#include <new>
#include <optional>
#include <ranges>
#include <system_error>
#include <utility>

#include "base/text.h"
#include "system/folder.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

/// Some programs save several files, or one file in several steps. After each event the watch waits this long
/// for another one before it reports.
constexpr int kQuietMilliseconds = 1;
constexpr int kMostQuietWaits = 20;
/// A removed file that an editor writes anew is there again after this time.
constexpr std::chrono::milliseconds kAway{200};

}  // namespace

FileWatch::FileWatch(std::function<void()> wake) : wake_(std::move(wake)) {
    if (!watch_) return;
    try {
        thread_ = std::thread([this] { run(); });
    } catch (const std::system_error&) {
        // Without a thread nothing is watched, and isWorking() is false.
    }
}

FileWatch::~FileWatch() {
    if (!thread_.joinable()) return;
    if (watch_.interrupt())
        thread_.join();
    else
        thread_.detach();
}

void FileWatch::watch(const std::vector<fs::path>& files) {
    if (!isWorking()) return;
    const std::scoped_lock lock(mutex_);
    files_.clear();
    for (const fs::path& each : files) {
        const fs::path file = system::wholePath(each);
        const Identity identity = files_[file] = system::identityOf(file);
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
            missing_[base::lower(path.generic_string())].files.insert(file);
        if (type != fs::file_type::directory) return;
        folder = path;
    }
}

void FileWatch::findWays() {
    names_.clear();
    missing_.clear();
    std::set<fs::path> folders;
    for (const auto& each : files_) findWay(each.first, folders);
    std::map<int, fs::path> watched;
    for (const fs::path& each : folders)
        if (const std::optional<int> number = watch_.add(each)) watched[*number] = each;
    for (const auto& each : folders_)
        if (!watched.contains(each.first)) watch_.remove(each.first);
    folders_ = std::move(watched);
}

bool FileWatch::followWays() {
    findWays();
    const auto now = std::chrono::steady_clock::now();
    bool isAny = false;
    for (auto& [file, identity] : files_) {
        const Identity before = std::exchange(identity, system::identityOf(file));
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
    if (const auto known = files_.find(file); known != files_.end()) known->second = system::identityOf(file);
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
FileWatch::Seen FileWatch::readEvent(const system::FolderEvent& event) {
    using What = system::FolderEvent::What;
    if (event.what == What::lost) return Seen::moved;
    const auto folder = folders_.find(event.folder);
    if (folder == folders_.end()) return Seen::nothing;
    if (event.what == What::folderGone) return Seen::moved;
    const fs::path path = folder->second / event.name;
    const auto known = names_.find(path);
    const auto similar = missing_.find(base::lower(path.generic_string()));
    if (known == names_.end() && similar == missing_.end()) return Seen::nothing;
    const Name& meant = known == names_.end() ? similar->second : known->second;
    if (meant.isPassed && event.what != What::written) return Seen::moved;
    if (event.what == What::removed) {
        for (const fs::path& file : meant.files) removed_[file] = std::chrono::steady_clock::now();
        return Seen::nothing;
    }
    if (event.what == What::made || event.what == What::movedIn) {
        system::FileFacts made;
        factsOf(path, system::Links::notFollowed, made);
        if (made.kind == system::FileKind::link) return Seen::moved;
        // A new file is written and closed; only a further name of one is complete as it is made.
        if (event.what == What::made && made.names < 2) return Seen::nothing;
    }
    for (const fs::path& file : meant.files) noteSaved(file);
    return meant.files.empty() ? Seen::nothing : Seen::saved;
}

bool FileWatch::readEvents() {
    bool isWatched = false, isMoved = false;
    const std::scoped_lock lock(mutex_);
    for (const system::FolderEvent& event : watch_.take()) {
        const Seen seen = readEvent(event);
        isWatched = isWatched || seen == Seen::saved;
        isMoved = isMoved || seen == Seen::moved;
    }
    return (isMoved && followWays()) || isWatched;
}

void FileWatch::run() {
    for (;;) {
        using Waited = system::FolderWatch::Waited;
        if (watch_.wait(millisecondsToRemoved()) == Waited::interrupted) return;
        try {
            bool isWatched = readEvents();
            for (int i = 0;
                 isWatched && i < kMostQuietWaits && watch_.wait(kQuietMilliseconds) == Waited::events; ++i)
                isWatched = readEvents() || isWatched;
            isWatched = reportRemoved() || isWatched;
            if (isWatched) wake_();
        } catch (const std::bad_alloc&) {
            // These events are lost. The next save of a file is reported again.
        }
    }
}

}  // namespace glibra::view
