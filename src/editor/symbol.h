#pragma once
// Where the name under the cursor is declared and used: in a shader, in the shaders that share its interface,
// in what they include, and in the scenes that set it.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "editor/completion.h"
#include "editor/text_range.h"

namespace glibra::editor {

/// A scene or shader as it stands in the editor.
struct SourceText {
    std::filesystem::path file;
    std::string text;
    CodeLanguage language = CodeLanguage::glsl;
    std::vector<std::filesystem::path> includes{};  ///< of a shader
    std::set<std::string> programs{};               ///< of a scene: those whose tags are meant
    bool hasNames = false;                          ///< of a scene: its variables and objects are meant
};

struct Occurrence {
    std::filesystem::path file;
    TextRange place;
    bool isDeclaration = false;
};

struct Symbol {
    std::string name;  ///< empty: there is none
    TextRange place;   ///< under the cursor
    std::vector<Occurrence> all;
    /// Where it is declared; of a call that overload. Nothing: it is not declared in these texts.
    std::optional<Occurrence> declaration;
    CodeLanguage language = CodeLanguage::glsl;
    /// The name that texts share which mean the same: that of a member is its structure or block. Empty: no
    /// other text does.
    std::string link{};
    std::optional<std::string> tagOf{};  ///< of a tag: SceneWord::program
    std::string obstacle{};              ///< why it cannot be renamed; empty: it can
};

/// The name that touches the byte of the first text, in all of the texts.
Symbol symbolAt(std::span<const SourceText> texts, std::size_t byte);

}  // namespace glibra::editor
