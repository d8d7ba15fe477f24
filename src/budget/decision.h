#pragma once
// What --max-error chose or kept, and why; for --explain and --stats.

#include <glibra/diagnostic.h>

#include <string>

namespace glibra::budget {

struct Decision {
    std::string what;  ///< "Sphere", "samples", "Noise3D"
    std::string why;
    Place place;
};

}  // namespace glibra::budget
