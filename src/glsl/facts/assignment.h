#pragma once
// Which variables of a stage may be read, or leave the stage, before they have a value. A variable counts as
// assigned where it is on every path (definite assignment; The Java Language Specification, chapter 16).
// Vectors, matrices, small arrays and structures are followed part by part.

#include <cstdint>
#include <string>
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

/// A place that reads what no path has assigned.
struct FirstRead {
    std::string name;  ///< "sum", "color.w"
    std::uint32_t at = 0;
};

struct Assignments {
    std::vector<Unassigned> variables;
    std::vector<FirstRead> reads;  ///< at most one per local variable
    /// Functions that return values, and whose end can be reached without a `return`.
    std::vector<const Declaration*> withoutReturn;
};

/// Looks at all functions of the stage. Call it after placeFragmentOutputs, where there are rules.
Assignments findUnassigned(const Unit& unit);

}  // namespace glibra::glsl
