#pragma once
// Numbers in text fields, as view/scene/typed_number.h reads them. Dear ImGui's own fields read digits up to
// the first other sign: 0,5 as 5 and 1/3 as 1.

#include <array>
#include <optional>

#include "view/window/panels/ui.h"

namespace glibra::view {

/// Takes the place of a field of ImGui that is dragged (DragScalar and its like), while a number is typed
/// into it. Returns true if that has changed the value; nothing if none is typed: the caller draws the field.
std::optional<bool> typedInto(Ui& ui, const char* label, double& value);

/// A field for a number that is typed. Returns true if the value has changed.
bool numberEntry(const char* label, double& value, const char* format, int flags = 0);
/// The same for a whole number between those.
bool wholeEntry(const char* label, int& value, int least, int most, int flags = 0);
/// Two fields side by side, with the label to their right; ImGui takes them for one widget.
bool pairEntry(Ui& ui, const char* label, std::array<double, 2>& values, const char* format);
/// The same for the sides of a picture in pixels, from 1 to `most`.
bool sidesEntry(Ui& ui, const char* label, int& width, int& height, int most);

}  // namespace glibra::view
