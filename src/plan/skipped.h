#pragma once
// What a plan leaves out, in words, for --explain and --stats.

#include <glibra/diagnostic.h>

#include <string>

namespace glibra::plan {

struct Skipped {
    std::string what;  ///< "texture", "noise texture", "attribute", "mesh", "program", "pass", "draw",
                       ///< "dispatch", "statement", "file"
    std::string why;   ///< which one, and why: "unit 5 / 3D: no active sampler reads it"
    Place place;
};

}  // namespace glibra::plan
