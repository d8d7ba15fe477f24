#pragma once
// Pages with places for texts.

#include <span>
#include <string>
#include <string_view>

namespace glibra::base {

struct Slot {
    std::string_view name;
    std::string text;
};

/// Returns the page with each {{name}} replaced by the text of the slot. Replaced text is not searched again.
std::string filled(std::string_view page, std::span<const Slot> slots);

}  // namespace glibra::base
