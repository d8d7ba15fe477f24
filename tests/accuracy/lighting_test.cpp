#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "bench/core/figure.h"
#include "bench/reference/lighting.h"
#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

/// The torus as a polynomial: 0 on the surface, positive outside.
double quartic(const glm::dvec3& p) {
    const double ring = kRingRadius, tube = kTubeRadius;
    const double sum = glm::dot(p, p) + ring * ring - tube * tube;
    return sum * sum - 4 * ring * ring * (p.x * p.x + p.y * p.y);
}

/// The normal from small steps and bisection along the ray, and from differences of the polynomial.
std::optional<glm::dvec3> steppedNormal(double x, double y) {
    const glm::dmat3 toModel = glm::inverse(torusRotation());
    const auto at = [&](double z) { return quartic(toModel * glm::dvec3(x, y, z)); };
    constexpr double kStep = 1e-3, kDifference = 1e-5;
    for (int i = 0; i < 2200; ++i) {
        const double z = 1.1 - i * kStep;
        if (at(z) > 0) continue;
        double inside = z, outside = z + kStep;
        for (int halving = 0; halving < 50; ++halving) {
            const double middle = (inside + outside) / 2;
            (at(middle) > 0 ? outside : inside) = middle;
        }
        const glm::dvec3 p(x, y, inside);
        glm::dvec3 gradient;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 step(0);
            step[axis] = kDifference;
            gradient[axis] = quartic(toModel * (p + step)) - quartic(toModel * (p - step));
        }
        return glm::normalize(gradient);
    }
    return std::nullopt;
}

TEST(AnalyticTorus, HasTheNormalsOfItsPolynomial) {
    int hits = 0;
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j) {
            const double x = -1.03 + 2.06 * i / 39, y = -1.03 + 2.06 * j / 39;
            const auto stepped = steppedNormal(x, y), traced = normalAt(LitSurface::torus, x, y);
            // Steps of a thousandth miss parts that a ray only grazes.
            if (traced && traced->z > .1) {
                ASSERT_TRUE(stepped) << x << " " << y;
                EXPECT_NEAR(glm::length(*traced - *stepped), 0, 1e-6) << x << " " << y;
                ++hits;
            }
            EXPECT_TRUE(traced || !stepped) << x << " " << y;
        }
    EXPECT_GT(hits, 300);
}

TEST(AnalyticHighlights, AreCosinesOfTheAngleAndOfTwiceIt) {
    const glm::dvec3 light(0, 0, 1);  // from the direction of the viewer
    for (const double angle : {0., .2, .5, .7}) {
        const glm::dvec3 normal(std::sin(angle), 0, std::cos(angle));
        EXPECT_NEAR(highlight(Highlight::reflection, normal, light, 5), std::pow(std::cos(2 * angle), 5),
                    1e-12);
        EXPECT_NEAR(highlight(Highlight::halfVector, normal, light, 5), std::pow(std::cos(angle), 5), 1e-12);
    }
    EXPECT_EQ(highlight(Highlight::halfVector, {0, 0, -1}, light, 5), 0);
    EXPECT_NEAR(intensity(Highlight::reflection, {0, 0, 1}, light, 32), 1, 1e-12);
}

using MeasuredLighting = FiguresOf<measureLighting>;

TEST_F(MeasuredLighting, ConvergesToTheAnalyticSurface) {
    for (const char* name : {"sphere", "torus"}) {
        const Figure& figure = figureOf(figures, name);
        ASSERT_EQ(figure.curves.size(), 4U);
        for (const Curve& curve : figure.curves) {
            EXPECT_LT(fittedOrder(curve), -1) << name << ", " << curve.name;
            EXPECT_LT(curve.points.back().error, .02) << name << ", " << curve.name;
            EXPECT_GT(curve.points.back().error, 1e-5) << "the mesh must show: " << curve.name;
        }
        const auto last = [&](std::size_t curve) { return figure.curves[curve].points.back().error; };
        EXPECT_LT(last(2), .5 * last(0)) << "renormalised against per vertex, " << name;
        EXPECT_LT(last(2), .5 * last(1)) << "renormalised against as interpolated, " << name;
    }
}

TEST_F(MeasuredLighting, OfTheReflectionInAShaderIsThatOfTheReference) {
    const Figure& figure = figureOf(figures, "highlight-models");
    for (const Point& point : figure.curves.front().points) EXPECT_LT(point.error, 1e-5) << point.label;
}

TEST_F(MeasuredLighting, FindsThatFourTimesTheExponentMatchesTheReflection) {
    // cos(2a) and cos(a)^4 are both 1 - 2a^2 up to a^4: near the direction of the view, the factor is 4.
    const Figure& figure = figureOf(figures, "half-vector");
    for (std::size_t i = 0; i < 3; ++i) {
        const std::vector<Point>& points = figure.curves[i].points;
        const auto best = std::min_element(points.begin(), points.end(),
                                           [](const Point& a, const Point& b) { return a.error < b.error; });
        EXPECT_EQ(best->setting, 4) << figure.curves[i].name;
        EXPECT_LT(best->error, .1 * points.front().error);
    }
}

}  // namespace
}  // namespace glibra::bench::test
