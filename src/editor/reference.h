#pragma once
// What an editor shows beside a word: its entry in the reference, and the arguments that are being written.

#include <string>
#include <string_view>
#include <vector>

#include "editor/completion.h"

namespace glibra::editor {

// The entry of a word in the reference: of a command or statement, of a function or variable of GLSL, or of a
// name that scenes or shaders have.

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
/// whose text says so, with the nearest word. `isArgument`: the word begins no statement of a scene.
ReferenceEntry referenceOf(std::string_view word, CodeLanguage language, const CodeContext& context,
                           bool isArgument = false);

// The arguments of the function or command that is being written.

/// A signature or usage, in three parts: before the argument that is being written, this argument, and what
/// comes after it. Without an argument everything stands in `before`.
struct SignatureParts {
    std::string before, argument, after;
};

struct CallHint {
    std::string word;  ///< of the function or command; empty: nothing is called at the cursor
    std::vector<SignatureParts> signatures;
};

/// What is called where the cursor stands: the innermost function whose parenthesis is open in a shader or an
/// expression, or else the command of a scene's line, after its word. Names without arguments give nothing.
CallHint callAt(std::string_view text, std::size_t cursor, const CodeContext& context);

}  // namespace glibra::editor
