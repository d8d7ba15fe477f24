#pragma once
// Fields for colours.

#include <array>
#include <string_view>

#include "view/window/panels/ui.h"

namespace glibra::view {

/// A button in the colour, which opens a picker. Returns true if the colour has changed.
bool colorSwatch(Ui& ui, const char* id, std::string_view name, std::array<float, 4>& rgba, bool hasAlpha);

/// A swatch and a number for each component, which is dragged or typed; in two rows if one is too narrow to
/// show three digits. `name` is that of the numbers together, for mark(). Returns true if the colour has
/// changed.
bool colorField(Ui& ui, std::string_view name, std::array<float, 4>& rgba, bool hasAlpha);

}  // namespace glibra::view
