#pragma once
// Measures subjects one after the other, each in a process of its own: one that crashes loses only itself.

#include <functional>
#include <span>

#include "bench/core/report.h"
#include "bench/core/subject.h"

namespace glibra::bench {

/// What a run tells its caller. Both may be empty.
struct Progress {
    /// Before each subject, with its index from 0 and the number of subjects.
    std::function<void(const Subject& subject, std::size_t index, std::size_t count)> begins{};
    /// After each subject: the report so far, whose last subject it is.
    std::function<void(const Report& report)> measured{};
};

/// If a subject fails, its errors are in SubjectRun::diagnostics, beside what it could measure; the other
/// subjects still run. bench-E04: it ended by a signal or an exception. In a process that has threads or has
/// loaded a graphics driver before, subjects are measured in that process. Report::glibra stays empty.
Report run(std::span<const Subject* const> chosen, const BenchOptions& options, const Progress& progress);

}  // namespace glibra::bench
