#include "system/window.h"

namespace glibra::system {

/// Desktops decide that themselves.
void setTitleBars(bool) {}

// EGL makes contexts without a window.

HiddenWindow::HiddenWindow() = default;

HiddenWindow::~HiddenWindow() = default;

}  // namespace glibra::system
