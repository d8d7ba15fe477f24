#pragma once
// Finds the end of a shader that stands in the script (language, 12.2).

#include <cstddef>
#include <string_view>

#include "glib/lexer.h"

namespace glibra::glib {

/// Where a shader ends that begins at the next line of a splitter.
struct ShaderBody {
    enum class End {
        itsWord,         ///< a line with the end word of its stage
        otherWord,       ///< a line with another end word, or a misspelt one
        otherStatement,  ///< a line that states another shader or a program
        missing          ///< the text ends first
    };
    End end = End::missing;
    std::size_t first = 0, last = 0;  ///< byte offsets of the text of the shader
    int firstLine = 1;                ///< the number of its first line
    LineRange line{};                 ///< that ends it
    std::string_view words{};         ///< of that line, without blanks at either end
    LineSplitter before;              ///< a splitter whose next line is that one
};

/// Reads lines up to the end of the shader. `stage` is the name of the stage, such as "Fragment". The lines
/// that end it are none that GLSL can have outside of comments.
ShaderBody readShaderBody(std::string_view text, LineSplitter& lines, std::string_view stage);

/// True for a line that is probably no line of a shader: it states another shader or a program.
bool endsShader(std::string_view line);

/// What the line says, without blanks at either end.
std::string_view trimmed(std::string_view line);

}  // namespace glibra::glib
