#pragma once
// The entry of a word in the reference: of a command or statement, of a function or variable of GLSL, or of a
// name that scenes or shaders have.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "editor/completion.h"
#include "glsl/types/stage.h"

namespace glibra::editor {

/// T stands for float and vectors of floats, I for int, uint and vectors of them, S for any type of sampler,
/// G for any type of image, and P for the coordinates that the sampler or image takes.
struct GlslRow {
    std::string_view name;
    std::string_view signature;
    std::string_view summary;
    int since = 110;           ///< the first #version that has it
    std::string_view where{};  ///< letters of stages: v c e g f k (compute); empty: all
    int until = 1000;          ///< the first #version that has it no more
};

/// All rows, grouped by subject.
std::span<const GlslRow> glslTable();

/// The row of that name; null if there is none.
const GlslRow* findGlsl(std::string_view name);

/// True if shaders of that stage have the row.
bool isIn(const GlslRow& row, glsl::Stage stage);
/// True if the keyword has a meaning in shaders of that stage: "discard" in the fragment stage alone.
bool isKeywordIn(std::string_view keyword, glsl::Stage stage);

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
