#include "bench/reference/bezier_surface.h"

#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geometry/shapes/teapot.h"

namespace glibra::bench {
namespace {

using FourPoints = std::array<glm::dvec3, 4>;

struct CurvePoint {
    glm::dvec3 position{0}, slope{0};
};

CurvePoint deCasteljau(FourPoints p, double u) {
    for (std::size_t level = 3; level > 1; --level)
        for (std::size_t i = 0; i < level; ++i) p[i] = glm::mix(p[i], p[i + 1], u);
    return {glm::mix(p[0], p[1], u), 3. * (p[1] - p[0])};
}

}  // namespace

PatchPoint patchPoint(const geometry::Patch& patch, const glm::dvec2& st) {
    FourPoints columns, slopes;
    for (std::size_t column = 0; column < 4; ++column) {
        const CurvePoint down =
            deCasteljau({patch[0][column], patch[1][column], patch[2][column], patch[3][column]}, st.y);
        columns[column] = down.position;
        slopes[column] = down.slope;
    }
    const CurvePoint across = deCasteljau(columns, st.x);
    return {across.position, across.slope, deCasteljau(slopes, st.x).position};
}

glm::dvec2 nearestOnPatch(const geometry::Patch& patch, const glm::dvec3& point, glm::dvec2 start) {
    constexpr int kSteps = 4;
    constexpr double kDamping = 1e-9;  // prevents a division by 0 at the poles, where dP/ds is 0
    glm::dvec2 st = start;
    for (int i = 0; i < kSteps; ++i) {
        const PatchPoint at = patchPoint(patch, st);
        const glm::dvec3 miss = point - at.position;
        const double ss = glm::dot(at.alongS, at.alongS) + kDamping,
                     tt = glm::dot(at.alongT, at.alongT) + kDamping, mixed = glm::dot(at.alongS, at.alongT);
        const double s = glm::dot(at.alongS, miss), t = glm::dot(at.alongT, miss);
        const double determinant = ss * tt - mixed * mixed;
        const glm::dvec2 step((tt * s - mixed * t) / determinant, (ss * t - mixed * s) / determinant);
        st = glm::clamp(st + step, 0., 1.);
    }
    return st;
}

TeapotPatches placedTeapotPatches() {
    TeapotPatches patches = geometry::teapotPatches();
    for (geometry::Patch& patch : patches)
        for (auto& row : patch)
            for (glm::dvec3& point : row) point = geometry::teapotPlace(point);
    return patches;
}

}  // namespace glibra::bench
