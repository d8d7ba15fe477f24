#pragma once
// What is shown in place of the picture.

namespace glibra::view {

struct Ui;

/// The choice of a debug view ("Show") and its legend, and the switch of the probe: a part of the section
/// View.
void debugViewControls(Ui& ui);

}  // namespace glibra::view
