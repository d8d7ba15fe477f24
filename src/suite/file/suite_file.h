#pragma once
// Reads a suite: a TOML file, or a folder of scenes.

#include <glibra/result.h>

#include <cstddef>
#include <filesystem>

#include "suite/suite.h"

namespace glibra::suite {

/// The largest number of shots in a suite. A sweep that makes more is a mistake.
inline constexpr std::size_t kMostShots = 100'000;

/// Reads a suite file, or makes a suite of every .glib file in a folder and the folders below it, in the
/// order of their paths. Names that begin with "." are left out.
///
/// The file has the keys `goldens` (a folder; "golden/NAME" beside the file if it is missing), [defaults] and
/// [[shot]]; docs/suites.md describes them. Files are relative to the suite file. The goldens of a folder are
/// in its sub-folder "golden". Errors have a place and the ids suite-E01 to suite-E18, or those of
/// image::readFile. There is a value only without errors.
Result<Suite> readSuite(const std::filesystem::path& fileOrFolder);

/// The same for the text of a suite file; `file` is the path that the file would have.
Result<Suite> readSuiteText(std::string_view text, const std::filesystem::path& file);

}  // namespace glibra::suite
