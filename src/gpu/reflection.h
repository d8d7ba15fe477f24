#pragma once
// What a linked program reads. All queries are of GL 4.1.

#include <glad/gl.h>

#include <string>
#include <vector>

#include "gpu/program.h"
#include "gpu/value_type.h"

namespace glibra::gpu {

/// An active uniform. Arrays of basic types are one uniform; members of structures have their own:
/// "lights[1].position".
struct ActiveUniform {
    std::string name;  ///< without the [0] of an array
    ValueType type;
    bool isArray = false;
    int arraySize = 1;  ///< elements up to the last active one
    int location = -1;  ///< of element 0, element i has location + i; -1 in a block
    int block = -1;     ///< index into ProgramInterface::blocks, with the layout below
    int offset = 0, arrayStride = 0, matrixStride = 0;  ///< bytes
    bool rowMajor = false;
};

struct UniformBlock {
    std::string name;  ///< of the block, not of its instance; "Lights[2]" for an array of blocks
    GLuint index = 0;  ///< for glUniformBlockBinding
    int bytes = 0;     ///< size of the buffer it needs
    int binding = 0;
};

struct ActiveInput {
    std::string name;
    ValueType type;
    int arraySize = 1;
    int location = -1;
};

/// A subroutine uniform and the functions it may hold.
struct SubroutineUniform {
    GLenum stage = GL_VERTEX_SHADER;
    std::string name;  ///< without [0]
    int location = 0;
    int arraySize = 1;
    struct Function {
        std::string name;
        GLuint index = 0;
    };
    std::vector<Function> functions;
};

struct ProgramInterface {
    std::vector<ActiveUniform> uniforms;
    std::vector<UniformBlock> blocks;
    std::vector<ActiveInput> inputs;  ///< of the vertex stage, without gl_VertexID and its kin
    std::vector<SubroutineUniform> subroutines;
};

ProgramInterface reflect(const Program& program);

}  // namespace glibra::gpu
