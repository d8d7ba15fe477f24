#include "gpu/object/reflection.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/format/value_type.h"

namespace glibra::gpu {
namespace {

GLint parameter(GLuint program, GLenum what) {
    GLint value = 0;
    glGetProgramiv(program, what, &value);
    return value;
}

/// Room for the longest name. Some drivers count it without the terminating zero.
std::string nameBuffer(GLint longest) {
    return std::string(static_cast<std::size_t>(std::max(longest, 1)) + 1, '\0');
}

bool endsInSubscript(std::string_view name) {
    return name.ends_with("[0]");
}

std::string withoutSubscript(std::string name) {
    if (endsInSubscript(name)) name.resize(name.size() - 3);
    return name;
}

std::vector<GLint> layout(GLuint program, const std::vector<GLuint>& indices, GLenum what) {
    std::vector<GLint> values(indices.size());
    if (!indices.empty())
        glGetActiveUniformsiv(program, static_cast<GLsizei>(indices.size()), indices.data(), what,
                              values.data());
    return values;
}

std::vector<base::ActiveUniform> uniformsOf(GLuint program) {
    const GLint count = parameter(program, GL_ACTIVE_UNIFORMS);
    std::string buffer = nameBuffer(parameter(program, GL_ACTIVE_UNIFORM_MAX_LENGTH));
    std::vector<GLuint> indices(static_cast<std::size_t>(std::max(count, 0)));
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<GLuint>(i);
    const std::vector<GLint> blocks = layout(program, indices, GL_UNIFORM_BLOCK_INDEX);
    const std::vector<GLint> offsets = layout(program, indices, GL_UNIFORM_OFFSET);
    const std::vector<GLint> arrayStrides = layout(program, indices, GL_UNIFORM_ARRAY_STRIDE);
    const std::vector<GLint> matrixStrides = layout(program, indices, GL_UNIFORM_MATRIX_STRIDE);
    const std::vector<GLint> rowMajor = layout(program, indices, GL_UNIFORM_IS_ROW_MAJOR);

    std::vector<base::ActiveUniform> uniforms;
    for (const GLuint index : indices) {
        GLsizei length = 0;
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, index, static_cast<GLsizei>(buffer.size()), &length, &size, &type,
                           buffer.data());
        const std::string name(buffer.data(), static_cast<std::size_t>(length));
        base::ActiveUniform uniform;
        uniform.name = withoutSubscript(name);
        uniform.emittedName = uniform.name;
        uniform.type = valueType(type);
        // Some drivers leave the subscript out. Only the subscript shows that one element is an array.
        uniform.isArray = size > 1 || endsInSubscript(name);
        uniform.arraySize = size;
        uniform.block = blocks[index];
        if (uniform.block >= 0) {
            uniform.offset = offsets[index];
            uniform.arrayStride = arrayStrides[index];
            uniform.matrixStride = matrixStrides[index];
            uniform.rowMajor = rowMajor[index] != 0;
        } else {
            uniform.location = glGetUniformLocation(program, name.c_str());
        }
        uniforms.push_back(std::move(uniform));
    }
    return uniforms;
}

std::vector<base::UniformBlock> blocksOf(GLuint program) {
    const GLint count = parameter(program, GL_ACTIVE_UNIFORM_BLOCKS);
    std::string buffer = nameBuffer(parameter(program, GL_ACTIVE_UNIFORM_BLOCK_MAX_NAME_LENGTH));
    std::vector<base::UniformBlock> blocks;
    for (GLuint index = 0; index < static_cast<GLuint>(std::max(count, 0)); ++index) {
        base::UniformBlock block;
        GLsizei length = 0;
        glGetActiveUniformBlockName(program, index, static_cast<GLsizei>(buffer.size()), &length,
                                    buffer.data());
        block.name.assign(buffer.data(), static_cast<std::size_t>(length));
        block.index = index;
        glGetActiveUniformBlockiv(program, index, GL_UNIFORM_BLOCK_DATA_SIZE, &block.bytes);
        blocks.push_back(std::move(block));
    }
    return blocks;
}

std::vector<base::ActiveInput> inputsOf(GLuint program) {
    const GLint count = parameter(program, GL_ACTIVE_ATTRIBUTES);
    std::string buffer = nameBuffer(parameter(program, GL_ACTIVE_ATTRIBUTE_MAX_LENGTH));
    std::vector<base::ActiveInput> inputs;
    for (GLuint index = 0; index < static_cast<GLuint>(std::max(count, 0)); ++index) {
        GLsizei length = 0;
        GLint size = 0;
        GLenum type = 0;
        glGetActiveAttrib(program, index, static_cast<GLsizei>(buffer.size()), &length, &size, &type,
                          buffer.data());
        const std::string name(buffer.data(), static_cast<std::size_t>(length));
        if (name.starts_with("gl_")) continue;
        inputs.push_back(
            {withoutSubscript(name), glGetAttribLocation(program, name.c_str()), valueType(type), size});
    }
    return inputs;
}

}  // namespace

base::ActiveResources reflect(const Program& program) {
    base::ActiveResources resources;
    resources.uniforms = uniformsOf(program.id());
    resources.blocks = blocksOf(program.id());
    for (base::ActiveUniform& each : resources.uniforms)
        if (each.block >= 0) each.blockName = resources.blocks[static_cast<std::size_t>(each.block)].name;
    resources.inputs = inputsOf(program.id());
    return resources;
}

}  // namespace glibra::gpu
