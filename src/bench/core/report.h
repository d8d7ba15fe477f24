#pragma once
// The result of one run of the benchmarks, and the machine it ran on.

#include <glibra/diagnostic.h>

#include <string>
#include <vector>

#include "bench/core/measurement.h"

namespace glibra::bench {

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

}  // namespace glibra::bench
