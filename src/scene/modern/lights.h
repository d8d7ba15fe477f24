#pragma once
// The values of Light and Material (language, 12.1).

#include <vector>

#include "scene/modern/modern.h"

namespace glibra::scene {

/// The numbers of a tag that Light or Material set, for a draw with the camera that is current.
std::vector<double> numbersInEye(Interpreter&, const ScopedTag& tag);

}  // namespace glibra::scene
