#pragma once
// Finds the member of a structure or uniform block that a tag with points and subscripts names, as far as the
// text of the shaders declares it (language, 5.3).

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "glsl/types/memory_facts.h"

namespace glibra::plan {

/// What the text of the shaders says about a tag.
struct MemberSearch {
    bool isDeclared = false;   ///< the tag names a number, a vector, a matrix or an array of them
    std::string hint{};        ///< if it does not: what would be right, beginning with "; "; may be empty
    std::string suggestion{};  ///< the name that the hint proposes; may be empty
    int elements = 0;          ///< of an array that is declared with so many; else 0
};

/// Follows the parts of a tag as `lights[2].inner.position`. Nothing if it begins with no uniform variable of
/// a structure type, and with neither the name nor the instance of a uniform block.
std::optional<MemberSearch> searchMember(const glsl::MemoryFacts& memory, std::string_view tag);

/// What a uniform variable of a structure type holds, named as OpenGL names active uniforms:
/// "lights[1].position". An array of a basic type is one value.
struct MemberValue {
    std::string name;
    std::string_view type;
    bool isArray = false;
};

/// Calls `visit` for the values of the variable `root` in the order in which they are declared, until it
/// returns false. False, without a call, if `root` is no such variable, or if the text does not show how many
/// elements an array of structures has.
bool visitMembers(const glsl::MemoryFacts& memory, std::string_view root,
                  const std::function<bool(const MemberValue&)>& visit);

}  // namespace glibra::plan
