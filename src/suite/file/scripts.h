#pragma once
// Finds the scene files of a [[shot]].

#include <filesystem>
#include <string>
#include <vector>

#include "suite/file/shot_keys.h"
#include "suite/file/toml_reader.h"

namespace glibra::suite {

struct FoundScript {
    std::filesystem::path path;
    std::string name;  ///< name of its shot, without sweeps and times; valid
    Place place;       ///< place of the text that matched it
};

/// Returns the files, each once: in the order of the texts, sorted within a pattern, without the exceptions.
/// A text that is the name of a file stands for that file. Any other text with wildcards is a pattern
/// (filesThatFit). A single file is named by `name`, or else by its own name. Several files are named by
/// their paths below the fixed part of their pattern, after `name` and a "/" if there is one. Errors:
/// suite-E05 a bad name; suite-E09 a pattern that matches no file; suite-E10 there is no such file.
std::vector<FoundScript> findScripts(TomlReader& reader, const std::filesystem::path& folder,
                                     const ShotTemplate& shot);

}  // namespace glibra::suite
