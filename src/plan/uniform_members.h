#pragma once
// Finds the member of a structure or uniform block that a tag with points and subscripts names, as far as the
// text of the shaders declares it (language, 5.3).

#include <optional>
#include <string>
#include <string_view>

#include "glsl/types/memory_facts.h"

namespace glibra::plan {

/// What the text of the shaders says about a tag.
struct MemberSearch {
    bool isDeclared = false;  ///< the tag names a number, a vector, a matrix or an array of them
    std::string hint{};       ///< if it does not: what would be right, beginning with "; "; may be empty
};

/// Follows the parts of a tag as `lights[2].inner.position`. Nothing if it begins with no uniform variable of
/// a structure type, and with neither the name nor the instance of a uniform block.
std::optional<MemberSearch> searchMember(const glsl::MemoryFacts& memory, std::string_view tag);

}  // namespace glibra::plan
