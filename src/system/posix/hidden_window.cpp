// EGL makes contexts without a window.

#include "system/hidden_window.h"

namespace glibra::system {

HiddenWindow::HiddenWindow() = default;

HiddenWindow::~HiddenWindow() = default;

}  // namespace glibra::system
