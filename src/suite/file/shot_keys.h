#pragma once
// Reads the keys of [defaults] and [[shot]].

#include <filesystem>
#include <string_view>

#include "suite/file/shot_template.h"
#include "suite/file/toml_reader.h"

namespace glibra::suite {

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
