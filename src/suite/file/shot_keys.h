#pragma once
// The keys of a shot.

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

/// Gives `shot` the value of one option. Uniform variables and objects' matrices are set one by one; other
/// values are replaced as a whole. Folders are relative to `folder`. A wrong value is reported and changes
/// nothing.
void readOption(TomlReader& reader, const OptionRow& row, const TomlValue& value,
                const std::filesystem::path& folder, ShotTemplate& shot);

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

}  // namespace glibra::suite
