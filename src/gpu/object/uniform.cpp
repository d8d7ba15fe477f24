#include "gpu/object/uniform.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <numeric>
#include <string_view>
#include <utility>

#include "base/number.h"
#include "gpu/format/gl_names.h"

namespace glibra::gpu {
namespace {

/// The number of elements, from firstElement on, that the values fill.
int elementsFilled(const base::ActiveUniform& uniform, std::size_t valueCount, int firstElement) {
    if (uniform.type.base == base::BaseType::other || firstElement < 0 || firstElement >= uniform.arraySize)
        return 0;
    const std::size_t given = valueCount / static_cast<std::size_t>(uniform.type.components());
    const auto room = static_cast<std::size_t>(uniform.arraySize - firstElement);
    return static_cast<int>(std::min(given, room));
}

/// Values in the driver's type. Most uniforms fit `few_` and need no allocation.
template <class T>
class Converted {
  public:
    template <class Convert>
    Converted(std::span<const double> values, Convert convert) {
        T* to = few_.data();
        if (values.size() > few_.size()) {
            many_.resize(values.size());
            to = many_.data();
        }
        std::ranges::transform(values, to, convert);
    }
    [[nodiscard]] const T* data() const { return many_.empty() ? few_.data() : many_.data(); }

  private:
    std::array<T, 64> few_;
    std::vector<T> many_;
};

template <class T>
using SetVectors = void(GLAD_API_PTR*)(GLuint program, GLint location, GLsizei count, const T* values);
template <class T>
using SetMatrices = void(GLAD_API_PTR*)(GLuint program, GLint location, GLsizei count, GLboolean transpose,
                                        const T* values);

/// Sets uniforms of one base type. The functions are entries of GL's table, which may change.
template <class T>
struct UniformCalls {
    std::array<SetVectors<T>*, 4> vectors;                     ///< by rows, from 1 on
    std::array<std::array<SetMatrices<T>*, 3>, 3> matrices{};  ///< by columns and rows, from 2 on

