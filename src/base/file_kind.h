#pragma once
// What a file is that stands in the place of a scene, a shader or a model: for messages.

#include <string>
#include <string_view>

namespace glibra::base {

/// "a PNG picture", "a PLY model", "a GLSL shader", "UTF-16 text": with its article, as far as the beginning
/// shows it. Empty for a text that may be anything.
std::string_view fileKind(std::string_view content);

/// "UTF-16 text" or "UTF-32 text"; empty for other files.
std::string_view foreignEncoding(std::string_view content);

/// "is a PNG picture, not a scene", "is UTF-16 text; save it as UTF-8", "is a binary file, not a scene";
/// empty for a text that may be what is wanted.
std::string notThe(std::string_view wanted, std::string_view content);

/// True for a file that is no text of UTF-8 or of one byte for each character.
bool isNoText(std::string_view content);

}  // namespace glibra::base
