#pragma once
// Types and values of expressions (language, 1.8).

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>

namespace glibra::expression {

/// A word is one of a list that the statement accepts, such as `front` and `back`. A record is a camera, a
/// texture or a buffer: it has fields and is not a value itself.
enum class Kind : std::uint8_t { number, boolean, word, record };

/// The type of a value: one component, a vector (one column), or a square matrix.
struct Type {
    Kind kind = Kind::number;
    std::uint8_t columns = 1;
    std::uint8_t rows = 1;

    static constexpr Type number() { return {}; }
    static constexpr Type boolean() { return {Kind::boolean, 1, 1}; }
    static constexpr Type word() { return {Kind::word, 1, 1}; }
    static constexpr Type record() { return {Kind::record, 1, 1}; }
    /// 1 to 4 components; 1 is a number or a boolean.
    static constexpr Type vector(std::size_t components, Kind kind = Kind::number) {
        return {kind, 1, static_cast<std::uint8_t>(components)};
    }
    /// 2 to 4 columns and as many rows.
    static constexpr Type matrix(std::size_t size) {
        return {Kind::number, static_cast<std::uint8_t>(size), static_cast<std::uint8_t>(size)};
    }

    /// How many doubles a value has: 1 to 16.
    [[nodiscard]] constexpr std::size_t size() const { return std::size_t{columns} * rows; }
    [[nodiscard]] constexpr bool isNumber() const { return *this == number(); }
    [[nodiscard]] constexpr bool isBoolean() const { return *this == boolean(); }
    [[nodiscard]] constexpr bool isMatrix() const { return columns > 1; }
    [[nodiscard]] constexpr bool isVector() const { return columns == 1 && rows > 1; }
    /// Has components that are numbers.
    [[nodiscard]] constexpr bool isNumeric() const { return kind == Kind::number; }

    friend constexpr bool operator==(const Type&, const Type&) = default;
};

/// "number", "bool", "vec3", "bvec2", "mat4", "word", "record".
std::string name(const Type& type);

/// A value that an expression has taken. Matrices are stored by columns; booleans are 0 and 1; a word is its
/// index in the list of words that the statement accepts.
struct Value {
    Type type;
    std::array<double, 16> components{};

    [[nodiscard]] double number() const { return components[0]; }
    [[nodiscard]] bool truth() const { return components[0] != 0; }
    [[nodiscard]] std::size_t word() const { return static_cast<std::size_t>(components[0]); }
    [[nodiscard]] glm::dvec3 vec3() const { return {components[0], components[1], components[2]}; }
    [[nodiscard]] glm::dmat4 mat4() const;
    /// As many doubles as the type has.
    [[nodiscard]] std::span<const double> all() const { return {components.data(), type.size()}; }

    friend bool operator==(const Value& a, const Value& b) {
        return a.type == b.type && a.components == b.components;
    }
};

}  // namespace glibra::expression
