#pragma once
// Private to this folder: the values of a statement in the order of the text, and the names and tags that
// several of them make: `lights[2].position`.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glib/lexer.h"
#include "glib/messages.h"
#include "glib/script.h"

namespace glibra::glib {

/// A value, and whether it touches the one before it, as the brackets of slice[2] do.
struct Piece {
    Value value;
    bool isJoined = false;
};

/// Reads all tokens. `hasParameters`: () may follow the first one. Nothing if an error was reported:
/// glib-E15, E20, E31, E37.
std::optional<std::vector<Piece>> readPieces(std::span<const Token> tokens, MessageLog& log,
                                             bool hasParameters = false);

/// A word without quotes, or `true` and `false`.
bool isUnquoted(const Value& value);
/// True for a word that is an expression without its parentheses: `2*k`, `n/3`, `-k`.
bool looksLikeExpression(std::string_view word);
/// The expression without its parentheses that begins with the token: what touches it, and what stands in
/// parentheses that it opens, as `360*rand(k, 3)`.
std::string_view expressionAt(std::string_view text, std::span<const Token> tokens, const Token& first);

/// The text before its first point, and the text after it; nothing after it if there is no point.
std::string_view beforePoint(std::string_view text);
std::string_view afterPoint(std::string_view text);

/// True for identifiers with points between them; `hasHead`: a name stands before the text, which begins with
/// a point.
bool isDotted(std::string_view text, bool hasHead);

class Pieces {
  public:
    /// `text` is the whole scene, which the places of the values refer to.
    Pieces(std::string_view text, std::vector<Piece> pieces) : text_(text), pieces_(std::move(pieces)) {}

    [[nodiscard]] std::size_t size() const { return pieces_.size(); }
    [[nodiscard]] const Value& operator[](std::size_t at) const { return pieces_[at].value; }
    /// Null after the last value.
    [[nodiscard]] const Value* find(std::size_t at) const { return at < size() ? &(*this)[at] : nullptr; }
    /// True if the value touches the one before it; false after the last value.
    [[nodiscard]] bool isJoined(std::size_t at) const { return at < size() && pieces_[at].isJoined; }
    /// Gives a value away.
    [[nodiscard]] Value take(std::size_t at) { return std::move(pieces_[at].value); }

    /// True if a [k] or (k) touches the name before it.
    [[nodiscard]] bool isSubscript(std::size_t at) const;
    /// Returns the index after the name of an object; `at` if there is none.
    [[nodiscard]] std::size_t objectEnd(std::size_t at) const;
    /// Returns the index after a tag; `at` if there is none. A [k] belongs to the tag if a point or a value
    /// follows; otherwise it is the tag's value.
    [[nodiscard]] std::size_t tagEnd(std::size_t at) const;

    /// A value as it was written.
    [[nodiscard]] std::string_view source(const Value& value) const;
    /// The values from `begin` to `end`, without it, as they were written.
    [[nodiscard]] std::string written(std::size_t begin, std::size_t end) const;
    /// The same for a message: each line end with the space around it is one space.
    [[nodiscard]] std::string onOneLine(std::size_t begin, std::size_t end) const;
    /// What expressionAt() gives for tokens, on one line.
    [[nodiscard]] std::string expressionFrom(std::size_t at) const;
    /// The parts of the name that these values make.
    [[nodiscard]] std::vector<NamePart> pathOf(std::size_t begin, std::size_t end) const;
    /// That name as one value.
    [[nodiscard]] Value nameOf(std::size_t begin, std::size_t end) const;

  private:
    [[nodiscard]] bool valueFollows(std::size_t at) const;
    [[nodiscard]] Value indexOf(const Value& subscript) const;

    std::string_view text_;
    std::vector<Piece> pieces_;
};

}  // namespace glibra::glib
