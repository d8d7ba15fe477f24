#pragma once
// A run as JSON, to be kept and compared with.

#include <glibra/result.h>

#include <string>
#include <string_view>

#include "bench/core/report.h"

namespace glibra::bench {

/// Everything in the report. An error that is not measurable is null, an infinite one the text "inf".
std::string jsonReport(const Report& report);

/// Reads what jsonReport wrote; members it does not know are passed over. `file` is what messages call it.
/// bench-E02: no JSON (with line and column), or JSON that is no run of the bench (with what is wrong).
Result<Report> readJsonReport(std::string_view text, const std::string& file);

}  // namespace glibra::bench
