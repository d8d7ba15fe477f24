#pragma once

#include <vector>

#include "scene/scene.h"

namespace glibra::view {

/// The draws of the frame's passes into the window, in order.
std::vector<const scene::Draw*> windowDraws(const scene::Scene& scene);

}  // namespace glibra::view
