#pragma once
// Rows of a table of values: the name of a uniform or variable, its widgets, and buttons that animate and
// reset it.

#include <cstddef>
#include <vector>

#include "view/window/panels/ui.h"

namespace glibra::view {

/// Begins the table of rows whose widest name takes `widest` units of the screen. False: it is not visible;
/// otherwise the caller ends it by ImGui::EndTable().
bool beginRows(float widest);

/// The row of a knob, by its index in Session::knobs().
void knobRow(Ui& ui, std::size_t index);

/// One row for knobs that programs share, at least one: that of the first. What is done to it is done to all.
void sharedRow(Ui& ui, const std::vector<std::size_t>& members);

}  // namespace glibra::view
