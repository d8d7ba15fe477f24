#include "system/title_bar.h"

namespace glibra::system {

/// Desktops decide that themselves.
void setTitleBars(bool) {}

}  // namespace glibra::system
