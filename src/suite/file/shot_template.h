#pragma once
// What a table [defaults] or [[shot]] states, before scripts, sweeps and times make shots of it.

#include <glibra/diagnostic.h>

#include <optional>
#include <string>
#include <vector>

#include "suite/file/sweep.h"
#include "suite/suite.h"

namespace glibra::suite {

/// A text in the file, with its place.
struct PlacedText {
    std::string text;
    Place place;
};

struct ShotTemplate {
    Shot shot;                           ///< everything but name, script, time and uniforms
    std::vector<PlacedText> scripts;     ///< files or patterns, as written
    bool isList = false;                 ///< scripts was a list
    std::vector<PlacedText> exceptions;  ///< patterns
    std::optional<PlacedText> name, match, differ;
    std::vector<double> times{0};
    bool namesTimes = false;  ///< times was a list, so the names of the shots contain them
    std::vector<UniformValues> set, sweeps;
};

}  // namespace glibra::suite
