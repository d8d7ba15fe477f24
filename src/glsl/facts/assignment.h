#pragma once
// Which variables of a stage may be read, or leave the stage, before they have a value. A variable counts as
// assigned where it is on every path (definite assignment; The Java Language Specification, chapter 16).
// Vectors, matrices, small arrays and structures are followed part by part.

#include <cstdint>
#include <string>
#include <vector>

#include "glsl/facts/assigned_parts.h"
#include "glsl/parse/unit.h"

namespace glibra::glsl {

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
