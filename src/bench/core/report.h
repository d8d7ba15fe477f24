#pragma once
// What one run of the bench found, and on what machine.

#include <glibra/diagnostic.h>

#include <string>
#include <vector>

#include "bench/core/measurement.h"

namespace glibra::bench {

/// Empty strings and zeros: not known.
struct Machine {
    std::string processor;          ///< model name
    int cores = 0;                  ///< that this process may use
    double memory = 0;              ///< bytes
    std::string system;             ///< "Linux 6.1.0-18-amd64 x86_64"
    std::string compiler;           ///< "GCC 12.2.0"
    std::string driver;             ///< how OpenGL was opened; empty: not at all
    std::string renderer, version;  ///< the driver's own words
};

struct SubjectRun {
    std::string name;  ///< as in the table of subjects
    std::string title;
    double seconds = 0;  ///< that measuring took
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
