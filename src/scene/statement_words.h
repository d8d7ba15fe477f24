#pragma once
// The words that a value of a modern statement may be where its syntax lists none (glib/statement_table.h).

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace glibra::scene {

inline constexpr std::array<std::string_view, 6> kAttributeRoles{geometry::kPosition, geometry::kNormal,
                                                                 geometry::kTangent,  geometry::kTexCoord,
                                                                 geometry::kColor,    geometry::kFaceIndex};
/// Of Key, besides letters and digits.
inline constexpr std::string_view kKeyNames[] = {"space", "enter", "left", "right", "up", "down"};

std::span<const std::string_view> materialNames();  // tags.cpp
std::vector<std::string_view> bufferTypes();        // buffers.cpp; structures of shaders are types, too
std::vector<std::string_view> meshShapes();         // buffers.cpp

}  // namespace glibra::scene
