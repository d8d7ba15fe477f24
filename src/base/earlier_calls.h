#pragma once
// Where a worker is this program started again, it passes the calls of runInWorkers that its parent has made
// before. They do no work there: their callers hear once more what the parent's have heard, so that both come
// to the same state.

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome.h"
#include "system/file.h"

namespace glibra::base {

/// What a call has told its caller.
struct WorkerEvent {
    enum class Kind : std::uint32_t { progress, repeated, done };
    Kind kind = Kind::progress;
    std::size_t index = 0;
    Outcome outcome{};   ///< not of `progress`
    std::string text{};  ///< of `progress`
};

/// The calls of a process by their numbers.
using WorkerCalls = std::map<std::uint64_t, std::vector<WorkerEvent>>;

/// A call is known by its place in the source and by how often that place was passed before, not by how many
/// calls were made: some are made only if a file exists, which other workers may have made meanwhile.
std::uint64_t numberOfCall(std::string_view place, std::size_t times);

/// The calls as bytes, with their length first.
std::string toBytes(const WorkerCalls& calls);
/// Reads what toBytes() wrote; no calls if the pipe has something else.
WorkerCalls receiveCalls(const system::File& pipe);

}  // namespace glibra::base
