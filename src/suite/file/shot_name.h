#pragma once
// Names of shots: they name files and folders, so they are made of what every file system takes.

#include <string>
#include <string_view>

namespace glibra::suite {

/// Why a name cannot be a shot's, as the end of a sentence ("has an empty part"); empty if it can. A name has
/// parts of letters, digits and "._-=,@+" with '/' between them; no part is empty, begins with '.' or is
/// longer than 200 bytes, and the whole is not longer than 1000.
std::string whyNotAName(std::string_view name);

/// "teapot" of "teapot.nvidia": the shot whose golden for that family of drivers would have the file of this
/// shot's golden; empty if what stands behind the last '.' can be no family (letters, "d3d12", "osmesa-...").
std::string_view shotOfVariant(std::string_view name);

/// The name for a scene file: its path without the ending, every other character replaced by '_' (one for a
/// character of UTF-8), leading '.' of a part too.
std::string nameOfScene(std::string_view path);

}  // namespace glibra::suite
