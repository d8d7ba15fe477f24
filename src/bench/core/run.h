#pragma once
// Measures in this process.

#include <functional>
#include <string>
#include <vector>

#include "bench/core/bench.h"
#include "bench/core/report.h"

namespace glibra::bench {

/// A report with one subject. If it fails, its errors are in SubjectRun::diagnostics, beside what it could
/// measure. Report::glibra stays empty.
Report runOne(const std::string& name, const std::string& title,
              const std::function<Result<std::vector<Figure>>(Bench&)>& measure, const BenchOptions& options);

/// True if a subject failed because no driver could be opened (gpu-E01).
bool lacksDriver(const Report& report);

}  // namespace glibra::bench
