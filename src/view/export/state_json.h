#pragma once
// A session as JSON, for programs that watch or test the window.

#include <nlohmann/json.hpp>

#include "view/scene/session.h"

namespace glibra::view {

/// Values, transforms, time, picture size, messages and counts: one object.
nlohmann::ordered_json stateOf(const Session& session);

}  // namespace glibra::view
