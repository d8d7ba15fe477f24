#pragma once
// The table of the subjects of `glibra bench`: one row and one file per subject.

#include <span>

#include "bench/core/subject.h"

namespace glibra::bench {

/// All subjects, in the order of the report.
std::span<const Subject> subjects();

}  // namespace glibra::bench
