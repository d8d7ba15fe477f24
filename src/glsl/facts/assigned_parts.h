#pragma once
// The variables that assignment.h follows, part by part.

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// A variable that may lack its value, or some parts of it.
struct Unassigned {
    enum class Kind { local, outParameter, output };
    Kind kind = Kind::local;
    std::string name;                ///< as in an expression: "sum", "gl_FragData[1]", "made.color"
    std::string type;                ///< the type word
    std::vector<std::string> sizes;  ///< of an array
    /// View indices: of a local the last token of its declarator; of others the '{' after which a value can
    /// be given.
    std::uint32_t at = 0;
    std::uint32_t statementEnd = kNone;  ///< the ';' of a local that is declared in a statement of its own
};

/// A variable that is followed. Its parts are the components of a vector, the columns of a matrix, the
/// elements of an array, or the members of a structure; bit i stands for part i.
struct AssignedVariable {
    enum class Shape { whole, vector, indexed, structure };
    Unassigned is;  ///< what is reported if it may lack its value
    Shape shape = Shape::whole;
    int count = 1;                          ///< parts
    int elements = 0;                       ///< of an array of known size
    std::vector<std::string_view> members;  ///< of a structure
    bool lacks = false;                     ///< it may be read before it has a value
    bool isReported = false;

    [[nodiscard]] std::uint32_t all() const { return (1U << count) - 1U; }
};

/// What an expression names of a variable.
struct AssignedPart {
    std::uint32_t bits = 0;
    bool isExact = false;  ///< an assignment to it gives all of these parts their values
};

/// What is assigned at a place of a function. Variables beyond the end are not.
struct AssignedState {
    std::vector<std::uint32_t> sure{};   ///< by variable: the parts that every path has assigned
    std::vector<std::uint32_t> maybe{};  ///< that some path has assigned
    bool isDead = false;                 ///< no path leads here

    /// Joins another path to this place.
    void join(const AssignedState& other) {
        if (other.isDead) return;
        if (isDead) {
            *this = other;
            return;
        }
        const std::size_t size = std::max(sure.size(), other.sure.size());
        for (std::vector<std::uint32_t>* each : {&sure, &maybe}) each->resize(size);
        for (std::size_t i = 0; i < size; ++i) {
            const bool isKnown = i < other.sure.size();
            sure[i] &= isKnown ? other.sure[i] : 0U;
            maybe[i] |= isKnown ? other.maybe[i] : 0U;
        }
    }
};
/// Gives the variable its shape. `members`: of a structure, otherwise empty.
void shapeOf(AssignedVariable& variable, int arrayDepth, const std::vector<std::string_view>& members);

/// The part that the subscripts and members in `suffix`, after the name, select.
AssignedPart partOf(const Unit& unit, const AssignedVariable& variable, Range suffix);

/// "color.w", if only that part of a vector or structure is meant; the name otherwise.
std::string nameOfPart(const AssignedVariable& variable, std::uint32_t bits);

/// The names of the members of a structure or block.
std::vector<std::string_view> membersOf(const Unit& unit, const Declaration& declaration);

}  // namespace glibra::glsl
