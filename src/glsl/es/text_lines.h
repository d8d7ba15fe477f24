#pragma once
// The lines of an emitted text.

#include <string>
#include <string_view>
#include <vector>

namespace glibra::glsl {

inline bool isLineNumber(std::string_view line) {
    return line.starts_with("#line ");
}

/// Without the characters that end them.
std::vector<std::string_view> textLines(std::string_view text);

/// "#line 2000012 2" for "#line 12 1", if there is one source `before` those of the text (kLinesOfSource).
/// Numbers may stand in quotes, and may have got their source already. Directives without a source stay as
/// they are.
std::string withSource(std::string_view directive, int before);

}  // namespace glibra::glsl
