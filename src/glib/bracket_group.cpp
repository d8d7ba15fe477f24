#include "glib/bracket_group.h"

#include <fmt/format.h>

#include "glib/text.h"

namespace glibra::glib {
namespace {

/// True for words that can only be tags, and so end an unclosed group.
bool endsGroup(const Token& token) {
    if (token.kind == TokenKind::open || token.kind == TokenKind::quoted) return true;
    if (token.kind != TokenKind::word || token.truth()) return false;
    return isLetter(token.text.front()) || token.text.front() == '_';
}

}  // namespace

BracketGroup groupAt(std::span<const Token> tokens, std::size_t open) {
    BracketGroup group;
    group.first = open + 1;
    std::size_t at = group.first;
    while (at < tokens.size() && tokens[at].kind != TokenKind::close && !endsGroup(tokens[at])) ++at;
    group.last = group.next = at;
    group.end = GroupEnd::notClosed;
    if (at < tokens.size() && tokens[at].kind == TokenKind::close) {
        group.next = at + 1;
        group.end =
            bracketsMatch(tokens[open].text, tokens[at].text) ? GroupEnd::closed : GroupEnd::wrongBracket;
    }
    return group;
}

std::size_t valueEnd(std::span<const Token> tokens, std::size_t at) {
    return tokens[at].kind == TokenKind::open ? groupAt(tokens, at).next : at + 1;
}

bool readsAsPairs(std::span<const Token> tokens) {
    if (tokens.size() < 2 || !tokens[1].beginsValue()) return false;
    for (std::size_t at = 0; at < tokens.size();) {
        if (!tokens[at].isWord()) return false;
        ++at;
        if (at < tokens.size() && tokens[at].beginsValue()) at = valueEnd(tokens, at);
    }
    return true;
}

bool bracketsMatch(std::string_view open, std::string_view close) {
    constexpr std::string_view kOpening = "<[{(";
    constexpr std::string_view kClosing = ">]})";
    return kOpening.find(open) == kClosing.find(close);
}

void reportGroupEnd(std::span<const Token> tokens, std::size_t open, const BracketGroup& group,
                    MessageLog& log) {
    if (group.end == GroupEnd::wrongBracket)
        log.report("glib-W08", fmt::format("'{}' closed by '{}'", tokens[open].text, tokens[group.last].text),
                   tokens[group.last].position);
    if (group.end == GroupEnd::notClosed)
        log.report("glib-W09",
                   fmt::format("'{}' not closed; closed {}", tokens[open].text,
                               group.next < tokens.size() ? "before " + inQuotes(tokens[group.next].text)
                                                          : std::string("at the end of the statement")),
                   tokens[open].position);
}

}  // namespace glibra::glib
