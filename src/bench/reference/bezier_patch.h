#pragma once
// Bicubic patches in double.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/shapes/teapot.h"

namespace glibra::bench {

struct PatchPoint {
    glm::dvec3 position{0}, alongS{0}, alongT{0};  ///< position, and derivatives by s and t
};

struct CurvePoint {
    glm::dvec3 position{0}, slope{0};
};

inline CurvePoint deCasteljau(std::array<glm::dvec3, 4> p, double u) {
    for (std::size_t level = 3; level > 1; --level)
        for (std::size_t i = 0; i < level; ++i) p[i] = glm::mix(p[i], p[i + 1], u);
    return {glm::mix(p[0], p[1], u), 3. * (p[1] - p[0])};
}

/// By de Casteljau's algorithm, which orders its operations differently from Bernstein polynomials.
inline PatchPoint patchPoint(const geometry::Patch& patch, const glm::dvec2& st) {
    std::array<glm::dvec3, 4> columns, slopes;
    for (std::size_t column = 0; column < 4; ++column) {
        const CurvePoint down =
            deCasteljau({patch[0][column], patch[1][column], patch[2][column], patch[3][column]}, st.y);
        columns[column] = down.position;
        slopes[column] = down.slope;
    }
    const CurvePoint across = deCasteljau(columns, st.x);
    return {across.position, across.slope, deCasteljau(slopes, st.x).position};
}

/// The parameters, within 0..1, of the point of the patch that is nearest to `point`, searched from `start`
/// by damped Gauss-Newton steps.
inline glm::dvec2 nearestOnPatch(const geometry::Patch& patch, const glm::dvec3& point, glm::dvec2 start) {
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

using TeapotPatches = std::array<geometry::Patch, 32>;

/// The patches of the teapot at their places in the meshes of scenes, whose body is two units wide.
inline TeapotPatches placedTeapotPatches() {
    TeapotPatches patches = geometry::teapotPatches();
    for (geometry::Patch& patch : patches)
        for (auto& row : patch)
            for (glm::dvec3& point : row) point = geometry::teapotPlace(point);
    return patches;
}

/// The volume between the patches and the origin, which also exists for the teapot although it is open: the
/// integral of P . (Ps x Pt) / 3, a polynomial of degree 8 in s and in t, for which five Gauss points are
/// exact.
inline double patchVolume(const TeapotPatches& patches) {
    constexpr std::array<std::array<double, 2>, 5> kGauss{{{-.9061798459386640, .2369268850561891},
                                                           {-.5384693101056831, .4786286704993665},
                                                           {0, .5688888888888889},
                                                           {.5384693101056831, .4786286704993665},
                                                           {.9061798459386640, .2369268850561891}}};
    double sum = 0;
    for (const geometry::Patch& patch : patches)
        for (const auto& [s, weightS] : kGauss)
            for (const auto& [t, weightT] : kGauss) {
                const PatchPoint at = patchPoint(patch, {(s + 1) / 2, (t + 1) / 2});
                sum += weightS * weightT / 4 * glm::dot(at.position, glm::cross(at.alongS, at.alongT)) / 3;
            }
    return std::abs(sum);
}

/// The extent of the patches in a direction: the best of 17 x 17 points of each patch, refined by ever
/// smaller steps.
class PatchExtent {
  public:
    explicit PatchExtent(const TeapotPatches& patches) : patches_(patches) {
        for (std::size_t patch = 0; patch < patches.size(); ++patch)
            for (int j = 0; j <= kCells; ++j)
                for (int i = 0; i <= kCells; ++i) {
                    const glm::dvec2 st = glm::dvec2(i, j) / static_cast<double>(kCells);
                    places_.push_back({patch, st, patchPoint(patches[patch], st).position});
                }
    }

    [[nodiscard]] double operator()(const glm::dvec3& direction) const {
        const Place& best = *std::ranges::max_element(
            places_, {}, [&](const Place& each) { return glm::dot(each.position, direction); });
        glm::dvec2 at = best.st;
        double farthest = glm::dot(best.position, direction);
        for (double step = 1. / kCells; step > 1e-7;) {
            bool isBetter = false;
            for (const glm::dvec2 side : {glm::dvec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                const glm::dvec2 there = glm::clamp(at + step * side, 0., 1.);
                const double reach = glm::dot(patchPoint(patches_[best.patch], there).position, direction);
                if (reach <= farthest) continue;
                farthest = reach;
                at = there;
                isBetter = true;
            }
            if (!isBetter) step /= 2;
        }
        return farthest;
    }

  private:
    static constexpr int kCells = 16;
    struct Place {
        std::size_t patch = 0;
        glm::dvec2 st{0};
        glm::dvec3 position{0};
    };
    const TeapotPatches& patches_;
    std::vector<Place> places_;
};

}  // namespace glibra::bench
