// The tessellator by what OpenGL promises: it covers the patch once, whatever the levels, with the vertices
// on an edge that the level of the edge alone gives. The driver's own is the second opinion, in tests/render.

#include "geometry/tessellator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace glibra::geometry {
namespace {

using base::TessellationLayout;
using Domain = TessellationLayout::Domain;
using Spacing = TessellationLayout::Spacing;
using Levels = std::array<float, 6>;

/// Twice the signed area in the first two coordinates.
double area(const std::array<float, 3>& a, const std::array<float, 3>& b, const std::array<float, 3>& c) {
    return (double{b[0]} - a[0]) * (double{c[1]} - a[1]) - (double{c[0]} - a[0]) * (double{b[1]} - a[1]);
}

Levels randomLevels(std::mt19937& random) {
    Levels levels{};
    std::uniform_real_distribution<float> any(.01F, 20), few(.5F, 3);
    for (float& each : levels) each = random() % 3 == 0 ? few(random) : any(random);
    return levels;
}

TEST(Tessellator, TrianglesCoverThePatchOnce) {
    std::mt19937 random(1);
    for (int i = 0; i < 600; ++i) {
        TessellationLayout layout;
        layout.domain = random() % 2 == 0 ? Domain::quads : Domain::triangles;
        layout.spacing = static_cast<Spacing>(random() % 3);
        layout.isClockwise = random() % 2 == 0;
        const std::vector<std::array<float, 3>> made = tessellate(layout, randomLevels(random));
        ASSERT_EQ(made.size() % 3, 0U);
        ASSERT_FALSE(made.empty());
        const double sign = layout.isClockwise ? -1 : 1;
        double sum = 0;
        for (std::size_t at = 0; at < made.size(); at += 3) {
            const double own = sign * area(made[at], made[at + 1], made[at + 2]);
            EXPECT_GE(own, -1e-9);
            sum += own;
        }
        EXPECT_NEAR(sum, layout.domain == Domain::quads ? 2 : 1, 1e-9);
    }
}

TEST(Tessellator, VerticesOnAnEdgeFollowFromItsLevelAlone) {
    std::mt19937 random(2);
    for (int i = 0; i < 300; ++i) {
        TessellationLayout layout;
        layout.domain = Domain::quads;
        layout.spacing = static_cast<Spacing>(random() % 3);
        Levels one = randomLevels(random), other = randomLevels(random);
        one[0] = other[2] = 1 + std::fmod(one[0], 7.F);
        // Vertices inside do not come near the edge.
        for (Levels* each : {&one, &other})
            for (const std::size_t inner : {4U, 5U}) (*each)[inner] = std::max(2.F, (*each)[inner]);
        const auto edge = [&](const Levels& levels, float u) {
            std::set<float> places;
            for (const auto& each : tessellate(layout, levels))
                if (each[0] == u) places.insert(each[1]);
            return places;
        };
        const std::set<float> left = edge(one, 0), right = edge(other, 1);
        EXPECT_EQ(left, right);
        if (layout.spacing == Spacing::equal) {
            EXPECT_EQ(left.size(), static_cast<std::size_t>(std::ceil(one[0])) + 1);
        }
    }
}

TEST(Tessellator, LinesAndPoints) {
    const Levels levels{3, 5, 1, 1, 1, 1};
    EXPECT_EQ(tessellate({.domain = Domain::isolines}, levels).size(), 3U * 5 * 2);
    EXPECT_EQ(tessellate({.domain = Domain::isolines, .asPoints = true}, levels).size(), 3U * 6);
    const std::vector<std::array<float, 3>> points =
        tessellate({.domain = Domain::quads, .asPoints = true}, {4, 4, 4, 4, 4, 4});
    EXPECT_EQ(points.size(), 25U);
    EXPECT_EQ(std::set(points.begin(), points.end()).size(), 25U);
}

TEST(Tessellator, LevelsThatAreNotPositiveDropThePatch) {
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                infinite = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(tessellate({}, {1, 0, 1, 1, 1, 1}).empty());
    EXPECT_TRUE(tessellate({}, {1, 1, -2, 1, 1, 1}).empty());
    EXPECT_TRUE(tessellate({}, {nan, 1, 1, 1, 1, 1}).empty());
    EXPECT_FALSE(tessellate({}, {1, 1, 1, -1, nan, nan}).empty()) << "levels that triangles do not use";
    EXPECT_EQ(tessellate({.domain = Domain::quads}, {infinite, 1e30F, 64, 65, infinite, 1e9F}).size(),
              64U * 64 * 6);
}

}  // namespace
}  // namespace glibra::geometry
