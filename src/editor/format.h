#pragma once
// Formats the text of a scene. What the scene means does not change, and neither do its comments, its texts
// in quotes, its expressions and the shaders that stand in it. No line is added, removed, joined or split,
// except for empty ones at the end.

#include <string>
#include <string_view>

namespace glibra::editor {

/// Returns the text with
/// - 4 blanks before the statements of each block, up to the line that ends it;
/// - command words as the reference spells them;
/// - lines that continue a statement moved together with it, at least 4 blanks to its right;
/// - the backslashes of a statement in one column;
/// - a blank for each run of blanks that has a tab, and none at the ends of lines;
/// - a line end at its end.
/// Other blanks inside lines stay, since scenes show by them which numbers belong together. A statement with
/// an error of syntax stays as it is. A formatted text is its own formatted text. The text may hold any
/// bytes; one that would mean something else is returned as it is.
std::string formatted(std::string_view text);

/// True if both texts are scenes that mean the same: the same statements with the same arguments, in the same
/// lines, with the same messages.
bool meanTheSame(std::string_view a, std::string_view b);

}  // namespace glibra::editor
