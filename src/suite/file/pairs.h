#pragma once
// Finds the shots that `match` and `differ` name.

#include <cstddef>
#include <span>
#include <string>

#include "suite/file/shot_template.h"
#include "suite/file/toml_reader.h"
#include "suite/suite.h"

namespace glibra::suite {

/// A `match` or `differ` of shot number `shot` of the suite. `suffix` is that of its sweep and time.
struct PairRequest {
    std::size_t shot = 0;
    bool isMatch = true;
    PlacedText name;
    std::string suffix;
};

/// Sets `match` and `differ` of the shots. A name stands for the shot with that name and the suffix of the
/// shot that names it, if there is one, so that two sweeps over the same values are compared one by one;
/// otherwise for the shot with exactly that name. Where an entry of the suite makes several shots and names
/// one of them, that one is compared with nothing. Errors: suite-E07 there is no such shot; suite-E08 a cycle
/// of names; suite-E12 the named shot makes no picture, or `match` and `differ` name the same shot.
void resolvePairs(TomlReader& reader, std::span<const PairRequest> requests, Suite& suite);

}  // namespace glibra::suite
