#pragma once
// What a linked program reads, as plain values without GL. `gpu` fills them from the driver's reflection and
// uses them to set uniforms; `plan` uses them to interpret a scene's values.

#include <optional>
#include <string>
#include <vector>

namespace glibra::base {

/// `other`: atomic counters, and types that this table does not know.
enum class BaseType { floating, doublePrecision, integer, unsignedInteger, boolean, sampler, image, other };

/// The kind of texture that a scene can fill. Only textures with a name are arrays.
enum class TextureTarget {
    texture1D,
    texture2D,
    texture3D,
    cube,
    texture1DArray,
    texture2DArray,
    cubeArray,
    rectangle  ///< 2D without levels, read by texel coordinates
};

/// A GLSL type: columns x rows of the base type. Vectors have one column; scalars have one row as well.
struct ValueType {
    BaseType base = BaseType::floating;
    int columns = 1;
    int rows = 1;
    /// The target that a sampler or image reads of a unit. Nothing for what no unit holds: arrays,
    /// rectangles, samples, buffers.
    std::optional<TextureTarget> target{};
    std::string word{};  ///< the GLSL word, for messages: "vec3", "sampler2D"; empty for an unknown type

    [[nodiscard]] int components() const { return columns * rows; }
    /// Samplers and images hold the number of a unit.
    [[nodiscard]] bool isOpaque() const { return base == BaseType::sampler || base == BaseType::image; }
    [[nodiscard]] bool isInteger() const {
        return base == BaseType::integer || base == BaseType::unsignedInteger;
    }
};

/// An active uniform. An array of a basic type is one uniform, named without its [0]; each member of a
/// structure is a uniform of its own: "lights[1].position".
struct ActiveUniform {
    std::string name;  ///< as the user wrote it; right after reflection the same as `emittedName`
    ValueType type{};
    int arraySize = 1;  ///< elements up to the last active one
    bool isArray = false;
    int location = -1;  ///< of element 0, element i has location + i; -1 in a uniform block
    int block = -1;     ///< index into ActiveResources::blocks, with the layout below; -1 outside blocks
    std::string blockName{};
    int offset = 0, arrayStride = 0, matrixStride = 0;  ///< bytes
    bool rowMajor = false;
    std::string emittedName{};  ///< in the compiled source, which the translator may have changed
};

/// An active vertex input.
struct ActiveInput {
    std::string name;  ///< in the compiled source: "aVertex", "glibra_Vertex"
    int location = -1;
    ValueType type{};
    int arraySize = 1;
};

/// A colour output of the fragment stage. Its elements, if it is an array, have consecutive locations.
struct ActiveOutput {
    std::string name;  ///< in the compiled source
    int location = -1;
    ValueType type{};
    int arraySize = 1;
};

struct UniformBlock {
    std::string name;    ///< of the block, not of its instance; "Lights[2]" for an array of blocks
    int bytes = 0;       ///< size of the buffer that it needs
    unsigned index = 0;  ///< for glUniformBlockBinding
};

/// A member of a storage block: a scalar, vector or matrix, or an array of them. The elements of an array of
/// structures that is itself a member of the block are listed once, for element 0.
struct StorageMember {
    std::string name;  ///< as linked: "Particles.all[0].velocity"
    ValueType type{};
    int offset = 0;                      ///< bytes
    int arraySize = 1, arrayStride = 0;  ///< 0 elements: runtime-sized
    int outerSize = 1, outerStride = 0;  ///< of the block's member that it is part of
    int matrixStride = 0;
    bool rowMajor = false;
};

struct StorageBlock {
    std::string name;    ///< as UniformBlock
    int bytes = 0;       ///< the least size of its buffer; a runtime-sized array counts one element
    unsigned index = 0;  ///< for glShaderStorageBlockBinding
    std::vector<StorageMember> members;
};

/// Atomic counters that share a binding point.
struct CounterBuffer {
    int binding = 0;
    int bytes = 0;
    std::vector<std::string> counters;  ///< names
};

/// Everything that a linked program reads, and where it writes colours.
struct ActiveResources {
    std::vector<ActiveUniform> uniforms;
    std::vector<UniformBlock> blocks;
    std::vector<StorageBlock> storageBlocks;  ///< empty below GL 4.3; likewise counterBuffers
    std::vector<CounterBuffer> counterBuffers;
    std::vector<ActiveInput> inputs;    ///< of the vertex stage, without gl_VertexID and other built-ins
    std::vector<ActiveOutput> outputs;  ///< without gl_FragDepth and other built-ins; empty below GL 4.3
};

}  // namespace glibra::base
