#pragma once
// Names of shots, and of the store of their pictures.

#include <string>
#include <string_view>

namespace glibra::suite {

// Names of shots. They name files and folders, so they use only characters that every file system allows.

/// Returns why a name is not valid, as the end of a sentence ("has an empty part"), or nothing if it is
/// valid. A name has parts of letters, digits and "._-=,@+" with "/" between them. No part is empty, begins
/// with "." or is longer than 200 bytes, and the name is not longer than 1000.
std::string whyNotAName(std::string_view name);

/// The name as a disk that ignores upper and lower case, and dots at the end of a folder's name, tells it
/// from others: two names with one such form would share their golden there.
std::string nameOnAnyDisk(std::string_view name);

/// The variants of goldens that are further accepted pictures: "also1" to "also9".
inline constexpr std::string_view kFurtherVariant = "also";
inline constexpr int kMostFurther = 9;

/// Returns "teapot" for "teapot.nvidia": the shot whose golden for that family of drivers would have the same
/// file as the golden of this shot. Empty if the part after the last "." cannot be a family (letters,
/// "d3d12", "osmesa-...") or a further picture.
std::string_view shotOfVariant(std::string_view name);

/// The name for a scene file: its path without the ending, with "_" for every character that a name cannot
/// have (one for a character of UTF-8) and for the "." at the beginning of a part.
std::string nameOfScene(std::string_view path);

// The `store` of a suite: where the pictures are of which its goldens have the hashes
// (golden/picture_store.h).

/// What stands in an address for the hash of a picture.
inline constexpr std::string_view kHashSlot = "{hash}";

/// True for the address of a web server, false for a folder.
bool isAddress(std::string_view store);
/// Why a text cannot be a store; empty if it can: a folder, or "https://host/place/{hash}.png" (http, too),
/// where {hash} stands once, after the last '/'.
std::string whyNoStore(std::string_view text);

}  // namespace glibra::suite
