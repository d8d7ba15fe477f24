#pragma once
// `--set NAME=VALUE` over a whole scene.

#include <span>
#include <string>
#include <vector>

#include "plan/uniforms.h"

namespace glibra::plan {

/// glib-W23 for each override that no program used; `names` are those of the uniforms there are, for the
/// suggestion. `used` has an element for each override.
Diagnostics unusedOverrides(std::span<const Override> overrides, const std::vector<bool>& used,
                            std::span<const std::string> names);

}  // namespace glibra::plan
