#include "base/earlier_calls.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <utility>

#include "base/hash.h"

namespace glibra::base {
namespace {

/// More than all answers of a class of a thousand.
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30U;

class Writer {
  public:
    void number(std::uint64_t value) {
        std::array<char, sizeof value> bytes{};
        std::memcpy(bytes.data(), &value, sizeof value);
        bytes_.append(bytes.data(), bytes.size());
    }
    void text(std::string_view value) {
        number(value.size());
        bytes_ += value;
    }
    void event(const WorkerEvent& event) {
        const Outcome& outcome = event.outcome;
        number(static_cast<std::uint64_t>(event.kind));
        number(event.index);
        number(static_cast<std::uint64_t>(outcome.end));
        number(static_cast<std::uint64_t>(outcome.signal));
        number(static_cast<std::uint64_t>(outcome.process));
        number(outcome.nearMemoryLimit ? 1 : 0);
        number(outcome.wasAlone ? 1 : 0);
        text(outcome.answer);
        text(toText(outcome.lost));
        text(event.text);
    }
    std::string take() { return std::move(bytes_); }

  private:
    std::string bytes_;
};

/// What is beyond the end is zero.
class Reader {
  public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}
    std::uint64_t number() {
        std::uint64_t value = 0;
        const std::string_view part = take(sizeof value);
        if (part.size() == sizeof value) std::memcpy(&value, part.data(), sizeof value);
        return value;
    }
    std::string text() { return std::string(take(number())); }
    WorkerEvent event() {
        WorkerEvent event;
        Outcome& outcome = event.outcome;
        event.kind = static_cast<WorkerEvent::Kind>(number());
        event.index = number();
        outcome.end = static_cast<Outcome::End>(number());
        outcome.signal = static_cast<int>(number());
        outcome.process = static_cast<int>(number());
        outcome.nearMemoryLimit = number() != 0;
        outcome.wasAlone = number() != 0;
        outcome.answer = text();
        outcome.lost = parseDeviceLost(text()).value_or(DeviceLost());
        event.text = text();
        return event;
    }
    [[nodiscard]] bool isAtEnd() const { return bytes_.empty(); }

  private:
    std::string_view take(std::uint64_t count) {
        const std::string_view part = bytes_.substr(0, std::min<std::uint64_t>(count, bytes_.size()));
        bytes_.remove_prefix(part.size());
        return part;
    }
    std::string_view bytes_;
};

}  // namespace

std::uint64_t numberOfCall(std::string_view place, std::size_t times) {
    return combined(fnv1a(place), times);
}

std::string toBytes(const WorkerCalls& calls) {
    Writer content;
    for (const auto& [number, events] : calls) {
        content.number(number);
        content.number(events.size());
        for (const WorkerEvent& each : events) content.event(each);
    }
    Writer all;
    all.text(content.take());
    return all.take();
}

WorkerCalls receiveCalls(const system::File& pipe) {
    std::uint64_t size = 0;
    if (!receiveAll(pipe, std::as_writable_bytes(std::span(&size, 1))) || size > kMostBytes) return {};
    std::string bytes(size, '\0');
    if (!receiveAll(pipe, std::as_writable_bytes(std::span(bytes)))) return {};
    WorkerCalls calls;
    for (Reader reader(bytes); !reader.isAtEnd();) {
        std::vector<WorkerEvent>& events = calls[reader.number()];
        for (std::uint64_t left = reader.number(); left > 0 && !reader.isAtEnd(); --left)
            events.push_back(reader.event());
    }
    return calls;
}

}  // namespace glibra::base
