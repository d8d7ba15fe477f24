#pragma once
// GLSL ES 3.00 has textures without borders: what lies outside is read by functions of the shader.

#include <cstdint>

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// The uniform of the sampler `name` that says what its border is, an array of two vec4: 1 for each of s and
/// t that has one, 1 if depths compare as less, 1 for linear filters; then the colour.
inline constexpr const char* kBorderOf = "glibra_Border_";

/// Makes a call of texture(), textureLod() or textureProj() with a two-dimensional sampler that is a uniform
/// read its border. Near a border no level but the first is read.
void readBorders(Unit& unit, const Call& call);

}  // namespace glibra::glsl
