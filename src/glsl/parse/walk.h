#pragma once
// Moves between the significant tokens of a stage. Preprocessor lines are passed over.

#include <string_view>
#include <vector>

#include "glsl/parse/unit.h"

namespace glibra::glsl {

class TokenWalk {
  public:
    explicit TokenWalk(const Unit& unit);

    /// The significant token after or before `token`, or kNone.
    [[nodiscard]] std::uint32_t next(std::uint32_t token) const {
        return token == kNone ? kNone : next_[token];
    }
    [[nodiscard]] std::uint32_t previous(std::uint32_t token) const {
        return token == kNone ? kNone : previous_[token];
    }
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
