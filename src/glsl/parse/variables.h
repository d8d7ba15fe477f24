#pragma once
// The variables at file scope as the rules change them. All rules work on these values, and the tokens are
// changed once at the end, so that several rules can change one declaration.

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
    std::string type;                    ///< a word; empty for struct { ... }
    std::vector<std::string> typeSizes;  ///< the texts in the brackets after the type
    std::vector<std::string> nameSizes;  ///< the texts in the brackets after the name
    std::string interpolation;
    std::vector<std::pair<std::string, std::string>> layout;  ///< names and values; a value may be empty
    bool patch = false, invariant = false, precise = false, centroid = false, sample = false,
         subroutine = false;
    std::vector<std::string> memory;
    std::string precision;

    bool changed = false;  ///< the head of its declaration has to be written again
    bool removed = false;
    bool sizesChanged = false;
    bool dropInitializer = false;
    std::string initializer;  ///< " = ..." to be written after the name
    std::string after;        ///< to be written after the declaration's ';'

    [[nodiscard]] bool isArray() const { return !typeSizes.empty() || !nameSizes.empty(); }
    /// Sizes from the outermost to the innermost. Those after the name come first.
    [[nodiscard]] std::vector<std::string> sizes() const;
    [[nodiscard]] const std::string* layoutValue(std::string_view key) const;
    void removeLayout(std::string_view key);
    void setLayout(std::string key, std::string value);
};

/// All variables at file scope.
std::vector<Variable> collectVariables(const Unit& unit);

/// Writes the changes into the unit's edits.
void renderVariables(Unit& unit);

/// Qualifiers and type, as in "flat in vec3", in the order that all versions accept.
std::string headOf(const Variable& variable);

/// A word as the emitted source spells it, except after a '.'.
std::string spelled(const Unit& unit, const std::string& word);

/// Gives the tokens to edit in order to change a range of view tokens: the user's own text, or the names of
/// the macros without parameters that expand to it. False if such an edit would change other places as well.
bool editableTokens(const Unit& unit, Range range, std::vector<std::uint32_t>& tokens);

}  // namespace glibra::glsl
