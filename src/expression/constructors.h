#pragma once
// vec3(...), mat4(...), float(...) and the other constructors.

#include <span>
#include <string>
#include <string_view>

#include "expression/functions.h"

namespace glibra::expression {

/// What to do with the arguments of a constructor, or why it does not take them. `id` is that of the problem.
struct Construction {
    Call call;
    const char* id = nullptr;
    std::string why;
};
/// `name` is that of a row without apply().
Construction construct(std::string_view name, std::span<const Type> arguments);

}  // namespace glibra::expression
