#pragma once
// A run as JSON, to be stored and compared with later runs.

#include <glibra/result.h>

#include <string>
#include <string_view>

#include "bench/core/report.h"

namespace glibra::bench {

/// The whole report. An error that is not measurable is null, an infinite one the text "inf".
std::string jsonReport(const Report& report);

/// Reads the output of jsonReport and ignores unknown members. `file` is its name in messages. bench-E02: the
/// text is not JSON (with line and column), or not a run of the benchmarks (with what is wrong).
Result<Report> readJsonReport(std::string_view text, const std::string& file);

}  // namespace glibra::bench
