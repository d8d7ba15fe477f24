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
    /// Of a scene: the programs whose uniforms are meant. Nothing: all.
    std::optional<std::set<std::string>> programs{};
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
};

/// The name that touches the byte of the first text.
Symbol symbolAt(std::span<const SourceText> texts, std::size_t byte);

}  // namespace glibra::editor
