#include "scene/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "base/matrices.h"
#include "scene/matrices.h"
#include "scene/texture_parts.h"

namespace glibra::scene {
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
