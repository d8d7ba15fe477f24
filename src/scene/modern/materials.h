#pragma once
// The named materials (language, 12.1).

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glib/value.h"

namespace glibra::scene {

struct MaterialMember {
    std::string name;  ///< "ambient", "diffuse", "specular" (4 components), "shininess"
    std::vector<double> numbers;
    glib::KeyedValues tag;  ///< without a place, for ScopedTag
};
struct MaterialRow {
    std::string_view name;
    std::vector<MaterialMember> members;
};

/// The material of that name, in any case; null if there is none.
const MaterialRow* findMaterial(std::string_view name);
std::span<const std::string_view> materialNames();

}  // namespace glibra::scene
