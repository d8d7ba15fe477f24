#pragma once
// Messages of a worker to its parent process during a piece: one line of text each.

#include <optional>
#include <string>
#include <variant>

#include "suite/golden/hash_list.h"
#include "suite/results/results.h"
#include "suite/run/run.h"

namespace glibra::suite {

/// The driver of the worker; sent once.
struct DriverIs {
    std::string words;
};
/// The worker begins a shot. Its time limit begins now.
struct Begins {
    ShotReference shot;
};
/// A shot has a verdict.
struct Done {
    ShotReference shot;
    ShotResult result;
    std::optional<AcceptedHash> accepted;
};
using Message = std::variant<DriverIs, Begins, Done>;

std::string toText(const Message& message);
/// The message, or nothing if the text is not a message.
std::optional<Message> parseMessage(const std::string& text);

}  // namespace glibra::suite
