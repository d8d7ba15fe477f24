#include "gpu/reflection.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace glibra::gpu {
namespace {

GLint parameter(GLuint program, GLenum what) {
    GLint value = 0;
    glGetProgramiv(program, what, &value);
    return value;
}

/// Room for the longest name there is; drivers have been seen to count without the ending zero.
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

std::vector<ActiveUniform> uniformsOf(GLuint program) {
    const GLint count = parameter(program, GL_ACTIVE_UNIFORMS);
    std::string buffer = nameBuffer(parameter(program, GL_ACTIVE_UNIFORM_MAX_LENGTH));
    std::vector<GLuint> indices(static_cast<std::size_t>(std::max(count, 0)));
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<GLuint>(i);
    const std::vector<GLint> blocks = layout(program, indices, GL_UNIFORM_BLOCK_INDEX);
    const std::vector<GLint> offsets = layout(program, indices, GL_UNIFORM_OFFSET);
    const std::vector<GLint> arrayStrides = layout(program, indices, GL_UNIFORM_ARRAY_STRIDE);
    const std::vector<GLint> matrixStrides = layout(program, indices, GL_UNIFORM_MATRIX_STRIDE);
    const std::vector<GLint> rowMajor = layout(program, indices, GL_UNIFORM_IS_ROW_MAJOR);

    std::vector<ActiveUniform> uniforms;
    for (const GLuint index : indices) {
        GLsizei length = 0;
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, index, static_cast<GLsizei>(buffer.size()), &length, &size, &type,
                           buffer.data());
        const std::string name(buffer.data(), static_cast<std::size_t>(length));
        ActiveUniform uniform;
        uniform.name = withoutSubscript(name);
        uniform.type = valueType(type);
        // Some drivers leave the subscript out; an array of one element is told by its subscript only.
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

std::vector<UniformBlock> blocksOf(GLuint program) {
    const GLint count = parameter(program, GL_ACTIVE_UNIFORM_BLOCKS);
    std::string buffer = nameBuffer(parameter(program, GL_ACTIVE_UNIFORM_BLOCK_MAX_NAME_LENGTH));
    std::vector<UniformBlock> blocks;
    for (GLuint index = 0; index < static_cast<GLuint>(std::max(count, 0)); ++index) {
        UniformBlock block;
        GLsizei length = 0;
        glGetActiveUniformBlockName(program, index, static_cast<GLsizei>(buffer.size()), &length,
                                    buffer.data());
        block.name.assign(buffer.data(), static_cast<std::size_t>(length));
        block.index = index;
        glGetActiveUniformBlockiv(program, index, GL_UNIFORM_BLOCK_DATA_SIZE, &block.bytes);
        glGetActiveUniformBlockiv(program, index, GL_UNIFORM_BLOCK_BINDING, &block.binding);
        blocks.push_back(std::move(block));
    }
    return blocks;
}

std::vector<ActiveInput> inputsOf(GLuint program) {
    const GLint count = parameter(program, GL_ACTIVE_ATTRIBUTES);
    std::string buffer = nameBuffer(parameter(program, GL_ACTIVE_ATTRIBUTE_MAX_LENGTH));
    std::vector<ActiveInput> inputs;
    for (GLuint index = 0; index < static_cast<GLuint>(std::max(count, 0)); ++index) {
        GLsizei length = 0;
        GLint size = 0;
        GLenum type = 0;
        glGetActiveAttrib(program, index, static_cast<GLsizei>(buffer.size()), &length, &size, &type,
                          buffer.data());
        const std::string name(buffer.data(), static_cast<std::size_t>(length));
        if (name.starts_with("gl_")) continue;
        inputs.push_back(
            {withoutSubscript(name), valueType(type), size, glGetAttribLocation(program, name.c_str())});
    }
    return inputs;
}

std::string subroutineName(GLuint program, GLenum stage, GLuint index, std::string& buffer) {
    GLsizei length = 0;
    glGetActiveSubroutineName(program, stage, index, static_cast<GLsizei>(buffer.size()), &length,
                              buffer.data());
    return {buffer.data(), static_cast<std::size_t>(length)};
}

void addSubroutines(GLuint program, GLenum stage, std::vector<SubroutineUniform>& all) {
    GLint count = 0;
    GLint longest = 0;
    GLint longestFunction = 0;
    glGetProgramStageiv(program, stage, GL_ACTIVE_SUBROUTINE_UNIFORMS, &count);
    if (count <= 0) return;
    glGetProgramStageiv(program, stage, GL_ACTIVE_SUBROUTINE_UNIFORM_MAX_LENGTH, &longest);
    glGetProgramStageiv(program, stage, GL_ACTIVE_SUBROUTINE_MAX_LENGTH, &longestFunction);
    std::string buffer = nameBuffer(longest);
    std::string functionBuffer = nameBuffer(longestFunction);
    for (GLuint index = 0; index < static_cast<GLuint>(count); ++index) {
        GLsizei length = 0;
        glGetActiveSubroutineUniformName(program, stage, index, static_cast<GLsizei>(buffer.size()), &length,
                                         buffer.data());
        const std::string name(buffer.data(), static_cast<std::size_t>(length));
        SubroutineUniform uniform;
        uniform.stage = stage;
        uniform.name = withoutSubscript(name);
        uniform.location = glGetSubroutineUniformLocation(program, stage, name.c_str());
        glGetActiveSubroutineUniformiv(program, stage, index, GL_UNIFORM_SIZE, &uniform.arraySize);
        GLint functions = 0;
        glGetActiveSubroutineUniformiv(program, stage, index, GL_NUM_COMPATIBLE_SUBROUTINES, &functions);
        std::vector<GLint> compatible(static_cast<std::size_t>(std::max(functions, 0)));
        if (!compatible.empty())
            glGetActiveSubroutineUniformiv(program, stage, index, GL_COMPATIBLE_SUBROUTINES,
                                           compatible.data());
        for (const GLint each : compatible)
            uniform.functions.push_back(
                {subroutineName(program, stage, static_cast<GLuint>(each), functionBuffer),
                 static_cast<GLuint>(each)});
        all.push_back(std::move(uniform));
    }
}

}  // namespace

ProgramInterface reflect(const Program& program) {
    ProgramInterface interface;
    interface.uniforms = uniformsOf(program.id());
    interface.blocks = blocksOf(program.id());
    interface.inputs = inputsOf(program.id());
    for (const GLenum stage : {GL_VERTEX_SHADER, GL_TESS_CONTROL_SHADER, GL_TESS_EVALUATION_SHADER,
                               GL_GEOMETRY_SHADER, GL_FRAGMENT_SHADER})
        addSubroutines(program.id(), stage, interface.subroutines);
    return interface;
}

}  // namespace glibra::gpu
