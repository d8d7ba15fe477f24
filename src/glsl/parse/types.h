#pragma once
// GLSL types as far as the translation has to infer them. A type that is not certain is `unknown`, and the
// rules leave such expressions alone.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::glsl {

enum class BaseType : std::uint8_t {
    unknown,
    voidType,
    floating,
    doublePrecision,
    integer,
    unsignedInteger,
    boolean,
    structure,
    opaque
};

struct Type {
    BaseType base = BaseType::unknown;
    std::uint8_t columns = 1;  ///< more than 1: a matrix
    std::uint8_t rows = 1;     ///< components of a vector or of a matrix column
    std::uint16_t arrayDepth = 0;
    std::int32_t structure = -1;  ///< index into the structures of the stage
    std::string_view word;        ///< of opaque types

    friend bool operator==(const Type&, const Type&) = default;

    [[nodiscard]] bool known() const { return base != BaseType::unknown; }
    /// True for a number or bool and for a vector or matrix of them, but not for an array.
    [[nodiscard]] bool numeric() const {
        return arrayDepth == 0 && base >= BaseType::floating && base <= BaseType::boolean;
    }
    [[nodiscard]] bool scalar() const { return numeric() && columns == 1 && rows == 1; }
    [[nodiscard]] bool vector() const { return numeric() && columns == 1 && rows > 1; }
    [[nodiscard]] bool matrix() const { return numeric() && columns > 1; }
    [[nodiscard]] bool integral() const {
        return base == BaseType::integer || base == BaseType::unsignedInteger;
    }
    [[nodiscard]] int components() const { return columns * rows; }
};

constexpr Type scalarType(BaseType base) {
    return {base, 1, 1, 0, -1, {}};
}
constexpr Type vectorType(BaseType base, int rows) {
    return {base, 1, static_cast<std::uint8_t>(rows), 0, -1, {}};
}

/// The type with that many dimensions more.
constexpr Type arrayOf(Type type, std::size_t dimensions) {
    type.arrayDepth = static_cast<std::uint16_t>(type.arrayDepth + dimensions);
    return type;
}

/// The type that a type word names; unknown for other words.
Type typeOfWord(std::string_view word);

/// The word of a scalar, vector or matrix type: "vec3".
std::string wordOf(const Type& type);

/// The type of a variable that the translator or GLSL supplies (gl_*, GSTAP names, Timer, ...); unknown for
/// other names.
Type typeOfSuppliedName(std::string_view name);

/// The type of `left op right` for + - * / % and comparisons.
Type binaryType(std::string_view op, const Type& left, const Type& right);

/// The type that a built-in function of any version returns.
Type callType(std::string_view function, std::span<const Type> arguments);

/// The names of GLSL's functions of the core profile, for suggestions.
std::vector<std::string_view> coreFunctions();

/// The zero of a numeric type: "0", "0.", "vec3(0.)", "false", "mat4(0.)"; empty for other types.
std::string zeroOf(std::string_view typeWord);

}  // namespace glibra::glsl
