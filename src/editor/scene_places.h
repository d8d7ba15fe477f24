#pragma once
// The places in the text of a scene that an editor shows: statements that declare something, colours, and
// names of files. The text may be incomplete or wrong.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/text_range.h"
#include "glib/statement_table.h"

namespace glibra::editor {

/// A statement that declares a name, or opens a block or shader.
struct Declaration {
    std::string name;  ///< "Lit"; of an unnamed block the word itself
    std::string word;  ///< the statement: "Program"
    TextRange whole;
    TextRange place;  ///< of the name
    bool isBlock = false;
};
std::vector<Declaration> declarationsOf(std::string_view scene);

/// A name in the statements of a scene: of a variable, program, texture, group or uniform.
struct SceneWord {
    std::string name;
    TextRange place;
    bool isDeclaration = false;
    bool isTag = false;   ///< a name of shaders: a uniform, vertex input or constant that is set here
    std::string program;  ///< whose tag it is; empty: of all, as those of Set
    std::string owner;    ///< of a member on a tag: what stands before the point
    /// Of a parameter of `Let name(parameters) (...)`: where the statement begins, to which its name belongs.
    std::optional<std::size_t> function{};
};
/// All words that may be names, in the order of the text. Keys, files and texts in quotes are none.
std::vector<SceneWord> namesIn(std::string_view scene);

/// Three or four components that are written as plain numbers.
struct WrittenColor {
    TextRange place;  ///< with its braces, if it has them
    std::array<double, 4> components{0, 0, 0, 1};
};
std::vector<WrittenColor> colorsOf(std::string_view scene);

/// A colour as a scene writes it in place of `written`: "{.5 .25 0}", ".5 .25 0". Alpha is left out if it is
/// 1 and `written` has three components.
std::string colorText(const std::array<double, 4>& components, std::string_view written);

/// True for a statement whose quoted or last words are names of files.
bool takesFile(const glib::StatementRow& row);

/// A word of a scene that names a file: an argument of Vertex, Texture, Obj, Include and so on.
struct NamedFile {
    std::string name;
    TextRange place;
};
std::vector<NamedFile> filesIn(std::string_view scene);

/// The names of `#include` lines of a shader.
std::vector<NamedFile> includesIn(std::string_view shader);

}  // namespace glibra::editor
