#include "base/earlier_calls.h"

#include <span>

#include "base/hash.h"
#include "base/packed.h"

namespace glibra::base {

void eachMember(auto& packed, Is<WorkerEvent> auto& of) {
    packed.upTo(WorkerEvent::Kind::done, of.kind);
    packed.upTo(Outcome::End::deviceLost, of.outcome.end);
    packed(of.index, of.outcome.signal, of.outcome.process, of.outcome.nearMemoryLimit, of.outcome.wasAlone,
           of.outcome.answer, of.outcome.lost, of.text);
}

namespace {

/// More than all answers of a class of a thousand.
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30U;

}  // namespace

std::uint64_t numberOfCall(std::string_view place, std::size_t times) {
    return combined(fnv1a(place), times);
}

std::string toBytes(const WorkerCalls& calls) {
    return packed(packed(calls));
}

WorkerCalls receiveCalls(const system::File& pipe) {
    std::uint64_t size = 0;
    if (!receiveAll(pipe, std::as_writable_bytes(std::span(&size, 1))) || size > kMostBytes) return {};
    std::string bytes(size, '\0');
    if (!receiveAll(pipe, std::as_writable_bytes(std::span(bytes)))) return {};
    return unpacked<WorkerCalls>(bytes).value_or(WorkerCalls());
}

}  // namespace glibra::base
