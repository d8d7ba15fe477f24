#pragma once
// The named materials (language, 12.1).

#include <span>
#include <string_view>
#include <vector>

#include "glib/value.h"

namespace glibra::scene {

/// A material as the tags that `Material` sets.
struct MaterialRow {
    std::string_view name;
    std::vector<glib::KeyedValues>
        tags;  ///< material.ambient, .diffuse, .specular (4 components), .shininess
};

/// The material of that name, in any case; null if there is none.
const MaterialRow* findMaterial(std::string_view name);
std::span<const std::string_view> materialNames();

}  // namespace glibra::scene
