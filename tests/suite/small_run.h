#pragma once
// Results of a few shots, for the tests of their file.

#include <string>

#include "suite/results/results.h"

namespace glibra::suite {

inline RunResult smallRun(int count) {
    RunResult run;
    run.driver = "llvmpipe";
    run.shard = "2/8";
    for (int i = 0; i < count; ++i) {
        ShotResult shot;
        shot.suite = "s";
        shot.shot = "shot" + std::to_string(i);
        shot.verdict = Verdict::passed;
        run.shots.push_back(shot);
    }
    return run;
}

}  // namespace glibra::suite