    void operator()(GLuint program, const base::ValueType& type, GLint location, GLsizei count,
                    const T* values) const {
        const auto columns = static_cast<std::size_t>(type.columns),
                   rows = static_cast<std::size_t>(type.rows);
        if (columns > 1)
            (*matrices.at(columns - 2).at(rows - 2))(program, location, count, GL_FALSE, values);
        else
            (*vectors.at(rows - 1))(program, location, count, values);
    }
};

constexpr UniformCalls<GLfloat> kSetFloats{
    {&glProgramUniform1fv, &glProgramUniform2fv, &glProgramUniform3fv, &glProgramUniform4fv},
    {{{&glProgramUniformMatrix2fv, &glProgramUniformMatrix2x3fv, &glProgramUniformMatrix2x4fv},
      {&glProgramUniformMatrix3x2fv, &glProgramUniformMatrix3fv, &glProgramUniformMatrix3x4fv},
      {&glProgramUniformMatrix4x2fv, &glProgramUniformMatrix4x3fv, &glProgramUniformMatrix4fv}}}};
constexpr UniformCalls<GLdouble> kSetDoubles{
    {&glProgramUniform1dv, &glProgramUniform2dv, &glProgramUniform3dv, &glProgramUniform4dv},
    {{{&glProgramUniformMatrix2dv, &glProgramUniformMatrix2x3dv, &glProgramUniformMatrix2x4dv},
      {&glProgramUniformMatrix3x2dv, &glProgramUniformMatrix3dv, &glProgramUniformMatrix3x4dv},
      {&glProgramUniformMatrix4x2dv, &glProgramUniformMatrix4x3dv, &glProgramUniformMatrix4dv}}}};
constexpr UniformCalls<GLint> kSetInts{
    {&glProgramUniform1iv, &glProgramUniform2iv, &glProgramUniform3iv, &glProgramUniform4iv}};
constexpr UniformCalls<GLuint> kSetUnsigneds{
    {&glProgramUniform1uiv, &glProgramUniform2uiv, &glProgramUniform3uiv, &glProgramUniform4uiv}};

/// The bytes of one component in a block.
struct ComponentBytes {
    std::array<std::byte, 8> bytes{};
    std::size_t count = 4;
};

ComponentBytes componentBytes(base::BaseType base, double value) {
    ComponentBytes result;
    const auto store = [&](const auto& number) {
        result.count = sizeof number;
        std::memcpy(result.bytes.data(), &number, sizeof number);
    };
    switch (base) {
        case base::BaseType::floating:
            store(base::toFloat(value));
            break;
        case base::BaseType::doublePrecision:
            store(value);
            break;
        case base::BaseType::unsignedInteger:
            store(base::toUnsigned(value));
            break;
        case base::BaseType::boolean:
            store(static_cast<std::uint32_t>(value != 0 ? 1 : 0));
            break;
        default:
            store(base::toInt(value));
            break;
    }
    return result;
}

/// The offset in bytes of a component from the start of its element.
std::size_t componentOffset(const base::ActiveUniform& uniform, int column, int row, std::size_t size) {
    if (uniform.type.columns == 1) return static_cast<std::size_t>(row) * size;
    const auto stride = static_cast<std::size_t>(std::max(uniform.matrixStride, 0));
    const auto major = static_cast<std::size_t>(uniform.rowMajor ? row : column);
    const auto minor = static_cast<std::size_t>(uniform.rowMajor ? column : row);
    return major * stride + minor * size;
}

}  // namespace

int setUniform(const Program& program, const base::ActiveUniform& uniform, std::span<const double> values,
               int firstElement) {
    const int count = elementsFilled(uniform, values.size(), firstElement);
    if (count == 0 || uniform.location < 0) return 0;
    const std::span<const double> used =
        values.first(static_cast<std::size_t>(count) * static_cast<std::size_t>(uniform.type.components()));
    const GLint location = uniform.location + firstElement;
    // Calls the function with the values, unless the uniform has them.
    const auto upload = [&](const auto* numbers, const auto& set) {
        const auto bytes = std::as_bytes(std::span(numbers, used.size()));
        if (program.willHold(location, count, bytes))
            set(program.id(), uniform.type, location, count, numbers);
        return count;
    };
    switch (uniform.type.base) {
        case base::BaseType::floating:
            return upload(Converted<GLfloat>(used, base::toFloat).data(), kSetFloats);
        case base::BaseType::doublePrecision:
            return upload(used.data(), kSetDoubles);
        case base::BaseType::unsignedInteger:
            return upload(Converted<GLuint>(used, base::toUnsigned).data(), kSetUnsigneds);
        case base::BaseType::boolean: {
            const auto truth = [](double value) { return value != 0 ? 1 : 0; };
            return upload(Converted<GLint>(used, truth).data(), kSetInts);
        }
        case base::BaseType::other:
            return 0;
        case base::BaseType::integer:
        case base::BaseType::sampler:
        case base::BaseType::image:
            break;
    }
    return upload(Converted<GLint>(used, base::toInt).data(), kSetInts);
}

int writeBlockMember(std::span<std::byte> block, const base::ActiveUniform& uniform,
                     std::span<const double> values, int firstElement) {
    const int count = elementsFilled(uniform, values.size(), firstElement);
    if (uniform.block < 0 || uniform.offset < 0) return 0;
    std::size_t next = 0;
    for (int element = firstElement; element < firstElement + count; ++element) {
        const std::size_t start =
            static_cast<std::size_t>(uniform.offset) +
            static_cast<std::size_t>(element) * static_cast<std::size_t>(std::max(uniform.arrayStride, 0));
        for (int column = 0; column < uniform.type.columns; ++column)
            for (int row = 0; row < uniform.type.rows; ++row) {
                const ComponentBytes component = componentBytes(uniform.type.base, values[next++]);
                const std::size_t at = start + componentOffset(uniform, column, row, component.count);
                if (at + component.count > block.size()) continue;
                std::memcpy(block.data() + at, component.bytes.data(), component.count);
            }
    }
    return count;
}

std::vector<double> getUniform(const Program& program, const base::ActiveUniform& uniform, int element) {
    if (uniform.location < 0 || element < 0 || element >= uniform.arraySize) return {};
    const GLint location = uniform.location + element;
    const auto components = static_cast<std::size_t>(uniform.type.components());
    std::vector<double> values(components);
    const auto read = [&]<class T>(void(GLAD_API_PTR * get)(GLuint, GLint, T*)) {
        std::array<T, 16> given{};
        get(program.id(), location, given.data());
        std::copy_n(given.begin(), components, values.begin());
    };
    switch (uniform.type.base) {
        case base::BaseType::floating:
            read(glGetUniformfv);
            break;
        case base::BaseType::doublePrecision:
            read(glGetUniformdv);
            break;
        case base::BaseType::unsignedInteger:
            read(glGetUniformuiv);
            break;
        default:
            read(glGetUniformiv);
            break;
    }
    return values;
}

namespace {

GLint parameter(GLuint program, GLenum what) {
    GLint value = 0;
    glGetProgramiv(program, what, &value);
    return std::max(value, 0);
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
    std::string buffer = nameBuffer(parameter(program, GL_ACTIVE_UNIFORM_MAX_LENGTH));
    std::vector<GLuint> indices(static_cast<std::size_t>(parameter(program, GL_ACTIVE_UNIFORMS)));
    std::iota(indices.begin(), indices.end(), GLuint{0});
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
    const auto count = static_cast<GLuint>(parameter(program, GL_ACTIVE_UNIFORM_BLOCKS));
    std::string buffer = nameBuffer(parameter(program, GL_ACTIVE_UNIFORM_BLOCK_MAX_NAME_LENGTH));
    std::vector<base::UniformBlock> blocks;
    for (GLuint index = 0; index < count; ++index) {
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
    const auto count = static_cast<GLuint>(parameter(program, GL_ACTIVE_ATTRIBUTES));
    std::string buffer = nameBuffer(parameter(program, GL_ACTIVE_ATTRIBUTE_MAX_LENGTH));
    std::vector<base::ActiveInput> inputs;
    for (GLuint index = 0; index < count; ++index) {
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

// ---- GL 4.3: program interfaces

GLuint resourceCount(GLuint program, GLenum interface) {
    GLint count = 0;
    glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
    return static_cast<GLuint>(std::max(count, 0));
}

std::string resourceName(GLuint program, GLenum interface, GLuint index) {
    constexpr GLenum kLength = GL_NAME_LENGTH;
    GLint longest = 0;
    glGetProgramResourceiv(program, interface, index, 1, &kLength, 1, nullptr, &longest);
    std::string buffer = nameBuffer(longest);
    GLsizei length = 0;
    glGetProgramResourceName(program, interface, index, static_cast<GLsizei>(buffer.size()), &length,
                             buffer.data());
    buffer.resize(static_cast<std::size_t>(length));
    return buffer;
}

template <std::size_t N>
std::array<GLint, N> resource(GLuint program, GLenum interface, GLuint index,
                              const std::array<GLenum, N>& what) {
    std::array<GLint, N> values{};
    glGetProgramResourceiv(program, interface, index, static_cast<GLsizei>(N), what.data(),
                           static_cast<GLsizei>(N), nullptr, values.data());
    return values;
}

std::vector<GLint> activeVariables(GLuint program, GLenum interface, GLuint index, GLint count) {
    constexpr GLenum kVariables = GL_ACTIVE_VARIABLES;
    std::vector<GLint> variables(static_cast<std::size_t>(std::max(count, 0)));
    if (!variables.empty())
        glGetProgramResourceiv(program, interface, index, 1, &kVariables, count, nullptr, variables.data());
    return variables;
}

base::StorageMember memberOf(GLuint program, GLuint index) {
    const auto values =
        resource<8>(program, GL_BUFFER_VARIABLE, index,
                    {GL_TYPE, GL_OFFSET, GL_ARRAY_SIZE, GL_ARRAY_STRIDE, GL_TOP_LEVEL_ARRAY_SIZE,
                     GL_TOP_LEVEL_ARRAY_STRIDE, GL_MATRIX_STRIDE, GL_IS_ROW_MAJOR});
    base::StorageMember member;
    member.name = resourceName(program, GL_BUFFER_VARIABLE, index);
    member.type = valueType(static_cast<GLenum>(values[0]));
    member.offset = values[1];
    member.arraySize = values[2];
    member.arrayStride = values[3];
    member.outerSize = values[4];
    member.outerStride = values[5];
    member.matrixStride = values[6];
    member.rowMajor = values[7] != 0;
    return member;
}

std::vector<base::StorageBlock> storageBlocksOf(GLuint program) {
    const GLuint count = resourceCount(program, GL_SHADER_STORAGE_BLOCK);
    std::vector<base::StorageBlock> blocks;
    for (GLuint index = 0; index < count; ++index) {
        const auto [bytes, members] = resource<2>(program, GL_SHADER_STORAGE_BLOCK, index,
                                                  {GL_BUFFER_DATA_SIZE, GL_NUM_ACTIVE_VARIABLES});
        base::StorageBlock block{resourceName(program, GL_SHADER_STORAGE_BLOCK, index), bytes, index, {}};
        for (const GLint each : activeVariables(program, GL_SHADER_STORAGE_BLOCK, index, members))
            block.members.push_back(memberOf(program, static_cast<GLuint>(each)));
        blocks.push_back(std::move(block));
    }
    return blocks;
}

/// The last stage of a program without a fragment stage has outputs, too; nobody asks for those.
std::vector<base::ActiveOutput> outputsOf(GLuint program) {
    const GLuint count = resourceCount(program, GL_PROGRAM_OUTPUT);
    std::vector<base::ActiveOutput> outputs;
    for (GLuint index = 0; index < count; ++index) {
        const auto [location, type, size] =
            resource<3>(program, GL_PROGRAM_OUTPUT, index, {GL_LOCATION, GL_TYPE, GL_ARRAY_SIZE});
        std::string name = withoutSubscript(resourceName(program, GL_PROGRAM_OUTPUT, index));
        if (name.starts_with("gl_")) continue;
        outputs.push_back({std::move(name), location, valueType(static_cast<GLenum>(type)), size});
    }
    return outputs;
}

std::vector<base::CounterBuffer> counterBuffersOf(GLuint program) {
    const GLuint count = resourceCount(program, GL_ATOMIC_COUNTER_BUFFER);
    std::vector<base::CounterBuffer> buffers;
    for (GLuint index = 0; index < count; ++index) {
        const auto [binding, bytes, counters] =
            resource<3>(program, GL_ATOMIC_COUNTER_BUFFER, index,
                        {GL_BUFFER_BINDING, GL_BUFFER_DATA_SIZE, GL_NUM_ACTIVE_VARIABLES});
        base::CounterBuffer buffer{binding, bytes, {}};
        // In the order in which they lie in the buffer; drivers list them in orders of their own.
        std::vector<std::pair<GLint, std::string>> inOrder;
        for (const GLint each : activeVariables(program, GL_ATOMIC_COUNTER_BUFFER, index, counters)) {
            const auto counter = static_cast<GLuint>(each);
            const auto [offset] = resource<1>(program, GL_UNIFORM, counter, {GL_OFFSET});
            inOrder.emplace_back(offset, withoutSubscript(resourceName(program, GL_UNIFORM, counter)));
        }
        std::sort(inOrder.begin(), inOrder.end());
        for (auto& [offset, name] : inOrder) buffer.counters.push_back(std::move(name));
        buffers.push_back(std::move(buffer));
    }
    return buffers;
}

/// GL lists the members of an array of blocks once, as members of its first element (GL 4.6, 7.3.1). Gives
/// each element members of its own, with the element's subscript in their names.
void spreadBlockArrays(base::ActiveResources& resources) {
    const auto plainName = [](std::string_view block) { return block.substr(0, block.find('[')); };
    std::vector<base::ActiveUniform> spread;
    std::vector<bool> hasMembers(resources.blocks.size());
    for (const base::ActiveUniform& each : resources.uniforms)
        if (each.block >= 0) hasMembers[static_cast<std::size_t>(each.block)] = true;
    for (base::ActiveUniform& each : resources.uniforms) {
        const std::string plain(plainName(each.blockName));
        if (each.block < 0 || plain == each.blockName || !each.name.starts_with(plain + ".")) continue;
        const std::string member = each.name.substr(plain.size());
        const auto nameIn = [&](base::ActiveUniform& uniform, const std::string& block) {
            uniform.blockName = block;
            uniform.name = uniform.emittedName = block + member;
        };
        for (std::size_t i = 0; i < resources.blocks.size(); ++i) {
            if (hasMembers[i] || plainName(resources.blocks[i].name) != plain) continue;
            base::ActiveUniform& copy = spread.emplace_back(each);
            copy.block = static_cast<int>(i);
            nameIn(copy, resources.blocks[i].name);
        }
        nameIn(each, std::string(each.blockName));
    }
    resources.uniforms.insert(resources.uniforms.end(), std::make_move_iterator(spread.begin()),
                              std::make_move_iterator(spread.end()));
}

}  // namespace

base::ActiveResources reflect(const Program& program) {
    base::ActiveResources resources;
    resources.uniforms = uniformsOf(program.id());
    resources.blocks = blocksOf(program.id());
    for (base::ActiveUniform& each : resources.uniforms)
        if (each.block >= 0) each.blockName = resources.blocks[static_cast<std::size_t>(each.block)].name;
    spreadBlockArrays(resources);
    resources.inputs = inputsOf(program.id());
    if (GLAD_GL_VERSION_4_3 != 0) {
        resources.storageBlocks = storageBlocksOf(program.id());
        resources.counterBuffers = counterBuffersOf(program.id());
        resources.outputs = outputsOf(program.id());
        std::erase_if(resources.uniforms, [](const base::ActiveUniform& each) {
            return each.type.base == base::BaseType::other && each.location < 0 && each.block < 0;
        });
    }
    return resources;
}

int outputLocation(const Program& program, const std::string& name) {
    return glGetFragDataLocation(program.id(), name.c_str());
}

}  // namespace glibra::gpu
