#pragma once
// The names that a shader declares, for completion and for the text under the mouse. The text may be
// incomplete or wrong: this reads it word by word and skips what it does not know.

#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::editor {

/// A place of a shader's text; both count from 1, columns in bytes.
struct CodePlace {
    int line = 1, column = 1;
    friend auto operator<=>(const CodePlace&, const CodePlace&) = default;
};

struct DeclaredName {
    std::string name;
    std::string type;         ///< "vec3", "float[3]"; "macro", "struct", "block" for these
    std::string declaration;  ///< "uniform float uKa", "vec3 shade(vec3 n, float r)"
    int line = 1;             ///< counted from 1
    bool isFunction = false;
    bool isInterface = false;  ///< a uniform, input or output
    int column = 1;
    std::optional<CodePlace> scopeEnd{};  ///< of locals and parameters; nothing: the end of the file
    bool isMember = false;  ///< of a structure, or of a block with an instance name: after a '.'
};

/// In the order of the text: variables with locals and parameters, functions, structures, blocks, macros.
std::vector<DeclaredName> declaredNames(std::string_view glsl);

/// The declaration that a name at this place means; null if there is none. `isMember`: a '.' stands before
/// it.
const DeclaredName* declarationOf(const std::vector<DeclaredName>& all, std::string_view name, CodePlace at,
                                  bool isMember);

/// The number in the #version line; 110 without one.
int versionOf(std::string_view glsl);

}  // namespace glibra::editor
