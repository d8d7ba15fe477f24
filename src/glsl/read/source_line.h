#pragma once
// One line of a source with a directive.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/read/token.h"

namespace glibra::glsl {

/// A line of a file, whose tokens have their places.
struct SourceLine {
    std::span<const Token> tokens;
    std::vector<const Token*> significant;

    /// The significant token number `i`: 0 is the '#' of a directive, 1 its name; empty past the end.
    [[nodiscard]] std::string_view word(std::size_t i) const {
        return i < significant.size() ? significant[i]->text : std::string_view{};
    }
    /// That token, or the last one.
    [[nodiscard]] const Token& token(std::size_t i) const {
        return *significant[i < significant.size() ? i : significant.size() - 1];
    }
    /// The text between the quotes or angle brackets of an #include, or the word in place of them; empty if
    /// there is none.
    [[nodiscard]] std::string includedName() const;
    /// The text of a directive in one line, without comments.
    [[nodiscard]] std::string joined() const;
};

}  // namespace glibra::glsl
