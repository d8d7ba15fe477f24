#include "gpu/object/uniform.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "base/number.h"

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

}  // namespace glibra::gpu
