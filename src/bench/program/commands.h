#pragma once
// What glibra-bench does. Both return an exit status (see cli/commands.h).

#include <string>
#include <vector>

#include "bench/core/bench.h"
#include "bench/report/comparison.h"
#include "suite/suite.h"

namespace glibra::bench {

struct MeasureArguments {
    std::vector<std::string> subjects;  ///< names; empty: all subjects
    bool list = false;                  ///< prints the names of the subjects only
    BenchOptions options;
    std::string scene, sweep;             ///< of --scene and --sweep; empty: subjects are measured
    suite::Shot picture;                  ///< options of its picture
    std::string folder, csv, json, html;  ///< files to write; empty: none
    std::string against;                  ///< bench.json of an earlier run; empty: no comparison
    ComparisonOptions comparison;
};

/// `glibra bench`: measures the subjects, prints them, writes the files and compares.
int measure(const MeasureArguments& arguments);

/// `glibra info --precision`: the output of `glibra info`, then the error of every GLSL function.
int printPrecision(Driver driver, bool asJson);

}  // namespace glibra::bench
