#pragma once

#include <imgui.h>

#include "view/edit/code_paint.h"

namespace glibra::view {

/// For the theme in use.
ImU32 colorOf(Paint paint);

}  // namespace glibra::view
