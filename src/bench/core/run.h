#pragma once
// Measures the chosen subjects one after the other.

#include <functional>
#include <span>

#include "bench/core/report.h"
#include "bench/core/subject.h"

namespace glibra::bench {

/// True if the cost on a front is the median time, because every point with an error has one. Otherwise the
/// setting is the cost.
bool isTimed(const Figure& figure);

/// Sets Point::isOnFront: no alternative to the point is at least as cheap and as accurate, and better in one
/// of the two. Times are equally cheap if their spreads (25 to 75 %) overlap or they differ by less than 2 %,
/// so that a point that is only a little faster does not excuse a large error. A point without an error is
/// never on a front.
void markFront(Figure& figure);

/// Called before each subject, with its index from 0 and the number of subjects.
using Progress = std::function<void(const Subject& subject, std::size_t index, std::size_t count)>;

/// If a subject fails, its errors are in SubjectRun::diagnostics, beside what it could measure; the other
/// subjects still run. Report::glibra stays empty.
Report run(std::span<const Subject* const> chosen, const BenchOptions& options, const Progress& progress);

/// True if a subject failed because no driver could be opened (gpu-E01).
bool lacksDriver(const Report& report);

}  // namespace glibra::bench
