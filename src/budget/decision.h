#pragma once
// What --max-error chose or kept, and why; for --explain and --stats.

#include <glibra/diagnostic.h>

#include <string>

#include "scene/scene.h"

namespace glibra::budget {

struct Decision {
    std::string what;  ///< "Sphere", "samples", "Noise3D"
    std::string why;
    Place place;
};

/// What exceeds the bound.
struct Miss {
    double pixels = 0;
    const scene::Draw* draw = nullptr;
    std::string what;       ///< as Decision::what
    std::string with;       ///< "44 slices, 22 stacks", "uOuter 64, uInner 64", "64 texels per side"
    bool isStated = false;  ///< the scene states it
    /// Why nothing finer can be chosen, although it is stated; empty: --override-counts chooses it.
    std::string fixedBy{};
};

/// What has no bound.
struct Unknown {
    const scene::Draw* draw = nullptr;
    std::string why;  ///< "its program moves the vertices"
};

}  // namespace glibra::budget
