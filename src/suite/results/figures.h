#pragma once
// The figures of a comparison as lines of text. All reports print these.

#include <string>
#include <vector>

#include "suite/results/results.h"

namespace glibra::suite {

struct Figure {
    std::string name;   ///< "largest difference"
    std::string value;  ///< "12/255 (red, at 40 12)"
    std::string limit;  ///< "3/255"; or empty
    bool beyond = false;
};

/// The figures of a shot: how much of its picture is compared, unless it is all, and those of the comparison,
/// unless no pictures were compared (equal bytes, different sizes, a shot without a picture).
std::vector<Figure> figures(const ShotResult& shot);

/// How many pixels differ by more than each step, as "0: 5120, 1: 2210, 2: 96, 4: 12, 8: 0 of 255"; empty if
/// unknown.
std::string stepsText(const ShotResult& shot);

/// What decided: "equal bytes", "largest difference", ...; empty if nothing was compared.
std::string decision(const ShotResult& shot);

/// What the two pictures of a shot are: "expected" and "got"; of an unstable one, its two drawings.
struct PictureTitles {
    const char* expected;
    const char* got;
};
PictureTitles titlesOf(const ShotResult& shot);

/// The sentence to show for a shot: its reason, or the meaning of the verdict if it has none.
std::string reasonOf(const ShotResult& shot);

/// "30 drawn, 10 failed, none has a golden yet", "1 drawn without a golden, 3 failed, 120 passed": the
/// verdicts that occur, the most urgent first after the pictures that have no golden yet; "no shots" if there
/// are none.
std::string counts(const RunResult& run);

/// "0.2 s", "48 s", "2 min 5 s", "1 h 3 min".
std::string readableTime(double seconds);

}  // namespace glibra::suite
