#pragma once
// The entry of a word in the reference: of a command or statement, of a function or variable of GLSL, or of a
// name that scenes or shaders have.

#include <string>
#include <string_view>
#include <vector>

#include "editor/completion.h"

namespace glibra::editor {

struct ReferenceEntry {
    std::string word;               ///< as the tables spell it; empty: there is no entry
    std::vector<std::string> code;  ///< signatures, usage, or the declaration
    std::string text;               ///< what it does or is
    std::string value;              ///< its current value; empty: it has none
    std::string chapter;            ///< where the reference says more: "docs/language.md, 3"; may be empty
};

/// The entry of the word at a byte of a text. What the text declares comes first, then the names of the
/// scene, then the language's own.
ReferenceEntry referenceAt(std::string_view text, std::size_t byte, const CodeContext& context);

/// The same without a text: the language's own words and the scene's names. An unknown word gives an entry
/// whose text says so, with the nearest word.
ReferenceEntry referenceOf(std::string_view word, CodeLanguage language, const CodeContext& context);

}  // namespace glibra::editor
