#include "glsl/parse/statements.h"

#include <algorithm>

namespace glibra::glsl {

bool Statements::isLoop(std::uint32_t at) const {
    if (unit_.view[at].kind != TokenKind::word) return false;
    if (text(at) == "do") return true;
    return (text(at) == "for" || text(at) == "while") && text(at + 1) == "(";
}

Range Statements::body(std::uint32_t at, std::uint32_t end) const {
    const std::uint32_t first = text(at) == "do" ? at + 1 : match(at + 1) + 1;
    return {first, this->end(first, end)};
}

std::uint32_t Statements::afterDo(std::uint32_t at, std::uint32_t end) const {
    const std::uint32_t word = body(at, end).end;
    const bool isWhole = text(word) == "while" && text(word + 1) == "(" && match(word + 1) < end;
    return isWhole ? match(word + 1) + 1 : std::max(word, at + 1);
}

std::uint32_t Statements::afterHead(std::uint32_t at, std::uint32_t end) const {
    const std::string_view word = text(at);
    if (word == "do") return at + 1;
    const bool isHead = word == "for" || word == "while" || word == "if" || word == "switch";
    return isHead && text(at + 1) == "(" && match(at + 1) < end ? match(at + 1) + 1 : at;
}

std::uint32_t Statements::end(std::uint32_t at, std::uint32_t end) const {
    const auto opens = [&](std::uint32_t i) { return text(i) == "(" || text(i) == "[" || text(i) == "{"; };
    while (at < end) {
        const std::uint32_t head = afterHead(at, end);
        if (head > at) {
            at = head;
            continue;
        }
        while (at < end && text(at) != ";" && text(at) != "{")
            at = opens(at) && match(at) < end ? match(at) + 1 : at + 1;
        at = at < end && text(at) == "{" && match(at) < end ? match(at) + 1 : std::min(at + 1, end);
        if (at >= end || text(at) != "else") break;
        ++at;
    }
    return std::min(at, end);
}

}  // namespace glibra::glsl
