#pragma once
// `--set NAME=VALUE` over a whole scene.

#include <span>
#include <string>
#include <vector>

#include "plan/uniforms.h"

namespace glibra::plan {

/// Returns glib-W23 for each override that no program used, or notAChoice() for a word. `names` are the names
/// of existing uniforms, for the suggestion. `used` has one element per override.
Diagnostics unusedOverrides(std::span<const Override> overrides, const std::vector<bool>& used,
                            std::span<const std::string> names);

}  // namespace glibra::plan
