#pragma once
// Measures the chosen subjects one after the other.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bench/core/report.h"
#include "bench/core/subject.h"

namespace glibra::bench {

/// Called before each subject, with its index from 0 and the number of subjects.
using Progress = std::function<void(const Subject& subject, std::size_t index, std::size_t count)>;

/// If a subject fails, its errors are in SubjectRun::diagnostics, beside what it could measure; the other
/// subjects still run. Report::glibra stays empty.
Report run(std::span<const Subject* const> chosen, const BenchOptions& options, const Progress& progress);

/// Measures one thing that is not in the table of subjects.
Report runOne(const std::string& name, const std::string& title,
              const std::function<Result<std::vector<Figure>>(Bench&)>& measure, const BenchOptions& options);

/// True if a subject failed because no driver could be opened (gpu-E01).
bool lacksDriver(const Report& report);

}  // namespace glibra::bench
