#pragma once
// What VertexArray has to know of programs that GLSLProgram made.

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "classic/gl_functions.h"

namespace glibra::classic {

struct ProgramInput {
    GLuint location = 0;
    GLenum type = GL_FLOAT_VEC4;
};

struct LinkedProgram {
    std::uint64_t serial = 0;                                 ///< no two programs have the same one
    std::map<std::string, ProgramInput, std::less<>> inputs;  ///< by the user's name
    bool hasTessellation = false;
};

/// Notes a program of a context, and gives it its serial.
void remember(void* context, GLuint program, LinkedProgram facts);
void forget(void* context, GLuint program);
/// Null for a program that GLSLProgram did not make.
std::shared_ptr<const LinkedProgram> linkedProgram(void* context, GLuint program);

/// The name in a program of "aVertex", "aNormal", "aColor" and "aTexCoord0" to "aTexCoord7" as gstap.h has
/// it, of an input as a program has it ("glibra_Vertex"); other names stay.
std::string bookName(std::string_view emitted);

}  // namespace glibra::classic
