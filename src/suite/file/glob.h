#pragma once
// Patterns as a shell has them: '*' any characters, '?' one character, "[a-z]" one of a set, "[!a-z]" one
// that is not in it. A '[' that is never closed stands for itself. Bytes are compared; case counts.

#include <glibra/result.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::suite {

/// True if `text` has a '*', a '?' or a '[' in it.
bool isPattern(std::string_view text);

/// True if the pattern fits all of `text`; '*' and '?' also stand for '/'. Takes at most
/// pattern.size() * text.size() steps.
bool fits(std::string_view pattern, std::string_view text);

/// The ordinary files below `folder` whose paths fit the pattern, sorted by bytes, links to files followed,
/// each in the form "folder/part/part". Here the pattern is taken part by part: '*' ends at a '/', the part
/// "**" stands for any number of folders (links to folders are not followed), and neither fits a name that
/// begins with '.'. An absolute pattern does not use `folder`. No value, and no diagnostics, if more than a
/// million entries would have to be looked at; what cannot be read is not there.
Result<std::vector<std::filesystem::path>> filesThatFit(const std::filesystem::path& folder,
                                                        std::string_view pattern);

/// The leading parts of a pattern without a wildcard, as a folder: "../glib" of "../glib/*/a*.glib"; "" of
/// "*.glib".
std::string fixedFolder(std::string_view pattern);

}  // namespace glibra::suite
