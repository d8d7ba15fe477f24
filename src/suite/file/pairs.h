#pragma once
// `match` and `differ`: which shot each name means.

#include <cstddef>
#include <span>
#include <string>

#include "suite/file/shot_template.h"
#include "suite/file/toml_reader.h"
#include "suite/suite.h"

namespace glibra::suite {

/// What shot number `shot` of the suite asks for. `suffix` is that of its sweep and time.
struct PairRequest {
    std::size_t shot = 0;
    bool isMatch = true;
    PlacedText name;
    std::string suffix;
};

/// Fills in `match` and `differ`. A name means the shot of that name and the asking shot's own suffix, if
/// there is one (so that two sweeps over the same values are compared one by one), else the shot of that name
/// alone. Errors: suite-E07 no such shot, -E08 a ring of names, -E12 a shot that makes no picture to compare,
/// or the same one named twice.
void resolvePairs(TomlReader& reader, std::span<const PairRequest> requests, Suite& suite);

}  // namespace glibra::suite
