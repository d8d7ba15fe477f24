#pragma once
// Moves among the tokens as they are written, so that a rule also works inside the body of a macro. A token
// of a preprocessor line has its neighbours on that line; a token of the text has them in the text.

#include <string_view>
#include <vector>

#include "glsl/parse/unit.h"

namespace glibra::glsl {

class TokenWalk {
  public:
    explicit TokenWalk(const Unit& unit);

    /// The significant token behind or in front of `token`, or kNone.
    [[nodiscard]] std::uint32_t next(std::uint32_t token) const;
    [[nodiscard]] std::uint32_t previous(std::uint32_t token) const;
    /// The matching bracket, or kNone.
    [[nodiscard]] std::uint32_t match(std::uint32_t token) const { return matches_[token]; }
    [[nodiscard]] std::string_view text(std::uint32_t token) const {
        return token == kNone ? std::string_view{} : unit_.tokens[token].text;
    }

  private:
    const Unit& unit_;
    std::vector<std::uint32_t> next_, previous_, matches_;
};

}  // namespace glibra::glsl
