#pragma once
// Moves between the tokens as they are written, so that a rule also works inside the body of a macro. The
// neighbours of a token on a preprocessor line are on that line; those of other tokens are not on such lines.

#include <string_view>
#include <vector>

#include "glsl/parse/unit.h"

namespace glibra::glsl {

class TokenWalk {
  public:
    explicit TokenWalk(const Unit& unit);

    /// The significant token after or before `token`, or kNone.
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
