#pragma once
// What a scene says about itself: its first comment, and its line in a table of scenes.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::source {

struct SceneHead {
    std::vector<std::string> rows;  ///< ids of exercises or listings that begin the comment: "SH030", "Gx9.4"
    /// The sentence after them, which may go on in the next lines. Of a scene that an exercise begins with it
    /// starts with "Exercise".
    std::string summary;
    std::vector<std::string> text;  ///< the whole comment without ids, a line each; empty lines part it
};

/// Reads the comment at the beginning of a scene. The text may be anything.
SceneHead headOf(std::string_view scene);

/// The last column of a table of scenes in Markdown, by the files that its first column links to:
/// "| [topic/name](topic/name.glib) | what it shows | Graphics Shaders, chapters 4 and 9 |". A "-" is left
/// out. The paths are normal ones: "a b.glib" of "./a%20b.glib".
std::map<std::string, std::string> chapterColumn(std::string_view table);

/// The single chapters that such a column names: "Graphics Shaders, chapter 4", "Graphics Shaders, chapter 9"
/// of "Graphics Shaders, chapters 4 and 9". Sources are separated by semicolons.
std::vector<std::string> chaptersIn(std::string_view column);

/// True if `a` stands before `b` in a list: names by letters, and numbers in them by their size.
bool isBefore(std::string_view a, std::string_view b);

}  // namespace glibra::source
