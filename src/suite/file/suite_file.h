#pragma once
// Reads a suite: a TOML file, or a folder of scenes.

#include <glibra/result.h>

#include <cstddef>
#include <filesystem>

#include "suite/suite.h"

namespace glibra::suite {

/// More shots than anybody means; a sweep that makes more is a mistake.
inline constexpr std::size_t kMostShots = 100'000;

/// Reads a suite file, or makes a suite of every .glib file in a folder and the folders below it (those whose
/// names begin with '.' left out), in the order of their paths.
///
/// The file has the keys `goldens` (a folder; "golden/NAME" beside the file if it is left out), [defaults]
/// and
/// [[shot]]; README.md describes them. Files are relative to the suite file. Of a folder the golden pictures
/// are in its sub-folder "golden". Errors have a place and the ids suite-E01 to suite-E18 (catalogue), or
/// those of image::readFile; there is a value only without errors.
Result<Suite> readSuite(const std::filesystem::path& fileOrFolder);

/// The same from the text of a suite file, with the path it would have.
Result<Suite> readSuiteText(std::string_view text, const std::filesystem::path& file);

}  // namespace glibra::suite
