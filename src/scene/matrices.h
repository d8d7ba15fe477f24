#pragma once
// The matrices of a scene and those that shaders get (language, 6.2). All are double precision and multiply
// column vectors. They are rounded once, when they go to the graphics device.

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "base/matrices.h"

namespace glibra::scene {

using base::cosineOfDegrees;
using base::inverseOrZero;
using base::isSingular;
using base::rotation;
using base::scaling;
using base::sineOfDegrees;
using base::translation;
using base::viewingMatrix;

/// The matrix for normals: the inverse transpose of the upper left 3 x 3. If that is singular, the result is
/// its cofactor matrix, which gives the same directions except for sign. If the elements are too large or all
/// too small for a float, they are divided by the largest, which keeps directions.
glm::dmat3 normalMatrix(const glm::dmat4& modelView);

/// True if all elements are finite as 32-bit floats.
bool isFinite(const glm::dmat4& matrix);

}  // namespace glibra::scene
