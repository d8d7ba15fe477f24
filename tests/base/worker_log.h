#pragma once
// What becomes of pieces of work that workers do, for the tests of workers.

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "base/workers.h"

namespace glibra::base {

struct Log {
    std::map<std::size_t, Outcome> outcomes;
    std::map<std::size_t, int> steps;
};

inline Log runAll(std::size_t count, const WorkerOptions& options, const Work& work) {
    Log log;
    runInWorkers(
        count, options, work,
        [&](std::size_t index, const Outcome& outcome) {
            EXPECT_FALSE(log.outcomes.contains(index)) << "piece " << index << " ended twice";
            log.outcomes[index] = outcome;
        },
        [&](std::size_t index, const std::string&) { ++log.steps[index]; });
    return log;
}

}  // namespace glibra::base
