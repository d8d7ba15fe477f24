#pragma once
// What a value as written means for a declared type: the two tables of the language, 5.3.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plan/uniforms.h"

namespace glibra::plan {

/// A value as a scene's pair or the command line gives it.
struct GivenValue {
    std::string_view tag;  ///< for messages
    glib::UniformForm form = glib::UniformForm::number;
    std::span<const double> values;  ///< as written; truth: 1 or 0
    Place tagPlace;
    Place valuePlace;
};

/// What it means. `values` are components, column by column, of one element or of all elements of an array,
/// already cut to integers, not negative for uint, 1 or 0 for bool; for samplers and images they are units.
struct Reading {
    bool ignored = false;  ///< the pair has no effect
    std::vector<double> values;
    std::optional<Control> control;  ///< without the uniform's index
    Diagnostics diagnostics;         ///< glib-W15, W17, W20, W21, W22, W27, E12
};

/// Reads a value for a uniform. `oneElement`: the tag named one element of an array, which is then read as a
/// scalar, vector, matrix or sampler would be.
Reading readValue(const GivenValue& given, const ActiveUniform& uniform, bool oneElement = false);

/// A number as messages show it: shortest form, without a zero before the point (".1", "-.25", "10").
std::string numberText(double value);

}  // namespace glibra::plan
