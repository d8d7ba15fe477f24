#pragma once
// The names of a shader, for completion, for the text under the mouse and for renaming: what it declares, and
// what each name in it means. The text may be incomplete or wrong. It is read without its preprocessor: all
// branches of #if count, macros are not expanded, and included files are not read.

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/text_range.h"

namespace glibra::editor {

struct DeclaredName {
    std::string name;
    std::string type;         ///< "vec3", "float[3]"; "macro", "struct", "block" for these
    std::string declaration;  ///< "uniform float uKa", "vec3 shade(vec3 n, float r)"
    std::string owner{};      ///< of a member: the name of its structure or block
    int line = 1;             ///< counted from 1
    bool isFunction = false;
    bool isInterface = false;  ///< a uniform, input or output
    bool isParameter = false;
    bool isMember = false;  ///< of a structure, or of a block with an instance name: after a '.'
    TextRange place{};      ///< of the name
    TextRange body{};       ///< of a function with its braces; empty for a prototype
    /// The byte where the scope of a local variable or parameter ends; nothing: the end of the file.
    std::optional<std::size_t> scopeEnd{};

    [[nodiscard]] bool isGlobal() const { return !scopeEnd && !isMember; }
};

inline constexpr std::size_t kNoName = std::numeric_limits<std::size_t>::max();

/// A name in the text, also in its declaration.
struct NameUse {
    TextRange place;
    std::size_t name = kNoName;    ///< the index of its declaration, the first one of a function's overloads;
                                   ///< kNoName: it is not declared in this text
    std::size_t target = kNoName;  ///< the same, but of a call the overload that is called, with its body
    bool isMember = false;         ///< after a '.'
};

struct ShaderNames {
    std::vector<DeclaredName> names;  ///< in the order of the text
    std::vector<NameUse> uses;        ///< likewise; keywords and built-in names are none

    /// The use that touches the byte, or null.
    [[nodiscard]] const NameUse* useAt(std::size_t byte) const;
};
ShaderNames namesOfShader(std::string_view glsl);

/// Its declarations: variables with locals and parameters, functions, structures, blocks, macros.
std::vector<DeclaredName> declaredNames(std::string_view glsl);

/// What may stand after a '.' whose byte is `point`, where `end` is the end of what stands there already: the
/// members of a structure or block, or the usual swizzles of a vector. Empty for other types.
std::vector<DeclaredName> membersAt(std::string_view glsl, std::size_t point, std::size_t end);

/// The number in the #version line; 110 without one.
int versionOf(std::string_view glsl);

}  // namespace glibra::editor
