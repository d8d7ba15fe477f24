#pragma once
// Writes the current values of knobs into the text of their scene.

#include <glibra/result.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "view/scene/knobs.h"

namespace glibra::view {

/// The scene's text with the value of every changed knob replaced; all other bytes stay. If a value is no
/// longer where it was read from, the result is the error view-E01.
Result<std::string> withValues(std::string_view text, std::span<const Knob> knobs);

/// The same for a file, which is written atomically.
Diagnostics saveValues(const std::filesystem::path& scene, std::span<const Knob> knobs);

}  // namespace glibra::view
