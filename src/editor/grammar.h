#pragma once
// Grammars of the scene language for the syntax colours of editors, made from the tables of the language.

#include <string>
#include <string_view>
#include <vector>

namespace glibra::editor {

enum class GrammarEditor { vscode, vim, kate };

struct GrammarFile {
    std::string path;  ///< in the editor's folder: "syntax/glib.vim"
    std::string text;
};

/// The files that an editor needs; the first one is the grammar itself. `version` is that of the program.
std::vector<GrammarFile> grammarOf(GrammarEditor editor, std::string_view version);

}  // namespace glibra::editor
