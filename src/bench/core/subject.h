#pragma once
// The subjects of `glibra bench`: one file each, one row each in the table.

#include <glibra/result.h>

#include <span>
#include <string_view>
#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

struct Subject {
    std::string_view name;   ///< word of the command line: "primitives"
    std::string_view title;  ///< "Primitives: slices and stacks against the analytic surface"
    /// Figures in the order of the page. Errors: the driver, or a file of the library that is missing.
    Result<std::vector<Figure>> (*measure)(Bench& bench);
};

/// All subjects in the order of the page.
std::span<const Subject> subjects();

}  // namespace glibra::bench
