#pragma once
// The names that a shader declares, for completion and for the text under the mouse. The text may be
// incomplete or wrong: this reads it word by word and skips what it does not know.

#include <string>
#include <string_view>
#include <vector>

namespace glibra::editor {

struct DeclaredName {
    std::string name;
    std::string type;         ///< "vec3", "float[3]"; "macro", "struct", "block" for these
    std::string declaration;  ///< "uniform float uKa", "vec3 shade(vec3 n, float r)"
    int line = 1;             ///< counted from 1
    bool isFunction = false;
    bool isInterface = false;  ///< a uniform, input or output
};

/// In the order of the text: variables with locals and parameters, functions, structures, blocks, macros.
std::vector<DeclaredName> declaredNames(std::string_view glsl);

/// The number in the #version line; 110 without one.
int versionOf(std::string_view glsl);

}  // namespace glibra::editor
