#include "scene/view.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "scene/textures.h"

namespace glibra::scene {

// ---- Matrices

namespace {

double largestElement(const glm::dmat3& matrix) {
    double largest = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(matrix[i][j]));
    return largest;
}

/// Returns matrix * factor. If a float cannot hold the largest element of that product, the matrix is divided
/// by its largest element instead.
glm::dmat3 timesWithinFloats(const glm::dmat3& matrix, double factor) {
    const double largest = largestElement(matrix);
    const double product = largest * factor;
    const bool fits =
        product >= std::numeric_limits<float>::min() && product <= std::numeric_limits<float>::max();
    if (largest == 0 || fits) return matrix * factor;
    return matrix / largest;
}

}  // namespace

glm::dmat3 normalMatrix(const glm::dmat4& modelView) {
    // Dividing by a power of two first keeps the products of very small and very large elements in range,
    // and changes no bit of them.
    glm::dmat3 linear(modelView);
    const double largest = largestElement(linear);
    if (!(largest > 0) || !std::isfinite(largest)) return glm::dmat3(0.0);
    const double unit = std::ldexp(1.0, std::ilogb(largest));
    linear /= unit;
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    if (isSingular(linear)) return timesWithinFloats(cofactors, unit * unit);
    const double determinant = glm::dot(linear[0], cofactors[0]);
    return timesWithinFloats(cofactors / determinant, 1 / unit);
}

bool isFinite(const glm::dmat4& matrix) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            if (!(std::abs(matrix[i][j]) <= std::numeric_limits<float>::max())) return false;
    return true;
}

// ---- Cameras

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

// ---- Views

