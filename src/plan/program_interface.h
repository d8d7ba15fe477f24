#pragma once
// What a linked program asks for, as plain values: the plan is made from these, without GL.

#include <string>
#include <vector>

#include "glsl/types/translated_program.h"
#include "scene/scene.h"

namespace glibra::plan {

enum class BaseType { floating, doublePrecision, integer, unsignedInteger, boolean, sampler, image, other };

/// A GLSL type: columns x rows of the base type; vectors have one column, scalars one row too.
struct ValueType {
    BaseType base = BaseType::floating;
    int columns = 1;
    int rows = 1;
    /// For samplers and images: the target they read, nothing for targets that scenes cannot fill (2DRect,
    /// arrays, buffers).
    std::optional<scene::TextureTarget> target;
    std::string word;  ///< GLSL word for messages: "vec3", "sampler2D"
    [[nodiscard]] int components() const { return columns * rows; }
};

/// An active uniform. Array elements count from `name[0]`, which is stored without the subscript.
struct ActiveUniform {
    std::string name;  ///< as the user wrote it
    ValueType type;
    int arraySize = 1;
    bool isArray = false;
    int location = -1;  ///< in the default block; -1 in a uniform block
    int block = -1;     ///< index of the uniform block, with the layout below in bytes
    std::string blockName;
    int offset = 0, arrayStride = 0, matrixStride = 0;
    bool rowMajor = false;
};
using UniformIndex = scene::Index<ActiveUniform>;

struct ActiveInput {
    std::string name;  ///< as emitted: "aVertex", "glibra_Vertex", the user's own
    int location = -1;
    bool integer = false;  ///< int or uint input
};

struct UniformBlock {
    std::string name;
    int size = 0;  ///< bytes
};

/// A program's face: what it reads, and the translator's facts about its stages.
struct ProgramInterface {
    std::vector<ActiveUniform> uniforms;
    std::vector<UniformBlock> blocks;
    std::vector<ActiveInput> inputs;
    glsl::TranslatedProgram
        facts;            ///< stages' sources may be empty; diagnostics of translating, compiling and linking
    bool usable = false;  ///< it linked; false: `facts.diagnostics` says why
    bool isBuiltin = false;  ///< glibra's own flat-colour program
};

}  // namespace glibra::plan
