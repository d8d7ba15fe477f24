#pragma once
// Values that several programs have in common: one control moves them all.

#include <span>
#include <vector>

#include "view/scene/knobs.h"

namespace glibra::view {

/// Each entry has the indices of knobs of different programs that the scene gives the same tag, type, range
/// and value; two at least, in their order. Variables of the scene are in none.
std::vector<std::vector<std::size_t>> sharedKnobs(std::span<const Knob> knobs);

}  // namespace glibra::view
