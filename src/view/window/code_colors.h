#pragma once
// Which parts of a program's text are shown in which colour.

#include <imgui.h>

#include <string_view>
#include <vector>

#include "view/window/code_editor.h"

namespace glibra::view {

enum class Paint { plain, keyword, type, number, comment, directive, builtin };

/// A piece of a line, in bytes from its beginning.
struct Painted {
    std::size_t begin = 0, end = 0;
    Paint paint = Paint::plain;
};

/// The pieces of a line that are not plain, in order. `inComment` says whether a comment of several lines is
/// open at its beginning, and is then what holds for the next line.
std::vector<Painted> painted(std::string_view line, Dialect dialect, bool& inComment);

/// For the theme in use.
ImU32 colorOf(Paint paint);

}  // namespace glibra::view
