#pragma once
// Patterns of file names, as in a shell: "*" matches any characters, "?" one character, "[a-z]" one character
// of a set, "[!a-z]" one that is not in the set. A "[" without "]" stands for itself. Patterns compare bytes,
// and upper and lower case differ.

#include <glibra/result.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::suite {

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

}  // namespace glibra::suite
