#pragma once
// Matrices of transforms, views and projections. All are double precision, multiply column vectors, and have
// the clip space of OpenGL (z from -1 to 1).

#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace glibra::base {

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

/// Perspective projection: `degrees` is the vertical full angle, `near` and `far` are distances from the eye.
glm::dmat4 perspectiveProjection(double degrees, double aspect, double near, double far);
/// Parallel projection of a box. `near` and `far` are distances from the eye, and may be negative.
glm::dmat4 boxProjection(double left, double right, double bottom, double top, double near, double far);
/// Perspective projection through a window in the near plane, which need not be centred (glFrustum).
glm::dmat4 frustumProjection(double left, double right, double bottom, double top, double near, double far);

/// True if the matrix has no useful inverse: its determinant is at most 1e-14 of the product of the lengths
/// of its columns, or not finite.
bool isSingular(const glm::dmat2& matrix);
bool isSingular(const glm::dmat3& matrix);
bool isSingular(const glm::dmat4& matrix);

/// The inverse, or zero if the matrix is singular. The elements may be beyond the range of floats.
glm::dmat2 inverseOrZero(const glm::dmat2& matrix);
glm::dmat3 inverseOrZero(const glm::dmat3& matrix);
glm::dmat4 inverseOrZero(const glm::dmat4& matrix);

}  // namespace glibra::base
