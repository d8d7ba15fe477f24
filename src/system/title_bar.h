#pragma once
// The frames that the system draws around windows.

namespace glibra::system {

/// Gives the windows of this thread a dark title bar or a light one, where the system has both.
void setTitleBars(bool dark);

}  // namespace glibra::system
