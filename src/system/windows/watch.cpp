#include "system/watch.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <mutex>
#include <utility>

#include "system/windows/win.h"

namespace glibra::system {
namespace {

namespace fs = std::filesystem;

constexpr DWORD kBufferBytes = 1U << 16U;  // more is not possible in a network
constexpr DWORD kChanges = FILE_NOTIFY_CHANGE_FILE_NAME | FILE_NOTIFY_CHANGE_DIR_NAME |
                           FILE_NOTIFY_CHANGE_SIZE | FILE_NOTIFY_CHANGE_LAST_WRITE;

/// A folder that is watched. It is kept until the system has ended its request, which writes to it.
struct Watched {
    OVERLAPPED request{};
    File folder;
    fs::path path;
    std::pair<std::uint64_t, std::uint64_t> identity;
    int number = 0;
    bool isRemoved = false;
    alignas(FILE_NOTIFY_INFORMATION) std::array<std::byte, kBufferBytes> buffer{};
};

using What = FolderEvent::What;

/// What has happened to a name. Windows does not say when a file is closed: each change of it counts as
/// written. A file that was moved here from another folder is made, as it reports it, but not empty.
std::optional<What> whatOf(DWORD action, const fs::path& file) {
    FileFacts facts;
    switch (action) {
        case FILE_ACTION_ADDED:
            factsOf(file, Links::notFollowed, facts);
            return facts.kind == FileKind::regular && facts.size > 0 ? What::movedIn : What::made;
        case FILE_ACTION_RENAMED_NEW_NAME:
            return What::movedIn;
        case FILE_ACTION_REMOVED:
        case FILE_ACTION_RENAMED_OLD_NAME:
            return What::removed;
        case FILE_ACTION_MODIFIED:
            // A folder is modified by what happens in it.
            if (kindOf(file, Links::followed) == FileKind::folder) return std::nullopt;
            return What::written;
        default:
            return std::nullopt;
    }
}

}  // namespace

struct FolderWatch::State {
    File port = ownOf(::CreateIoCompletionPort(INVALID_HANDLE_VALUE, nullptr, 0, 0));
    std::atomic<bool> isInterrupted = false;
    std::mutex mutex;  ///< of all below
    std::map<OVERLAPPED*, std::unique_ptr<Watched>> folders;
    std::vector<FolderEvent> events;
    int last = 0;

    static bool request(Watched& each) {
        each.request = {};
        return ::ReadDirectoryChangesW(winOf(each.folder), each.buffer.data(), kBufferBytes, FALSE, kChanges,
                                       nullptr, &each.request, nullptr) != 0;
    }

    void note(const Watched& from, std::size_t bytes) {
        if (bytes == 0) return events.push_back({.what = What::lost});
        for (std::size_t at = 0; at + sizeof(FILE_NOTIFY_INFORMATION) <= bytes;) {
            const auto* found = reinterpret_cast<const FILE_NOTIFY_INFORMATION*>(from.buffer.data() + at);
            const std::wstring_view name(found->FileName, found->FileNameLength / sizeof(wchar_t));
            if (const std::optional<What> what = whatOf(found->Action, from.path / name))
                events.push_back({*what, from.number, narrowOf(name)});
            if (found->NextEntryOffset == 0) break;
            at += found->NextEntryOffset;
        }
    }

    /// Takes what the port has at the end of a request.
    void finish(OVERLAPPED* request_, std::size_t bytes, bool isGood) {
        const auto found = folders.find(request_);
        if (found == folders.end()) return;
        Watched& each = *found->second;
        if (!each.isRemoved && isGood) {
            note(each, bytes);
            if (request(each)) return;
        }
        if (!each.isRemoved) events.push_back({What::folderGone, each.number, {}});
        folders.erase(found);
    }

    /// Takes one message of the port, at most after that time. False: there was none.
    bool takeOne(DWORD milliseconds) {
        DWORD bytes = 0;
        ULONG_PTR key = 0;
        OVERLAPPED* ended = nullptr;
        const bool isGood = ::GetQueuedCompletionStatus(winOf(port), &bytes, &key, &ended, milliseconds) != 0;
        if (ended == nullptr) return isGood;
        const std::scoped_lock lock(mutex);
        finish(ended, bytes, isGood);
        return true;
    }

    bool hasEvents() {
        const std::scoped_lock lock(mutex);
        return !events.empty();
    }
};

FolderWatch::FolderWatch() : state_(std::make_unique<State>()) {}

FolderWatch::~FolderWatch() {
    for (auto& [request, each] : state_->folders) {
        each->isRemoved = true;
        each->folder.close();  // which ends the request
    }
    constexpr DWORD kLongest = 1000;
    while (!state_->folders.empty() && state_->takeOne(kLongest)) {
    }
    // The system may still write to what it has not given back.
    for (auto& [request, each] : state_->folders) static_cast<void>(each.release());
}

FolderWatch::operator bool() const {
    return static_cast<bool>(state_->port);
}

std::optional<int> FolderWatch::add(const fs::path& folder) {
    auto added = std::make_unique<Watched>();
    added->folder =
        openExisting(folder, FILE_LIST_DIRECTORY | FILE_READ_ATTRIBUTES,
                     FILE_FLAG_BACKUP_SEMANTICS | FILE_FLAG_OVERLAPPED | FILE_FLAG_OPEN_REPARSE_POINT);
    FileFacts facts;
    if (!added->folder || factsOf(added->folder, facts) != 0 || facts.kind != FileKind::folder)
        return std::nullopt;
    added->identity = {facts.device, facts.number};
    std::error_code failure;
    added->path = fs::absolute(folder, failure);
    const std::scoped_lock lock(state_->mutex);
    for (const auto& [request, each] : state_->folders)
        if (!each->isRemoved && each->identity == added->identity) return each->number;
    added->number = ++state_->last;
    if (::CreateIoCompletionPort(winOf(added->folder), winOf(state_->port), 0, 0) == nullptr ||
        !State::request(*added))
        return std::nullopt;
    OVERLAPPED* const request = &added->request;
    return state_->folders.emplace(request, std::move(added)).first->second->number;
}

void FolderWatch::remove(int folder) {
    const std::scoped_lock lock(state_->mutex);
    for (auto& [request, each] : state_->folders) {
        if (each->number != folder) continue;
        each->isRemoved = true;
        each->folder.close();
    }
}

FolderWatch::Waited FolderWatch::wait(int milliseconds) {
    const ULONGLONG start = ::GetTickCount64();
    for (;;) {
        if (state_->isInterrupted) return Waited::interrupted;
        if (state_->hasEvents()) return Waited::events;
        const ULONGLONG passed = ::GetTickCount64() - start;
        const bool isOver = milliseconds >= 0 && passed >= static_cast<ULONGLONG>(milliseconds);
        const DWORD left = milliseconds < 0 ? INFINITE
                           : isOver         ? 0
                                    : static_cast<DWORD>(static_cast<ULONGLONG>(milliseconds) - passed);
        if (!state_->takeOne(left) && isOver) return Waited::nothing;
    }
}

std::vector<FolderEvent> FolderWatch::take() {
    while (!state_->isInterrupted && state_->takeOne(0)) {
    }
    const std::scoped_lock lock(state_->mutex);
    return std::exchange(state_->events, {});
}

bool FolderWatch::interrupt() {
    state_->isInterrupted = true;
    return ::PostQueuedCompletionStatus(winOf(state_->port), 0, 0, nullptr) != 0;
}

}  // namespace glibra::system
