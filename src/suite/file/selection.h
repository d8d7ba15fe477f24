#pragma once
// Which files and which shots are meant: patterns of names, --only and --shard.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "suite/suite.h"

namespace glibra::suite {

// Patterns of file names, as in a shell: "*" matches any characters, "?" one character, "[a-z]" one character
// of a set, "[!a-z]" one that is not in the set. A "[" without "]" stands for itself. Patterns compare bytes,
// and upper and lower case differ.

/// True if `text` contains "*", "?" or "[".
bool isPattern(std::string_view text);

/// True if the pattern matches all of `text`; "*" and "?" match "/" too. Takes at most pattern.size() *
/// text.size() steps.
bool fits(std::string_view pattern, std::string_view text);

/// The limits of one search: entries of folders that it looks at, and folders below each other that a "**"
/// stands for. A suite that searches a whole disk by mistake is told so within a second.
inline constexpr std::size_t kMostSearched = 200'000;
inline constexpr int kDeepestSearch = 64;

/// Returns the regular files below `folder` whose paths match the pattern, sorted by bytes, in the form
/// "folder/part/part". Links to files are followed. The pattern is matched part by part: "*" ends at a "/",
/// the part "**" stands for any number of folders (links to folders are not followed), and neither matches a
/// name that begins with ".". An absolute pattern does not use `folder`.
///
/// No value and no diagnostics mean that the search would exceed a limit. No value and suite-E22 for each
/// folder that cannot be listed, and for each entry of which it is not known whether it is a file: a search
/// that left them out would lose scenes without a word.
Result<std::vector<std::filesystem::path>> filesThatFit(const std::filesystem::path& folder,
                                                        std::string_view pattern);

/// Returns the scenes (.glib, in any case) in a folder and all below it, as filesThatFit.
Result<std::vector<std::filesystem::path>> scenesBelow(const std::filesystem::path& folder);

/// The leading parts of a pattern that have no wildcard, as a folder: "../glib" of "../glib/*/a*.glib", "" of
/// "*.glib".
std::string fixedFolder(std::string_view pattern);

// Selects the shots of a suite to run: --only and --shard.

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
/// sweeps. Both may have wildcards (fits()); "*" matches "/" too.
bool isMeant(const Shot& shot, std::string_view pattern);

/// Returns the indices of the shots to run, in rising order: the shots that any pattern matches (all shots if
/// there is no pattern); with `withNamed` also the shots that those name by `match` and `differ`, and so on,
/// and those that name a shot that only they compare; and of these only the shots of the shard.
std::vector<std::size_t> select(const Suite& suite, std::span<const std::string> onlyPatterns, Shard shard,
                                bool withNamed = true);

/// Reports suite-E15, with the nearest name or tag, for every pattern that matches no shot of any suite.
Diagnostics unmatchedPatterns(std::span<const Suite> suites, std::span<const std::string> onlyPatterns);

}  // namespace glibra::suite
