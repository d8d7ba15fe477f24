#pragma once
// Changes to a stage's tokens. Line ends are never part of a change, so the line structure stays the user's.

#include <string>
#include <string_view>
#include <vector>

#include "glsl/read/token.h"

namespace glibra::glsl {

struct Edit {
    bool replaced = false;
    std::string text;    ///< instead of the token, if `replaced`
    std::string before;  ///< written in front of it
    std::string after;   ///< written behind it
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
    /// In front of what is already in front: the outermost comes last.
    void before(std::uint32_t token, std::string_view text) { of(token).before.insert(0, text); }
    /// Behind what is already behind.
    void after(std::uint32_t token, std::string_view text) { of(token).after += text; }

    /// The edit of a token, or null.
    [[nodiscard]] const Edit* find(std::uint32_t token) const {
        return index_[token] < 0 ? nullptr : &edits_[static_cast<std::size_t>(index_[token])];
    }
    /// True if the token is gone.
    [[nodiscard]] bool isRemoved(std::uint32_t token) const {
        const Edit* edit = find(token);
        return edit && edit->replaced && edit->text.empty();
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
