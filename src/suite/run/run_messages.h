#pragma once
// Messages of a worker to its parent process during a piece: one line of text each.

#include <optional>
#include <string>
#include <variant>

#include "suite/golden/hash_list.h"
#include "suite/results/results.h"
#include "suite/suite.h"

namespace glibra::suite {

/// The driver of the worker; sent once.
struct DriverIs {
    std::string words;
    std::string key{};  ///< driverKey()
};
/// The worker begins a shot. Its time limit begins now.
struct Begins {
    ShotReference shot;
};
/// What a worker does with a shot, besides beginning it. Each of drawing and judging has the time limit of
/// its shot, so that the parent knows which of the shots of a worker is late.
struct Phase {
    enum class Kind : char {
        awaits = 'w',  ///< the thread that draws now waits until this shot is prepared, or goes on with it
        drawn = 'e',   ///< it is drawn and waits for its verdict
        judges = 'j',  ///< the thread that judges begins with it
        recalls = 'r'  ///< ... has ended without a verdict: the shot is rendered once more
    };
    Kind kind{};
    ShotReference shot;
};
/// A shot has a verdict.
struct Done {
    ShotReference shot;
    ShotResult result;
    std::optional<AcceptedHash> accepted;
};
using Message = std::variant<DriverIs, Begins, Phase, Done>;

std::string toText(const Message& message);
/// The message, or nothing if the text is not a message.
std::optional<Message> parseMessage(const std::string& text);

}  // namespace glibra::suite
