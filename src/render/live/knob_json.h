#pragma once
// A knob as JSON, for the pages that show its control.

#include <nlohmann/json_fwd.hpp>

#include "render/live/knobs.h"

namespace glibra::render {

/// { "owner": the program or "", "name", "widget": "slider", "checkBox", "color" or "numbers", "declaration":
///   as "vec3 uColor", "isInteger", "isShared": other programs have it, too, "minimum", "maximum",
///   "components": of one element of an array, "initial": [numbers], "current": [numbers],
///   "words": [of a choice] }
nlohmann::ordered_json jsonOf(const Knob& knob);

}  // namespace glibra::render
