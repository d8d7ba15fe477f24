#pragma once
// A scene of the user's own as a subject: run time and error against the values of one of its variables.

#include <glibra/render.h>
#include <glibra/result.h>

#include <filesystem>
#include <string>
#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

struct SceneSweep {
    std::filesystem::path scene;
    RenderOptions options;       ///< the time of the picture is one of them
    std::string name;            ///< of the variable or uniform
    std::vector<double> values;  ///< at least two; the last one is the finest
};

/// One figure: the root mean square of the difference from the picture at the last value, and the time to
/// draw the picture once more, whole. Of a picture at a time above 0 it contains the steps since 0.
Result<std::vector<Figure>> measureSweep(Bench& bench, const SceneSweep& sweep);

}  // namespace glibra::bench
