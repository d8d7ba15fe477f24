#include "glsl/parse/walk.h"

namespace glibra::glsl {

TokenWalk::TokenWalk(const Unit& unit)
    : unit_(unit),
      next_(unit.tokens.size(), kNone),
      previous_(unit.tokens.size(), kNone),
      matches_(unit.tokens.size(), kNone) {
    // There are three sequences: compiled text, text that is not compiled, and the current preprocessor line.
    struct Sequence {
        std::uint32_t last = kNone;
        std::vector<std::uint32_t> open;
    };
    Sequence text, inactive, line;
    for (std::uint32_t i = 0; i < unit.tokens.size(); ++i) {
        const Token& token = unit.tokens[i];
        if (token.kind == TokenKind::newline) line = {};
        if (!isSignificant(token.kind)) continue;
        Sequence& own = token.directive ? line : (token.active ? text : inactive);
        previous_[i] = own.last;
        if (own.last != kNone) next_[own.last] = i;
        own.last = i;
        if (token.text.size() != 1) continue;
        const char c = token.text.front();
        if (c == '(' || c == '[' || c == '{') own.open.push_back(i);
        if ((c == ')' || c == ']' || c == '}') && !own.open.empty()) {
            matches_[i] = own.open.back();
            matches_[own.open.back()] = i;
            own.open.pop_back();
        }
    }
}

std::uint32_t TokenWalk::next(std::uint32_t token) const {
    return token == kNone ? kNone : next_[token];
}

std::uint32_t TokenWalk::previous(std::uint32_t token) const {
    return token == kNone ? kNone : previous_[token];
}

}  // namespace glibra::glsl
