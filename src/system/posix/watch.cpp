// Looks at the folders again and again. src/system/linux/watch.cpp replaces this file.

#include "system/watch.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <system_error>
#include <utility>

#include "system/file.h"

namespace glibra::system {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::milliseconds kBetweenLooks{100};

bool isSame(const FileFacts& a, const FileFacts& b) {
    return a.kind == b.kind && a.device == b.device && a.number == b.number && a.size == b.size &&
           a.seconds == b.seconds && a.nanoseconds == b.nanoseconds;
}

}  // namespace

struct FolderWatch::State {
    struct Entry {
        FileFacts facts;
        bool isChanging = false;  ///< another one than at the look before: its writer may not be done
    };
    struct Watched {
        fs::path path;
        FileFacts facts;
        std::map<std::string, Entry> entries;
        bool isGone = false;
    };

    static std::map<std::string, Entry> entriesOf(const fs::path& folder) {
        std::map<std::string, Entry> entries;
        std::error_code failure;
        for (fs::directory_iterator each(folder, failure), end; !failure && each != end;
             each.increment(failure))
            factsOf(each->path(), Links::notFollowed, entries[each->path().filename().string()].facts);
        return entries;
    }

    std::mutex mutex;
    std::condition_variable changed;
    std::map<int, Watched> folders;
    std::vector<FolderEvent> events;
    int next = 1;
    bool isInterrupted = false;

    void note(FolderEvent::What what, int folder, const std::string& name) {
        events.push_back({what, folder, name});
    }

    /// What the name is now. A file is reported when it stays as it is.
    void compare(int folder, const std::string& name, Entry* before, Entry& now) {
        using What = FolderEvent::What;
        const bool isOther = before == nullptr || !isSame(before->facts, now.facts);
        if (now.facts.kind == FileKind::regular) {
            now.isChanging = isOther;
            if (!isOther && before->isChanging) note(What::written, folder, name);
        } else if (before == nullptr ||
                   (isOther && (now.facts.kind == FileKind::link || before->facts.kind != now.facts.kind ||
                                before->facts.number != now.facts.number))) {
            note(What::made, folder, name);
        }
    }

    void look(int number, Watched& folder) {
        if (folder.isGone) return;
        FileFacts facts;
        factsOf(folder.path, Links::notFollowed, facts);
        if (facts.number != folder.facts.number || facts.device != folder.facts.device) {
            folder.isGone = true;
            return note(FolderEvent::What::folderGone, number, {});
        }
        std::map<std::string, Entry> now = entriesOf(folder.path);
        for (auto& [name, entry] : now) {
            const auto before = folder.entries.find(name);
            compare(number, name, before == folder.entries.end() ? nullptr : &before->second, entry);
        }
        for (const auto& [name, entry] : folder.entries)
            if (!now.contains(name)) note(FolderEvent::What::removed, number, name);
        folder.entries = std::move(now);
    }
};

FolderWatch::FolderWatch() : state_(std::make_unique<State>()) {}
FolderWatch::~FolderWatch() = default;

FolderWatch::operator bool() const {
    return true;
}

std::optional<int> FolderWatch::add(const fs::path& folder) {
    const std::scoped_lock lock(state_->mutex);
    FileFacts facts;
    if (factsOf(folder, Links::notFollowed, facts) != 0 || facts.kind != FileKind::folder)
        return std::nullopt;
    for (const auto& [number, each] : state_->folders)
        if (!each.isGone && each.path == folder) return number;
    state_->folders[state_->next] = {folder, facts, State::entriesOf(folder)};
    return state_->next++;
}

void FolderWatch::remove(int folder) {
    const std::scoped_lock lock(state_->mutex);
    state_->folders.erase(folder);
}

FolderWatch::Waited FolderWatch::wait(int milliseconds) {
    const auto start = std::chrono::steady_clock::now();
    std::unique_lock lock(state_->mutex);
    for (;;) {
        if (state_->isInterrupted) return Waited::interrupted;
        if (!state_->events.empty()) return Waited::events;
        auto pause = kBetweenLooks;
        if (milliseconds >= 0) {
            const auto left =
                std::chrono::milliseconds(milliseconds) - (std::chrono::steady_clock::now() - start);
            if (left <= std::chrono::nanoseconds(0)) return Waited::nothing;
            pause = std::min(pause, std::chrono::ceil<std::chrono::milliseconds>(left));
        }
        state_->changed.wait_for(lock, pause);
        if (pause == kBetweenLooks)
            for (auto& [number, each] : state_->folders) state_->look(number, each);
    }
}

std::vector<FolderEvent> FolderWatch::take() {
    const std::scoped_lock lock(state_->mutex);
    return std::exchange(state_->events, {});
}

bool FolderWatch::interrupt() {
    const std::scoped_lock lock(state_->mutex);
    state_->isInterrupted = true;
    state_->changed.notify_all();
    return true;
}

}  // namespace glibra::system
