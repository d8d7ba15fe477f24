#pragma once
// The page of a class, for a browser, and its table.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <string>

#include "base/contained.h"
#include "classroom/classroom.h"

namespace glibra::classroom {

/// Pairs of similar submissions that the page lists with their passages; the others are counted.
inline constexpr std::size_t kMostListedPairs = 50;

/// The page as HTML. Nothing on it needs a script. The passages of similar submissions are read from their
/// own folders (and no link is followed); a passage whose file cannot be read is named without its text.
std::string classPage(const Classroom& classroom);

/// Writes SITE/grades.csv, then SITE/index.html. Returns nothing, or one file-E10.
Diagnostics writeSite(const Classroom& classroom, const std::filesystem::path& site);

}  // namespace glibra::classroom
