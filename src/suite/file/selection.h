#pragma once
// Selects the shots of a suite to run: --only and --shard.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "suite/file/shard.h"
#include "suite/suite.h"

namespace glibra::suite {

/// True if one pattern of --only matches this shot. "tag:NAME" matches a tag. Any other pattern matches the
/// name of the shot, or the part of the name before its first "@", so that "oval" matches all shots of its
/// sweeps. Both may have wildcards (glob.h); "*" matches "/" too.
bool isMeant(const Shot& shot, std::string_view pattern);

/// Returns the indices of the shots to run, in rising order: the shots that any pattern matches (all shots if
/// there is no pattern); with `withNamed` also the shots that those name by `match` and `differ`, and so on,
/// and those that name a shot that only they compare; and of these only the shots of the shard.
std::vector<std::size_t> select(const Suite& suite, std::span<const std::string> onlyPatterns, Shard shard,
                                bool withNamed = true);

/// Reports suite-E15, with the nearest name or tag, for every pattern that matches no shot of any suite.
Diagnostics unmatchedPatterns(std::span<const Suite> suites, std::span<const std::string> onlyPatterns);

}  // namespace glibra::suite
