#pragma once
// `--set NAME=VALUE` over a whole scene.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plan/uniforms.h"

namespace glibra::plan {

/// Returns glib-W23 for each override that no program used, or notAChoice() for a word. `names` are the names
/// of existing uniforms, for the suggestion. `used` has one element per override.
Diagnostics unusedOverrides(std::span<const Override> overrides, const std::vector<bool>& used,
                            std::span<const std::string> names);

/// glib-W15 for a value of a variable of the scene with another number of components than the variable has;
/// the variable keeps its value.
Diagnostic misfit(std::string_view name, std::span<const double> values, std::size_t components);

}  // namespace glibra::plan
