#pragma once
// Selects the shots of a suite to run: --only and --shard.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "suite/suite.h"

namespace glibra::suite {

// Divides a suite among machines. The shard of a shot depends only on the names of the suite and of the shot.
// So it is the same on every machine, and adding or removing a shot does not move the others.

/// Part `index` of `count`, counted from 1.
struct Shard {
    int index = 1;
    int count = 1;
};

/// Reads "2/8": whole numbers I/N with 1 <= I <= N <= 1,000,000. Reports suite-E16 otherwise.
Result<Shard> parseShard(std::string_view text);

/// Returns, for each shot of the suite, the name that decides its shard. Shots that name each other by
/// `match` and `differ` share one name, because one machine needs both pictures: the name of the shot that
/// names no other, or the first of those in byte order. A new shot that names an existing one does not move
/// it.
std::vector<std::string_view> shardNames(const Suite& suite);

/// The shard (0 to count - 1) of a name: h mod count. h is the 64-bit FNV-1a hash (Fowler, Noll, Vo) of the
/// name of the suite, a zero byte and the name of the shot, mixed by the finalizer of MurmurHash3 (Appleby,
/// 2011). Without the mixing, similar names have similar low bits.
int shardOf(std::string_view suiteName, std::string_view shardName, int count);

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
