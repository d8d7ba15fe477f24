#pragma once
// One machine's part of a suite. Who gets a shot depends on the names of the suite and the shot alone, so
// that it is the same on every machine, and a shot that is added or taken away moves no other.

#include <glibra/result.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "suite/suite.h"

namespace glibra::suite {

/// Part `index` of `count`, counted from 1.
struct Shard {
    int index = 1;
    int count = 1;
};

/// Reads "2/8": both whole numbers, 1 <= I <= N <= 1,000,000. suite-E16 otherwise.
Result<Shard> parseShard(std::string_view text);

/// The name that decides which shard a shot belongs to, for each shot of the suite. Shots that name each
/// other by `match` and `differ` have one name in common, because one machine needs both pictures: that of
/// the shot which names no other; where a group has several of those, the first of them in byte order. A shot
/// that is added and names an existing one does not move it.
std::vector<std::string_view> shardNames(const Suite& suite);

/// The shard (0 .. count - 1) of a name: h mod count, where h is FNV-1a with 64 bits (Fowler, Noll, Vo) of
/// the suite's name, a zero byte and the shot's name, mixed by the finalizer of MurmurHash3 (Appleby, 2011),
/// without which the low bits of like names are alike.
int shardOf(std::string_view suiteName, std::string_view shardName, int count);

}  // namespace glibra::suite
