#pragma once
// Shader sources as sequences of tokens that stay the same when somebody renames, reformats or comments them.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/types/stage.h"

namespace glibra::classroom {

/// One token: what it is, and its line, counted from 1.
struct SourceToken {
    std::uint32_t code = 0;
    std::int32_t line = 1;
    std::uint32_t file = 0;  ///< that has the line: 0 is the SourceFile itself, others follow
    friend auto operator<=>(const SourceToken&, const SourceToken&) = default;
};

/// Tokens of a file that stand together.
struct SourceFile {
    std::string path;  ///< as messages name it
    std::vector<SourceToken> tokens;
    std::string place{};                ///< of the file, without links; empty if it is not known
    std::vector<std::string> others{};  ///< included in the middle, or the places of macros
    /// The file that has the line of a token.
    [[nodiscard]] const std::string& pathOf(const SourceToken& token) const {
        return token.file > 0 && token.file <= others.size() ? others[token.file - 1] : path;
    }
};

/// A file is read up to this number of tokens, and so are all files of a submission together. It is far more
/// than anybody writes, so that padding hides nothing behind it without being named.
inline constexpr std::size_t kMostTokens = 1'000'000;

/// The tokens of a GLSL text as it is written, at most `most`. Comments, blanks, preprocessor lines, and
/// global declarations of uniforms, inputs and outputs are left out, because the task gives them; the texts
/// of macros come last. All numbers have one code, and so have all names except those of types, keywords and
/// functions that the text does not define itself, which are the built-in ones. The code is in normal form
/// (normal_form.h), so the lines of neighbouring tokens may go back and forth.
std::vector<SourceToken> comparableTokens(std::string_view glsl, std::size_t most = kMostTokens);

/// A uniform variable, or block, as a text declares it.
struct DeclaredUniform {
    std::string name, type;  ///< of a block: its name, and "block"
    friend bool operator==(const DeclaredUniform&, const DeclaredUniform&) = default;
    friend auto operator<=>(const DeclaredUniform&, const DeclaredUniform&) = default;
};

/// The uniforms that a GLSL text declares, in its order; macros are not expanded.
std::vector<DeclaredUniform> declaredUniforms(std::string_view glsl);

/// "vertex", "tessellation control", ...
const char* stageName(glsl::Stage stage);

/// The names of its #include lines.
std::vector<std::string> includedNames(std::string_view glsl);

}  // namespace glibra::classroom
