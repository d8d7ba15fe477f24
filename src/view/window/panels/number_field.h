#pragma once
// Numbers in text fields, as view/scene/typed_number.h reads them. Dear ImGui's own fields read digits up to
// the first other sign: 0,5 as 5 and 1/3 as 1.

#include <optional>

#include "view/window/panels/ui.h"

namespace glibra::view {

/// Takes the place of a field of ImGui that is dragged (DragScalar and its like), while a number is typed
/// into it. Returns true if that has changed the value; nothing if none is typed: the caller draws the field.
std::optional<bool> typedInto(Ui& ui, const char* label, double& value);

/// A field for a number that is typed. Returns true if the value has changed.
bool numberEntry(const char* label, double& value, const char* format);

}  // namespace glibra::view
