#include "system/watch.h"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <utility>

#include "system/child_process.h"
#include "system/posix/extras.h"

namespace glibra::system {

struct FolderWatch::State {
    File inotify{::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)};
    Waker waker;
};

FolderWatch::FolderWatch() : state_(std::make_unique<State>()) {}
FolderWatch::~FolderWatch() = default;

FolderWatch::operator bool() const {
    return state_->inotify && state_->waker;
}

std::optional<int> FolderWatch::add(const std::filesystem::path& folder) {
    constexpr std::uint32_t kEvents = IN_CLOSE_WRITE | IN_CREATE | IN_MOVED_TO | IN_DELETE | IN_MOVED_FROM |
                                      IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;
    const int number = ::inotify_add_watch(numberOf(state_->inotify), folder.c_str(), kEvents);
    return number >= 0 ? std::optional(number) : std::nullopt;
}

void FolderWatch::remove(int folder) {
    ::inotify_rm_watch(numberOf(state_->inotify), folder);
}

FolderWatch::Waited FolderWatch::wait(int milliseconds) {
    std::array<pollfd, 2> wanted{
        {{numberOf(state_->inotify), POLLIN, 0}, {numberOf(state_->waker.file()), POLLIN, 0}}};
    if (::poll(wanted.data(), wanted.size(), milliseconds) <= 0) return Waited::nothing;
    return wanted[1].revents != 0 ? Waited::interrupted : Waited::events;
}

std::vector<FolderEvent> FolderWatch::take() {
    using What = FolderEvent::What;
    constexpr std::pair<std::uint32_t, What> kMeanings[] = {
        {IN_Q_OVERFLOW, What::lost},
        {IN_IGNORED | IN_UNMOUNT | IN_DELETE_SELF | IN_MOVE_SELF, What::folderGone},
        {IN_CLOSE_WRITE, What::written},
        {IN_CREATE, What::made},
        {IN_MOVED_TO, What::movedIn},
        {IN_DELETE | IN_MOVED_FROM, What::removed}};
    constexpr std::size_t kBufferBytes = 16384;
    alignas(inotify_event) std::array<char, kBufferBytes> buffer;
    std::vector<FolderEvent> events;
    for (;;) {
        const ssize_t length = ::read(numberOf(state_->inotify), buffer.data(), buffer.size());
        if (length <= 0) return events;
        for (ssize_t at = 0; at < length;) {
            const auto* event = reinterpret_cast<const inotify_event*>(buffer.data() + at);
            at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
            for (const auto& [bits, what] : kMeanings) {
                if ((event->mask & bits) == 0) continue;
                events.push_back({what, event->wd, event->len > 0 ? event->name : ""});
                break;
            }
        }
    }
}

bool FolderWatch::interrupt() {
    return state_->waker.wake();
}

}  // namespace glibra::system
