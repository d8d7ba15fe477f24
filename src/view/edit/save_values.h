#pragma once
// The present values of a session's knobs, put back into the text of its scene.

#include <glibra/result.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "view/scene/knobs.h"

namespace glibra::view {

/// The scene's text with the value of every changed knob replaced in place; everything else stays byte for
/// byte. A knob whose value is no longer where it was read from is an error (view-E01): nothing is replaced
/// then.
Result<std::string> withValues(std::string_view text, std::span<const Knob> knobs);

/// The same for a file, written when it is whole.
Diagnostics saveValues(const std::filesystem::path& scene, std::span<const Knob> knobs);

}  // namespace glibra::view
