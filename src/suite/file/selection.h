#pragma once
// Which shots of a suite are run: --only and --shard.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "suite/file/shard.h"
#include "suite/suite.h"

namespace glibra::suite {

/// True if one pattern of --only means this shot. "tag:NAME" means a tag; anything else means the shot's
/// name, or what stands before the first '@' of it, so that "oval" means all shots of its sweeps. Both may
/// have wildcards (glob.h); '*' also stands for '/'.
bool isMeant(const Shot& shot, std::string_view pattern);

/// Indices of the shots to run, rising: those that any of the patterns means (all if there are none),
/// `withNamed` those that they name by `match` and `differ` and so on, and of these the shard's.
std::vector<std::size_t> select(const Suite& suite, std::span<const std::string> onlyPatterns, Shard shard,
                                bool withNamed = true);

/// suite-E15, with the nearest name or tag, for every pattern that means no shot of any of the suites.
Diagnostics unmatchedPatterns(std::span<const Suite> suites, std::span<const std::string> onlyPatterns);

}  // namespace glibra::suite
