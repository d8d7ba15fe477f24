#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "bench/core/figure.h"
#include "bench/reference/lighting.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

TEST(VolumeFieldInDouble, IsItsTexelsAndLinearBetweenThem) {
    const VolumeField field = blobs(16);
    const auto texel = [&](int x, int y, int z) {
        return static_cast<double>(field.texels[field.index(x, y, z)]);
    };
    for (int i = 1; i < 15; ++i) {
        const glm::dvec3 centre = (glm::dvec3(i, 15 - i, (7 * i) % 16) + .5) / 16.;
        EXPECT_NEAR(field.at(centre), texel(i, 15 - i, (7 * i) % 16), 1e-12);
        EXPECT_NEAR(field.at(centre - glm::dvec3(.25 / 16, 0, 0)),
                    .75 * texel(i, 15 - i, (7 * i) % 16) + .25 * texel(i - 1, 15 - i, (7 * i) % 16), 1e-12);
    }
    EXPECT_EQ(field.at({-1, -1, -1}), texel(0, 0, 0));
}

TEST(VolumeFieldInDouble, IsZeroInBlocksWhoseMaximumIsZero) {
    const VolumeField field = blobs(32), blocks = blockMaxima(field, 4);
    ASSERT_EQ(blocks.side, 8);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(0, 1);
    int empty = 0;
    for (int i = 0; i < 20'000; ++i) {
        const glm::dvec3 p(anywhere(random), anywhere(random), anywhere(random));
        const glm::ivec3 block(p * 8.);
        const float most = blocks.texels[blocks.index(block.x, block.y, block.z)];
        EXPECT_LE(field.at(p), static_cast<double>(most) + 1e-12);
        if (most == 0) ++empty;
    }
    EXPECT_GT(empty, 4'000) << "there must be something to skip";
    EXPECT_LT(empty, 19'000);
}

TEST(VolumeIntegral, OfAConstantDensityIsTheClosedForm) {
    const VolumeField field{2, std::vector<float>(8, .25F)};
    const auto ray = volumeRay(.1, -.2);
    ASSERT_TRUE(ray);
    const double opacity = 1 - std::exp(-12 * .25 * (ray->leave - ray->enter));
    for (const int steps : {1, 7, 300}) {
        const VolumeLight light = integrate(field, *ray, 12, steps);
        EXPECT_NEAR(light.opacity, opacity, 1e-12);
        EXPECT_NEAR(light.light, opacity * (.2 + .8 * .25), 1e-12);
    }
}

TEST(VolumeIntegral, ConvergesByTheSquareOfTheSteps) {
    const VolumeField field = blobs(32);
    const auto ray = volumeRay(.05, .1);
    ASSERT_TRUE(ray);
    const double fine = integrate(field, *ray, 20, 100'000).light;
    const double coarse = std::abs(integrate(field, *ray, 20, 200).light - fine);
    const double finer = std::abs(integrate(field, *ray, 20, 1600).light - fine);
    EXPECT_LT(finer, coarse / 20);
}

TEST(VolumeRays, AreInsideTheCubeBetweenTheirEnds) {
    int hits = 0;
    for (int i = -10; i <= 10; ++i)
        for (int j = -10; j <= 10; ++j) {
            const auto ray = volumeRay(i / 10., j / 10.);
            if (!ray) continue;
            ++hits;
            EXPECT_NEAR(glm::length(ray->direction), 1, 1e-12);
            for (const double t : {ray->enter, (ray->enter + ray->leave) / 2, ray->leave}) {
                const glm::dvec3 p = ray->origin + t * ray->direction;
                for (int axis = 0; axis < 3; ++axis) {
                    EXPECT_GE(p[axis], -1e-12);
                    EXPECT_LE(p[axis], 1 + 1e-12);
                }
            }
        }
    EXPECT_GT(hits, 100);
    EXPECT_FALSE(volumeRay(1, 1));
}

TEST(MeasuredVolume, SkipsWithoutAChangeAndEndsWithinItsThreshold) {
    Bench bench({.quick = true});
    const std::vector<Figure> figures = measureVolume(bench);
    ASSERT_EQ(figures.size(), 2U);
    const Figure& steps = figures.front();
    EXPECT_LT(fittedOrder(steps.curves[0], 16), -1.7) << "the middle of each step: second order";
    EXPECT_NEAR(fittedOrder(steps.curves[2], 16), -1, .3) << "linear opacity: first order";
    for (std::size_t i = 0; i < steps.curves[0].points.size(); ++i)
        EXPECT_EQ(steps.curves[0].points[i].error, steps.curves[4].points[i].error) << "skipping";
    EXPECT_TRUE(std::ranges::any_of(steps.findings, [](const std::string& each) {
        return each.find("changes 0 of") != std::string::npos;
    }));
    for (const Curve& curve : figures.back().curves)
        for (const Point& point : curve.points) EXPECT_LE(point.error, point.setting) << curve.name;
    EXPECT_GT(figures.back().curves.back().points.front().error, .01) << "ending early must show";
}

}  // namespace
}  // namespace glibra::bench
