#include "scene/camera.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/trigonometric.hpp>

#include "scene/matrices.h"

namespace glibra::scene {

glm::dmat4 CameraValues::inverseView() const {
    return inverseOrZero(view);
}

glm::dvec3 CameraValues::position() const {
    return glm::dvec3(inverseView()[3]);
}

glm::dvec3 CameraValues::direction() const {
    const glm::dvec3 backward(inverseView()[2]);
    const double length = glm::length(backward);
    return length > 0 ? -backward / length : glm::dvec3(0, 0, -1);
}

glm::dmat4 CameraValues::shadow() const {
    return translation({.5, .5, .5}) * scaling({.5, .5, .5}) * viewProjection();
}

Lens lensOf(const glm::dmat4& projection) {
    const auto isRow = [&](const glm::dvec4& row) { return glm::row(projection, 3) == row; };
    const double w = projection[2][3] != 0 ? -projection[2][3] : projection[3][3];
    const double depth = projection[2][2] / w, shift = projection[3][2] / w;
    if (w != 0 && isRow({0, 0, 0, w})) return {(shift + 1) / depth, (shift - 1) / depth, 0};
    if (w == 0 || !isRow({0, 0, -w, 0})) return {};
    const double height = projection[1][1] / w, middle = projection[2][1] / w;
    const double angle = std::atan((middle + 1) / height) - std::atan((middle - 1) / height);
    return {shift / (depth - 1), shift / (depth + 1), std::abs(glm::degrees(angle))};
}

glm::dmat4 reflection(const glm::dvec3& normal, double d) {
    const double squared = glm::dot(normal, normal);
    glm::dmat4 result(1.0);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) result[column][row] -= 2 * normal[column] * normal[row] / squared;
    for (int row = 0; row < 3; ++row) result[3][row] = -2 * d * normal[row] / squared;
    return result;
}

glm::dmat4 withNearPlane(const glm::dmat4& projection, const glm::dvec4& plane) {
    // The corner of the far plane that lies opposite to the new plane stays a corner of the far plane.
    const glm::dvec4 corner =
        inverseOrZero(projection) * glm::dvec4(plane.x < 0 ? -1 : 1, plane.y < 0 ? -1 : 1, 1, 1);
    const glm::dvec4 scaled = plane * (2 / glm::dot(plane, corner));
    glm::dmat4 result = projection;
    for (int column = 0; column < 4; ++column) result[column][2] = scaled[column] - projection[column][3];
    return result;
}

glm::dmat4 faceView(int face, const glm::dvec3& eye) {
    struct Axes {
        glm::dvec3 direction, up;
    };
    // The s and t axes of each face: OpenGL 4.5, table 8.19. Rows of a texture run from its first texel
    // upward.
    static constexpr std::array<Axes, 6> kFaces{{{{1, 0, 0}, {0, -1, 0}},
                                                 {{-1, 0, 0}, {0, -1, 0}},
                                                 {{0, 1, 0}, {0, 0, 1}},
                                                 {{0, -1, 0}, {0, 0, -1}},
                                                 {{0, 0, 1}, {0, -1, 0}},
                                                 {{0, 0, -1}, {0, -1, 0}}}};
    const Axes& axes = kFaces.at(static_cast<std::size_t>(face));
    return viewingMatrix(eye, eye + axes.direction, axes.up).value_or(glm::dmat4(1.0));
}

}  // namespace glibra::scene
