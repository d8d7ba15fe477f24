#pragma once
// #version lines and what they are taken for (language, 7.2).

#include <span>

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// Reads the words of a #version line (after `version`). Reports what is tolerated or refused.
Dialect readVersion(std::span<const std::string_view> words, const Place& place, int targetVersion,
                    Report& report);

}  // namespace glibra::glsl
