#pragma once
// What a worker tells its parent while it works on a piece: one line of text a message.

#include <optional>
#include <string>
#include <variant>

#include "suite/golden/hash_list.h"
#include "suite/results/results.h"
#include "suite/run/run.h"

namespace glibra::suite {

/// Which driver the worker has, once.
struct DriverIs {
    std::string words;
};
/// A shot is begun; its time begins.
struct Begins {
    ShotReference shot;
};
/// A shot is done.
struct Done {
    ShotReference shot;
    ShotResult result;
    std::optional<AcceptedHash> accepted;
};
using Message = std::variant<DriverIs, Begins, Done>;

std::string toText(const Message& message);
/// Nothing if it is no message: the worker is out of its mind.
std::optional<Message> parseMessage(const std::string& text);

}  // namespace glibra::suite
