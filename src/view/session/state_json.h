#pragma once
// A session as JSON, for programs that watch or test the window.

#include <nlohmann/json_fwd.hpp>

#include "view/session/session.h"

namespace glibra::view {

/// One object: values, transforms, time, picture size, messages and counts.
nlohmann::ordered_json stateOf(const Session& session);

}  // namespace glibra::view
