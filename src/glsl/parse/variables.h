#pragma once
// File-scope variables as rules change them. All rules work on these values; the tokens are changed once, at
// the end, so that several rules may meet in one declaration.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "glsl/parse/syntax.h"

namespace glibra::glsl {

struct Unit;

struct Variable {
    std::size_t declaration = 0;  ///< index into the syntax
    std::size_t declarator = 0;
    std::string name;             ///< the user's
    std::uint32_t nameToken = 0;  ///< view index

    Storage storage = Storage::none;
    std::string type;  ///< a word; empty for struct { ... }
    std::vector<std::string> typeSizes,
        nameSizes;  ///< texts in the brackets after the type and after the name
    std::string interpolation;
    std::vector<std::pair<std::string, std::string>> layout;  ///< name and value, or empty value
    bool patch = false, invariant = false, precise = false, centroid = false, sample = false,
         subroutine = false;
    std::vector<std::string> memory;
    std::string precision;

    bool changed = false;  ///< the head of its declaration has to be written anew
    bool removed = false;
    bool sizesChanged = false;
    bool dropInitializer = false;
    std::string initializer;  ///< " = ..." written behind the name, besides or instead of the user's
    std::string after;        ///< written behind the declaration's ';'

    [[nodiscard]] bool isArray() const { return !typeSizes.empty() || !nameSizes.empty(); }
    /// Sizes from the outermost to the innermost: those of the name come first.
    [[nodiscard]] std::vector<std::string> sizes() const;
    [[nodiscard]] const std::string* layoutValue(std::string_view key) const;
    void removeLayout(std::string_view key);
    void setLayout(std::string key, std::string value);
};

/// All variables of the unit's syntax.
std::vector<Variable> collectVariables(const Unit& unit);

/// Writes the changes into the unit's edits.
void renderVariables(Unit& unit);

/// "flat in" ... "vec3": qualifiers and type, in the order that all versions accept.
std::string headOf(const Variable& variable);

/// The tokens to edit for a range of view tokens: the user's own text, or the names of the macros without
/// parameters that brought it. False if an edit there would change other places as well.
bool editableTokens(const Unit& unit, Range range, std::vector<std::uint32_t>& tokens);

}  // namespace glibra::glsl
