#pragma once
// The meaning of a written value for a declared type: the two tables of language, 5.3.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plan/program_variant.h"

namespace glibra::plan {

/// A value as a scene's tag or the command line gives it.
struct GivenValue {
    std::string_view tag;  ///< for messages
    glib::UniformForm form = glib::UniformForm::number;
    std::span<const double> values;  ///< as written; a truth value is 1 or 0
    Place tagPlace;
    Place valuePlace;
    std::string_view typed{};  ///< the value as the command line has it; empty for values of a scene
};

/// The meaning of a value. `values` are the components, column by column, of one element or of all elements
/// of an array. Integers are whole and limited to the type's range, a bool is 1 or 0, and samplers and
/// images have units.
struct Reading {
    bool ignored = false;  ///< the tag has no effect
    std::vector<double> values;
    std::optional<Control> control;  ///< without the uniform's index
    Diagnostics diagnostics;         ///< glib-E12, E31, W15, W17, W20, W21, W22, W27
};

/// Reads a value for a uniform. `oneElement`: the tag names one element of an array, which is then read like
/// a uniform that is not an array. `declaredElements`: of an array in the shader's text, since drivers leave
/// out the elements after the last one that is used; 0: not known.
Reading readValue(const GivenValue& given, const ActiveUniform& uniform, bool oneElement = false,
                  int declaredElements = 0);

/// A number as messages show it: in its shortest form, without a zero before the point (".1", "-.25", "10").
std::string numberText(double value);

}  // namespace glibra::plan
