#pragma once

#include <string>

#include "bench/core/report.h"
#include "bench/report/comparison.h"

namespace glibra::bench {

/// One page that needs no other file and no network: for each figure two diagrams (error against setting and
/// against time), its findings, and a table of all its points. With a comparison, the changes come first.
std::string htmlReport(const Report& report, const RunComparison* comparison = nullptr);

}  // namespace glibra::bench
