#pragma once
// GLSL extensions whose content is in core GLSL, or that real shaders name and that the translation answers.

#include <optional>
#include <string_view>

namespace glibra::glsl {

/// The GLSL version that holds the extension's content, 0 if the translator supplies it; nothing for others.
std::optional<int> extensionInCoreSince(std::string_view name);

}  // namespace glibra::glsl
