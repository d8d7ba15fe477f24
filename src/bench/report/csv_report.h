#pragma once

#include <string>

#include "bench/core/report.h"

namespace glibra::bench {

/// One row per point (RFC 4180, lines end with a line feed) after the header
/// subject,figure,curve,setting,label,error,error_unit,time_median_s,time_low_s,time_high_s,repeats,
/// memory_bytes,front,gpu_time_s.
/// Values that were not measured are empty; front is 0 or 1.
std::string csvReport(const Report& report);

}  // namespace glibra::bench
