#include "glsl/parse/walk.h"

namespace glibra::glsl {

TokenWalk::TokenWalk(const Unit& unit)
    : unit_(unit),
      next_(unit.tokens.size(), kNone),
      previous_(unit.tokens.size(), kNone),
      matches_(matchBrackets(unit.tokens, kNone)) {
    std::uint32_t last = kNone;
    for (std::uint32_t i = 0; i < unit.tokens.size(); ++i) {
        const Token& token = unit.tokens[i];
        if (!isSignificant(token.kind) || token.directive) continue;
        previous_[i] = last;
        if (last != kNone) next_[last] = i;
        last = i;
    }
}

}  // namespace glibra::glsl
