#pragma once
// Classifies the words of shaders and scenes, for syntax colours.

#include <string_view>
#include <vector>

#include "source/inline_shaders.h"

namespace glibra::source {

enum class CodeLanguage { glsl, glib };
enum class SyntaxKind { plain, keyword, type, number, comment, directive, builtin };

/// A piece of a line, as byte offsets in it.
struct SyntaxPiece {
    std::size_t begin = 0, end = 0;
    SyntaxKind kind = SyntaxKind::plain;
};

/// The pieces of a line that are not plain, in order. `inComment` is true if a comment over several lines is
/// open at the beginning of the line; it is updated for the next line.
std::vector<SyntaxPiece> syntaxOf(std::string_view line, CodeLanguage language, bool& inComment);

/// Reads the lines of a file in their order. Shaders in a scene have the pieces of shaders.
class SyntaxReader {
  public:
    explicit SyntaxReader(CodeLanguage language) : language_(language) {}
    /// The pieces of the next line that are not plain.
    std::vector<SyntaxPiece> next(std::string_view line);

  private:
    CodeLanguage language_;
    InlineShaders shaders_;
    bool inComment_ = false;
};

}  // namespace glibra::source
