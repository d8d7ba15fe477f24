#pragma once
// GLSL extensions that need no #extension line: core GLSL contains them, or the translator supplies their
// content.

#include <optional>
#include <string_view>

namespace glibra::glsl {

/// The GLSL version that contains the extension; 0 if the translator supplies it; nothing for other
/// extensions.
std::optional<int> extensionInCoreSince(std::string_view name);

}  // namespace glibra::glsl
