#pragma once
// The lines of an emitted text.

#include <string_view>
#include <vector>

namespace glibra::glsl {

inline bool isLineNumber(std::string_view line) {
    return line.starts_with("#line ");
}

/// Without the characters that end them.
std::vector<std::string_view> textLines(std::string_view text);

}  // namespace glibra::glsl
