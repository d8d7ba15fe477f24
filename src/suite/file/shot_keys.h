#pragma once
// The keys of a shot, and the scenes that they name.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "suite/file/sweep.h"
#include "suite/file/toml_reader.h"
#include "suite/options/option_table.h"
#include "suite/suite.h"

namespace glibra::suite {

// Messages about folders that do not exist.

/// Names the first part of `folder` that is not a folder: "there is no folder 'a/strat'; did you mean
/// 'start'?". The question is left out if no folder beside it has a similar name. Empty if `folder` exists.
std::string whyNoFolder(const std::filesystem::path& folder);

// What a table [defaults] or [[shot]] states, before scripts, sweeps and times make shots of it.

/// A text in the file, with its place.
struct PlacedText {
    std::string text;
    Place place;
};

struct ShotTemplate {
    Shot shot;                           ///< everything but name, script, time and uniforms
    std::vector<PlacedText> scripts;     ///< files or patterns, as written
    bool isList = false;                 ///< scripts was a list
    std::vector<PlacedText> exceptions;  ///< patterns
    std::optional<PlacedText> name, match, differ;
    std::vector<double> times{0};
    bool namesTimes = false;  ///< times was a list, so the names of the shots contain them
    std::vector<UniformValues> set, sweeps;
};

// Reads the options of a picture (option_table.h) from a suite.

// Reads the keys of [defaults] and [[shot]].

/// Applies the keys of a table to `shot`. Uniforms and fields of the tolerance are replaced one by one, tags
/// are added, and every other key replaces its value. Folders are relative to `folder`. With `isDefaults`,
/// only the keys of [defaults] are allowed.
void readTemplate(TomlReader& reader, const TomlTable& table, const std::filesystem::path& folder,
                  bool isDefaults, ShotTemplate& shot);

/// True for a key of [[shot]].
bool isShotKey(std::string_view key);
/// True for a key that [defaults] may have too.
bool isDefaultsKey(std::string_view key);

// Finds the scene files of a [[shot]].

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
