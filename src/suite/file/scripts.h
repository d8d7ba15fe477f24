#pragma once
// The scene files that a [[shot]] means.

#include <filesystem>
#include <string>
#include <vector>

#include "suite/file/shot_template.h"
#include "suite/file/toml_reader.h"

namespace glibra::suite {

struct FoundScript {
    std::filesystem::path path;
    std::string name;  ///< of its shot, without sweeps and times; checked
    Place place;       ///< of the text that found it
};

/// The files, each once, in the order of the texts and sorted within a pattern, less the exceptions. A text
/// that is the name of a file is that file; else one with wildcards is a pattern (filesThatFit). A single
/// file is named by `name`, else by its own; several are named by their paths below the fixed part of their
/// pattern, after `name` and a '/' if there is one. Errors: suite-E05, -E09 a pattern that fits nothing, -E10
/// no such file.
std::vector<FoundScript> findScripts(TomlReader& reader, const std::filesystem::path& folder,
                                     const ShotTemplate& shot);

}  // namespace glibra::suite