namespace {

constexpr double kRounding = 1e-9;

/// The limits of one axis. Equal limits stand for -1 and 1.
struct Range {
    double low, high;
    [[nodiscard]] double size() const { return high - low; }
    /// The range with the same centre and direction, `factor` times as long.
    [[nodiscard]] Range grown(double factor) const {
        const double centre = (low + high) / 2;
        const double half = size() / 2 * factor;
        return {centre - half, centre + half};
    }
};
Range rangeOf(double low, double high) {
    if (low == high) return {-1, 1};
    return {low, high};
}

glm::dmat4 orthographicMatrix(const Orthographic& view, double aspect) {
    Range x = rangeOf(view.left, view.right);
    Range y = rangeOf(view.bottom, view.top);
    const double boxAspect = std::abs(x.size()) / std::abs(y.size());
    if (boxAspect > aspect)
        y = y.grown(boxAspect / aspect);
    else if (boxAspect < aspect)
        x = x.grown(aspect / boxAspect);
    return base::boxProjection(x.low, x.high, y.low, y.high, view.near, view.far);
}

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
    [[nodiscard]] bool isEmpty() const { return !(low.x <= high.x); }
    void add(const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void add(const Box& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
};

/// Calls `use(eye space position, w)` for every finite vertex. The position does not contain w.
template <class Use>
void eachVertex(const geometry::Mesh& mesh, const glm::dmat4& modelView, const Use& use) {
    const geometry::Attribute* position = mesh.attribute(geometry::kPosition);
    if (position == nullptr || position->components < 3) return;
    const auto stride = static_cast<std::size_t>(position->components);
    const std::vector<float>& values = position->values;
    for (std::size_t i = 0; i + stride <= values.size(); i += stride) {
        const double x = static_cast<double>(values[i]);
        const double y = static_cast<double>(values[i + 1]);
        const double z = static_cast<double>(values[i + 2]);
        const double w = stride > 3 ? static_cast<double>(values[i + 3]) : 1;
        if (!std::isfinite(x + y + z + w)) continue;
        use(glm::dvec3(modelView * glm::dvec4(x, y, z, 1)), w);
    }
}

struct SeenDraw {
    const Draw* draw;
    double aspect;
};

std::vector<SeenDraw> perspectiveDraws(const Scene& scene, double windowAspect) {
    std::vector<SeenDraw> draws;
    for (const Pass& pass : scene.frame.passes)
        for (const auto& step : pass.steps)
            if (const Draw* draw = std::get_if<Draw>(&step);
                draw && !draw->isSky && std::holds_alternative<Perspective>(*draw->projection))
                draws.push_back({draw, aspectOf(scene, pass, windowAspect)});
    return draws;
}

/// Half of the draw's field of view in radians, vertical or horizontal, whichever is smaller.
double halfAngle(const SeenDraw& seen) {
    const double half = std::get<Perspective>(*seen.draw->projection).fieldOfView / 2;
    const double tangent = sineOfDegrees(half) / cosineOfDegrees(half);
    return std::atan(std::min(tangent, seen.aspect * tangent));
}

/// The sphere that contains all vertices, around the centre of their box.
struct Sphere {
    glm::dvec3 centre{0.0};
    double radius = 0;
};

std::optional<Sphere> sphereAround(const std::vector<SeenDraw>& draws, const MeshOf& meshOf,
                                   double& nearest) {
    Box all;
    for (const SeenDraw& seen : draws) {
        const geometry::Mesh* mesh = meshOf(seen.draw->shape);
        if (mesh == nullptr) continue;
        Box box;
        eachVertex(*mesh, seen.draw->modelView, [&](const glm::dvec3& point, double) { box.add(point); });
        if (box.isEmpty()) continue;
        const double near = std::get<Perspective>(*seen.draw->projection).near;
        if (box.high.z <= -near) return std::nullopt;  // the scene is laid out for an eye at the origin
        nearest = std::max(nearest, near);
        all.add(box);
    }
    if (all.isEmpty()) return std::nullopt;
    // A second walk over the vertices costs less than storing them in eye space.
    Sphere sphere{(all.low + all.high) * .5, 0};
    for (const SeenDraw& seen : draws) {
        const geometry::Mesh* mesh = meshOf(seen.draw->shape);
        if (mesh == nullptr) continue;
        eachVertex(*mesh, seen.draw->modelView, [&](const glm::dvec3& point, double w) {
            const glm::dvec3 offset = point - sphere.centre;
            const double extra = w == 0 || w == 1 ? 0 : std::abs(w);
            sphere.radius =
                std::max(sphere.radius,
                         std::sqrt(offset.x * offset.x + offset.y * offset.y + offset.z * offset.z) + extra);
        });
    }
    return sphere;
}

}  // namespace

glm::dmat4 projectionMatrix(const Projection& projection, double aspect) {
    if (const auto* perspective = std::get_if<Perspective>(&projection))
        return base::perspectiveProjection(perspective->fieldOfView, aspect, perspective->near,
                                           perspective->far);
    if (const auto* box = std::get_if<Orthographic>(&projection)) return orthographicMatrix(*box, aspect);
    if (const auto* matrix = std::get_if<glm::dmat4>(&projection)) return *matrix;
    return glm::dmat4(1);
}

double aspectOf(const Scene& scene, const Pass& pass, double windowAspect) {
    if (pass.isWindow) return windowAspect;
    const auto size = targetSize(scene, pass);
    return size ? static_cast<double>((*size)[0]) / (*size)[1] : windowAspect;
}

ViewMove autoView(const Scene& scene, const MeshOf& meshOf, double windowAspect) {
    ViewMove move;
    if (scene.usesLookAt) return move;
    const std::vector<SeenDraw> draws = perspectiveDraws(scene, windowAspect);
    if (draws.empty()) return move;
    double near = 0;
    const auto sphere = sphereAround(draws, meshOf, near);
    if (!sphere || sphere->centre.z + sphere->radius <= -near) return move;

    double angle = halfAngle(draws.front());
    for (const SeenDraw& seen : draws) angle = std::min(angle, halfAngle(seen));
    const glm::dvec3 c = sphere->centre;
    const double distance = (sphere->radius + std::hypot(c.x, c.y) * std::cos(angle)) / std::sin(angle);
    // kRounding keeps a multiple of 1/16 from being rounded up because of rounding errors.
    const double moved = std::ceil(16 * (distance + c.z) - kRounding) / 16;
    if (!(moved > 0) || !std::isfinite(moved)) return move;
    move.distance = moved;
    move.diagnostics.push_back(diagnose(
        "draw-N01",
        fmt::format("no LookAt, so the eye is moved back by {} along z (use --eye glman to switch this off)",
                    moved),
        draws.front().draw->place));
    return move;
}

}  // namespace glibra::scene
