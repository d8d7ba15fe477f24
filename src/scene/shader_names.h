#pragma once
// The names that every shader may read without declaring them (glsl/types/builtins.h), as their authors write
// them.

#include <string>
#include <string_view>
#include <vector>

namespace glibra::scene {

/// Names of one value, and what it is.
struct ShaderName {
    std::vector<std::string> names;  ///< "uNormalMatrix", "gl_NormalMatrix"
    std::string_view type;           ///< GLSL type word
    bool isInput = false;            ///< a vertex input; otherwise a uniform
    std::string_view attribute{};    ///< of an input: of the mesh, or empty if it is constant
    std::string meaning;
};

/// All of them, in the order of the tables: uniforms, then inputs.
std::vector<ShaderName> shaderNames();

}  // namespace glibra::scene
