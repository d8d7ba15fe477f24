#pragma once
// The words of programs and scenes by what they are, for colours.

#include <string_view>
#include <vector>

namespace glibra::view {

enum class Dialect { glsl, glib };
enum class Paint { plain, keyword, type, number, comment, directive, builtin };

/// A piece of a line, in bytes from its beginning.
struct Painted {
    std::size_t begin = 0, end = 0;
    Paint paint = Paint::plain;
};

/// The pieces of a line that are not plain, in order. `inComment` says whether a comment of several lines is
/// open at its beginning, and is then what holds for the next line.
std::vector<Painted> painted(std::string_view line, Dialect dialect, bool& inComment);

}  // namespace glibra::view
