#pragma once
// What [defaults] and [[shot]] say, before scripts, sweeps and times make shots of it.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "suite/file/sweep.h"
#include "suite/file/toml_reader.h"
#include "suite/suite.h"

namespace glibra::suite {

/// A text of the file with its place.
struct PlacedText {
    std::string text;
    Place place;
};

struct ShotTemplate {
    Shot shot;                           ///< all but name, script, time and uniforms
    std::vector<PlacedText> scripts;     ///< files or patterns, as written
    bool isList = false;                 ///< scripts was a list
    std::vector<PlacedText> exceptions;  ///< patterns
    std::optional<PlacedText> name, match, differ;
    std::vector<double> times{0};
    bool namesTimes = false;  ///< times was a list, so that they stand in the names
    std::vector<UniformValues> set, sweeps;
};

/// Applies the keys of a table to what `shot` holds already: uniforms and fields of the tolerance one by one,
/// tags in addition, everything else in whole. Folders are relative to `folder`. With `isDefaults` only the
/// keys that may stand in [defaults].
void readTemplate(TomlReader& reader, const toml::table& table, const std::filesystem::path& folder,
                  bool isDefaults, ShotTemplate& shot);

/// True for a key of [[shot]].
bool isShotKey(std::string_view key);
/// True for one that may stand in [defaults] too.
bool isDefaultsKey(std::string_view key);

}  // namespace glibra::suite
