#include "base/contained_call.h"

#include <algorithm>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "system/child_process.h"
#include "system/memory.h"
#include "system/places.h"
#include "system/process.h"

namespace glibra::base {

std::uint64_t memoryShare(int jobs, std::size_t pieces) {
    const auto workers = std::min<std::uint64_t>(static_cast<std::uint64_t>(std::max(1, jobs)), pieces);
    return std::max(kLeastShare, system::usableMemory() / 2 / std::max<std::uint64_t>(1, workers));
}

CallEnd runContained(const CallLimits& limits, const std::function<void()>& work) {
    if (!system::workersAreCopies()) {
        work();
        return {};
    }
    system::Process process = system::runInCopy([&] {
        system::endWithParent();
        system::endBySignals();
        system::leaveNoCore();
        // In case that nobody is left who watches the time.
        if (limits.seconds > 0) system::limitProcessorTime(limits.seconds + 1);
        system::MemoryLimit().lower(limits.memory);  // a worker's own limit may be the lower one
        work();
    });
    if (!process) return {CallEnd::Kind::notStarted, 0};
    const std::optional<system::End> end = system::waitFor(process, limits.seconds);
    if (!end) {
        kill(process);
        waitFor(process);
        return {CallEnd::Kind::timedOut, 0};
    }
    if (end->wasTimeLimit) return {CallEnd::Kind::timedOut, 0};
    return {end->isGood() ? CallEnd::Kind::finished : CallEnd::Kind::died, end->signal};
}

bool runInThread(const CallLimits& limits, std::function<void()> work) {
    struct State {
        std::mutex mutex;
        std::condition_variable changed;
        bool ended = false;
    };
    const auto state = std::make_shared<State>();
    std::thread([state, work = std::move(work)] {
        work();
        const std::lock_guard lock(state->mutex);
        state->ended = true;
        state->changed.notify_all();
    }).detach();
    std::unique_lock lock(state->mutex);
    const auto ended = [&] { return state->ended; };
    if (limits.seconds <= 0) {
        state->changed.wait(lock, ended);
        return true;
    }
    return state->changed.wait_for(lock, std::chrono::duration<double>(limits.seconds), ended);
}

}  // namespace glibra::base
