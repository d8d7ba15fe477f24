#pragma once
// From the tokens of a modern statement to its values.

#include <optional>
#include <span>
#include <vector>

#include "glib/lexer.h"
#include "glib/message_log.h"
#include "glib/value.h"

namespace glibra::glib {

/// A value, and whether it touches the one before it, as the brackets of slice[2] do.
struct Piece {
    Value value;
    bool isJoined = false;
};

/// Reads all tokens. Nothing if an error was reported: glib-E15, E20, E31, E37.
std::optional<std::vector<Piece>> readPieces(std::span<const Token> tokens, MessageLog& log);

}  // namespace glibra::glib
