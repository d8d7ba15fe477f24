#pragma once
// Changes to a stage's tokens. A change never contains a line end, so the user's line structure stays.

#include <string>
#include <string_view>
#include <vector>

#include "glsl/read/token.h"

namespace glibra::glsl {

struct Edit {
    bool replaced = false;
    std::string text;    ///< in place of the token, if `replaced`
    std::string before;  ///< written before the token
    std::string after;   ///< written after the token
};

/// Edits of the tokens 0 ... n-1.
class Edits {
  public:
    void resize(std::size_t tokens) { index_.resize(tokens, -1); }

    void replace(std::uint32_t token, std::string text) {
        Edit& edit = of(token);
        edit.replaced = true;
        edit.text = std::move(text);
    }
    void remove(std::uint32_t token) { replace(token, {}); }
    /// Puts text before the token and before what is already there, so call it for the outermost text last.
    void before(std::uint32_t token, std::string_view text) { of(token).before.insert(0, text); }
    /// Puts text after the token and after what is already there.
    void after(std::uint32_t token, std::string_view text) { of(token).after += text; }

    /// The same inside of what is already there: for the smallest expression around a token.
    void rightBefore(std::uint32_t token, std::string_view text) { of(token).before += text; }
    void rightAfter(std::uint32_t token, std::string_view text) { of(token).after.insert(0, text); }

    /// The edit of a token, or null.
    [[nodiscard]] const Edit* find(std::uint32_t token) const {
        return index_[token] < 0 ? nullptr : &edits_[static_cast<std::size_t>(index_[token])];
    }

  private:
    Edit& of(std::uint32_t token) {
        if (index_[token] < 0) {
            index_[token] = static_cast<std::int32_t>(edits_.size());
            edits_.emplace_back();
        }
        return edits_[static_cast<std::size_t>(index_[token])];
    }

    std::vector<std::int32_t> index_;
    std::vector<Edit> edits_;
};

}  // namespace glibra::glsl
