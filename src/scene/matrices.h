#pragma once
// The matrices of a scene and those that shaders get (language, 6.2). All are double precision and multiply
// column vectors. They are rounded once, when they go to the graphics device.

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace glibra::scene {

/// Sine and cosine of an angle in degrees; exact at multiples of 90 degrees.
double sineOfDegrees(double degrees);
double cosineOfDegrees(double degrees);

glm::dmat4 translation(const glm::dvec3& offset);
glm::dmat4 scaling(const glm::dvec3& factors);
/// Right-handed rotation about an axis through the origin. The axis may have any length; for length zero the
/// result is the identity.
glm::dmat4 rotation(double degrees, const glm::dvec3& axis);

/// The matrix from world to eye space, where the eye is at the origin, `centre` lies on -z, and `up` lies in
/// the half plane x = 0, y > 0. Nothing if eye and centre are the same point or `up` is parallel to the view
/// direction (or zero).
std::optional<glm::dmat4> viewingMatrix(const glm::dvec3& eye, const glm::dvec3& centre,
                                        const glm::dvec3& up);

/// True if the matrix has no useful inverse: its determinant is at most 1e-14 of the product of the lengths
/// of its columns, or not finite.
bool isSingular(const glm::dmat3& matrix);
bool isSingular(const glm::dmat4& matrix);

/// The inverse, or zero if the matrix is singular. The elements may be beyond the range of floats.
glm::dmat4 inverseOrZero(const glm::dmat4& matrix);

/// The matrix for normals: the inverse transpose of the upper left 3 x 3. If that is singular, the result is
/// its cofactor matrix, which gives the same directions except for sign. If the elements are too large or all
/// too small for a float, they are divided by the largest, which keeps directions.
glm::dmat3 normalMatrix(const glm::dmat4& modelView);

/// A matrix with its inverse, its transpose, and its inverse transpose.
struct MatrixFamily {
    glm::dmat4 matrix{1.0};
    glm::dmat4 inverse{1.0};
    glm::dmat4 transpose{1.0};
    glm::dmat4 inverseTranspose{1.0};
};
MatrixFamily familyOf(const glm::dmat4& matrix);

/// All matrices of one draw.
struct DrawMatrices {
    MatrixFamily modelView, projection, modelViewProjection;
    glm::dmat3 normal{1.0};
};
DrawMatrices drawMatrices(const glm::dmat4& modelView, const glm::dmat4& projection);

/// True if all elements are finite as 32-bit floats.
bool isFinite(const glm::dmat4& matrix);

}  // namespace glibra::scene
