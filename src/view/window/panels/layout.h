#pragma once
// Where the panels stand, and the order in which a frame draws them.

#include "view/window/panels/ui.h"

namespace glibra::view {

/// The width of the panel with the sections, in screen coordinates.
float panelWidth(const Ui& ui);
/// Width / height of the picture, as the scene's window or the command line says; 0 without a scene.
double shapeOf(const Ui& ui);

/// Draws all panels and windows of one frame.
void showAll(Ui& ui);
/// Draws what panels have to draw over the picture, after the scene was drawn.
void drawOverPicture(Ui& ui);

}  // namespace glibra::view
