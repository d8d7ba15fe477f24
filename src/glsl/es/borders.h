#pragma once
// GLSL ES 3.00 has textures without borders: what lies outside is read by functions of the shader.

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// The uniform of the sampler `name` that says what its border is, an array of two vec4: 1 for each of s and
/// t that has one, 1 if depths compare as less, 1 for linear filters; then the colour.
inline constexpr const char* kBorderOf = "glibra_Border_";

/// Makes texture(), textureLod() and textureProj() read the borders of two-dimensional samplers; functions
/// with such parameters get the border as a further one. Of arrays of samplers no border is read, and near a
/// border no level but the first.
void passBorders(Unit& unit);

}  // namespace glibra::glsl
