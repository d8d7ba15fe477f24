#pragma once
// Runs of subjects: measured in a process of their own, and written as JSON to be compared with later runs.

#include <functional>
#include <span>

#include "bench/core/bench.h"

namespace glibra::bench {

struct Subject {
    std::string_view name;   ///< name on the command line: "primitives"
    std::string_view title;  ///< "Primitives: slices and stacks against the analytic surface"
    Bench::Measure measure;  ///< the figures in the order of the report; throws Failed
};

/// Members that are not known are empty or 0.
struct Machine {
    std::string processor;          ///< model name
    int cores = 0;                  ///< available to this process
    double memory = 0;              ///< bytes
    std::string system;             ///< "Linux 6.1.0-18-amd64 x86_64"
    std::string compiler;           ///< "GCC 12.2.0"
    std::string driver;             ///< how the OpenGL context was opened; empty: it was not
    std::string renderer, version;  ///< as the driver reports them
};

struct SubjectRun {
    std::string name;  ///< as in the table of subjects
    std::string title;
    double seconds = 0;  ///< duration of the measurement
    std::vector<Figure> figures{};
    Diagnostics diagnostics{};  ///< what could not be measured, and why
};

struct Report {
    std::string glibra;  ///< version
    std::string date;    ///< "2026-03-01T12:00:00Z", when the run began
    bool quick = false;
    Machine machine;
    std::vector<SubjectRun> subjects;
};

/// A report with one subject, measured in this process. If it fails, its errors are in
/// SubjectRun::diagnostics, beside what it could measure. Report::glibra stays empty.
Report runOne(const std::string& name, const std::string& title,
              const std::function<std::vector<Figure>(Bench&)>& measure, const BenchOptions& options);

/// The only curve of what is measured in a process whose driver filters bytes with byte arithmetic; nothing
/// on drivers other than llvmpipe, or if that process fails.
std::optional<std::vector<Point>> filteredInBytes(Bench& bench, Bench::Measure measure);

/// What a run tells its caller. Both may be empty.
struct Progress {
    /// Before each subject, with its index from 0 and the number of subjects.
    std::function<void(const Subject& subject, std::size_t index, std::size_t count)> begins{};
    /// After each subject: the report so far, whose last subject it is.
    std::function<void(const Report& report)> measured{};
};

/// Measures subjects one after the other, each in a process of its own: one that crashes loses only itself.
/// In a process that has threads or has loaded a graphics driver before, subjects are measured in that
/// process. Report::glibra stays empty.
Report run(std::span<const Subject* const> chosen, const BenchOptions& options, const Progress& progress);

/// True if a subject failed because no driver could be opened (gpu-E01).
bool lacksDriver(const Report& report);

/// The whole report. An error that is not measurable is null, an infinite one the text "inf".
std::string jsonReport(const Report& report);

/// Reads the output of jsonReport and ignores unknown members. `file` is its name in messages. bench-E02: the
/// text is not JSON (with line and column), or not a run of the benchmarks (with what is wrong).
Result<Report> readJsonReport(std::string_view text, const std::string& file);

}  // namespace glibra::bench
