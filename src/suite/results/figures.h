#pragma once
// What a comparison measured, as lines that a person reads. All reports print these.

#include <string>
#include <vector>

#include "suite/results/results.h"

namespace glibra::suite {

struct Figure {
    std::string name;   ///< "largest difference"
    std::string value;  ///< "12/255 (red, at 40 12)"
    std::string limit;  ///< "3/255"; empty where there is none
    bool beyond = false;
};

/// Empty where no pictures were compared: equal bytes, sizes that differ, a shot without picture.
std::vector<Figure> figures(const ShotResult& shot);

/// What decided: "equal bytes", "largest difference", ...; empty where nothing was compared.
std::string decision(const ShotResult& shot);

/// The sentence to show for a shot: its reason, or what the verdict means where there is none.
std::string reasonOf(const ShotResult& shot);

/// "3 failed, 1 missing, 120 passed": verdicts that occur, in the order of concern; "no shots" without any.
std::string counts(const RunResult& run);

/// "0.2 s", "48 s", "2 min 5 s", "1 h 3 min".
std::string readableTime(double seconds);

}  // namespace glibra::suite
