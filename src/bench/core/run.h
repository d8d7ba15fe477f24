#pragma once
// Measures chosen subjects one after the other.

#include <functional>
#include <span>

#include "bench/core/report.h"
#include "bench/core/subject.h"

namespace glibra::bench {

/// True if the cost of a front is the median time: every point with an error has one. Else it is the setting.
bool isTimed(const Figure& figure);

/// Sets Point::isOnFront: none of a point's alternatives is as cheap and as accurate and better in one of the
/// two. A point without an error is never on a front.
void markFront(Figure& figure);

/// Called before each subject: which, its place from 0, and how many there are.
using Progress = std::function<void(const Subject& subject, std::size_t index, std::size_t count)>;

/// A subject that fails has its errors in SubjectRun::diagnostics, and what it could measure all the same;
/// the others run. Report::glibra stays empty.
Report run(std::span<const Subject* const> chosen, const BenchOptions& options, const Progress& progress);

/// True if a subject failed for lack of a driver (gpu-E01).
bool lacksDriver(const Report& report);

}  // namespace glibra::bench
