#pragma once
// What of a script decides what its Once and Step blocks make, as a text that can be compared.

#include <span>
#include <string>

#include "glib/script.h"

namespace glibra::view {

/// The statements of the scripts without those that only draw the frame, without the text of shaders, and
/// without values that the window changes: sliders, choices, check boxes, colours. Places and comments do not
/// count.
std::string stepText(std::span<const glib::Script* const> scripts);

}  // namespace glibra::view
