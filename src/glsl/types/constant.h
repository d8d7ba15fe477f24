#pragma once
// Values that a scene gives the constants of its shaders (language, 12.1).

#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::glsl {

/// A constant of a program: a macro of this name, or the value of the `const` variable or `#define` of that
/// name which a shader has.
struct Constant {
    std::string name;
    std::string type;  ///< a scalar, vector or square matrix of GLSL; empty: as the shader declares it
    bool isBoolean = false;
    std::vector<double> components;  ///< finite; of a matrix by columns; none: the value has an error

    friend auto operator<=>(const Constant&, const Constant&) = default;
};

/// The value as GLSL writes it for that type: "4", "(-.5)", "uvec2(1u, 2u)". Floating-point numbers have as
/// few digits as give the same double. Without a type it is a number whose type is int if it is whole, a
/// bool, a floating-point vector or matrix. Nothing if the type has another number of components, if it is an
/// integer and a component is no integer of 32 bits, or if it is no type of a constant.
std::optional<std::string> textOf(const Constant& constant, std::string_view type);

/// "4", "2.5", "(1, 0, 0)", "true": for messages.
std::string valueText(const Constant& constant);

}  // namespace glibra::glsl
