// Triangles of polygons that are no fans: they cover the outline and nothing else.

#include "geometry/obj/concave_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <numbers>
#include <set>
#include <string>

#include "geometry/mix.h"
#include "geometry/obj/obj_model.h"

namespace glibra::geometry {
namespace {

struct Lattice {
    std::int64_t x = 0, y = 0;
    friend auto operator<=>(const Lattice&, const Lattice&) = default;
};

std::int64_t turn(Lattice a, Lattice b, Lattice c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int signOf(std::int64_t value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

bool isBetween(Lattice a, Lattice b, Lattice p) {
    return turn(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
           std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

bool haveCommonPoint(Lattice a, Lattice b, Lattice c, Lattice d) {
    if (isBetween(a, b, c) || isBetween(a, b, d) || isBetween(c, d, a) || isBetween(c, d, b)) return true;
    return signOf(turn(a, b, c)) * signOf(turn(a, b, d)) < 0 &&
           signOf(turn(c, d, a)) * signOf(turn(c, d, b)) < 0;
}

/// True if no edges have a common point but the corner of neighbours.
bool isSimple(const std::vector<Lattice>& outline) {
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 1; k < n; ++k) {
            const Lattice a = outline[i], b = outline[(i + 1) % n], c = outline[k], d = outline[(k + 1) % n];
            if (k == i + 1         ? a == b || isBetween(a, b, d) || isBetween(c, d, a)
                : (k + 1) % n == i ? isBetween(c, d, b) || isBetween(a, b, c)
                                   : haveCommonPoint(a, b, c, d))
                return false;
        }
    return true;
}

std::int64_t twiceArea(const std::vector<Lattice>& outline) {
    std::int64_t area = 0;
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) area += turn(outline[0], outline[i], outline[i + 1]);
    return area;
}

/// The outline in one of six planes, all exact in float: the three axes, and oblique ones.
std::vector<Triple> inPlane(const std::vector<Lattice>& outline, int plane) {
    std::vector<Triple> points;
    for (const Lattice& each : outline) {
        const auto x = static_cast<float>(each.x), y = static_cast<float>(each.y);
        switch (plane) {
            case 0:
                points.push_back({x, y, 7});
                break;
            case 1:
                points.push_back({-3, x, y});
                break;
            case 2:
                points.push_back({y, 0, x});
                break;
            case 3:
                points.push_back({x, y, 3 * x - 2 * y});
                break;
            case 4:
                points.push_back({x / 1024, x / 1024, y / 4096});
                break;
            default:
                points.push_back({5 * y - x, x, y});
                break;
        }
    }
    return points;
}

/// The triangles of a face as ObjModel says them.
std::vector<std::uint32_t> trianglesOf(const std::vector<Triple>& outline) {
    std::vector<std::uint32_t> triangles;
    if (isFan(outline)) {
        for (std::uint32_t i = 1; i + 1 < outline.size(); ++i)
            triangles.insert(triangles.end(), {0, i, i + 1});
        return triangles;
    }
    EXPECT_TRUE(EarCutter().cut(outline, triangles));
    return triangles;
}

/// Triangles that all turn as the outline does, and whose sides cancel each other but for its edges, cover it
/// once and nothing else: a point is in as many of them as the outline winds around it.
void expectCovered(const std::vector<Lattice>& outline, int plane) {
    const std::vector<std::uint32_t> triangles = trianglesOf(inPlane(outline, plane));
    ASSERT_EQ(triangles.size(), 3 * (outline.size() - 2));
    const int winding = signOf(twiceArea(outline));
    std::int64_t area = 0;
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        for (std::size_t side = 0; side < 3; ++side) {
            ASSERT_LT(triangles[i + side], outline.size());
            const std::pair one{triangles[i + side], triangles[i + (side + 1) % 3]};
            const auto back = sides.find({one.second, one.first});
            if (back != sides.end())
                sides.erase(back);
            else
                sides.insert(one);
        }
        const std::int64_t one =
            turn(outline[triangles[i]], outline[triangles[i + 1]], outline[triangles[i + 2]]);
        EXPECT_GE(one * winding, 0);
        area += one;
    }
    EXPECT_EQ(area, twiceArea(outline));
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::uint32_t i = 0; i < outline.size(); ++i)
        edges.emplace(i, (i + 1) % static_cast<std::uint32_t>(outline.size()));
    EXPECT_EQ(sides, edges);
}

/// From every first corner, in both directions, in a plane.
void expectCoveredFromEverywhere(std::vector<Lattice> outline, int plane) {
    for (int direction = 0; direction < 2; ++direction) {
        for (std::size_t first = 0; first < outline.size(); ++first) {
            expectCovered(outline, plane);
            if (::testing::Test::HasFailure()) {
                std::string text = "plane " + std::to_string(plane) + ":";
                for (const Lattice& each : outline)
                    text += " (" + std::to_string(each.x) + ", " + std::to_string(each.y) + ")";
                FAIL() << text;
            }
            std::rotate(outline.begin(), outline.begin() + 1, outline.end());
        }
        std::reverse(outline.begin(), outline.end());
    }
}

/// A random outline that does not touch itself, on a small lattice, so that many corners lie on lines; empty
/// if none was found.
std::vector<Lattice> randomOutline(std::uint32_t seed) {
    std::uint32_t counter = 0;
    const auto below = [&](std::size_t count) {
        return mix(mix(counter++) ^ (seed * 0x9e3779b9U)) % static_cast<std::uint32_t>(count);
    };
    const std::size_t size = 3 + below(7), count = 4 + below(std::min<std::size_t>(14, size * size / 2));
    std::set<Lattice> used;
    std::vector<Lattice> outline;
    while (outline.size() < count) {
        const Lattice one{below(size), below(size)};
        if (used.insert(one).second) outline.push_back(one);
    }
    // Turning the part between two edges that cross makes the outline shorter, so this ends.
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i + 2 < count; ++i)
            for (std::size_t k = i + 2; k < count; ++k) {
                const Lattice a = outline[i], b = outline[i + 1], c = outline[k],
                              d = outline[(k + 1) % count];
                if (a == d || signOf(turn(a, b, c)) * signOf(turn(a, b, d)) >= 0 ||
                    signOf(turn(c, d, a)) * signOf(turn(c, d, b)) >= 0)
                    continue;
                std::reverse(outline.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                             outline.begin() + static_cast<std::ptrdiff_t>(k) + 1);
                changed = true;
            }
    }
    return isSimple(outline) && twiceArea(outline) != 0 ? outline : std::vector<Lattice>{};
}

TEST(ConcaveFaces, RandomOutlinesAreCoveredFromEveryCornerInBothDirectionsInAnyPlane) {
    int tried = 0, concave = 0;
    for (std::uint32_t seed = 0; seed < 3000 && !HasFailure(); ++seed) {
        const std::vector<Lattice> outline = randomOutline(seed);
        if (outline.empty()) continue;
        ++tried;
        concave += isFan(inPlane(outline, 0)) ? 0 : 1;
        expectCoveredFromEverywhere(outline, static_cast<int>(seed % 6));
    }
    EXPECT_GT(tried, 1000);
    EXPECT_GT(concave, 700);
}

TEST(ConcaveFaces, AFaceWithAHoleIsCoveredAroundTheHole) {
    // The seam goes from corner `outer` to corner `inner` and back.
    const std::vector<Lattice> around{{0, 0}, {6, 0}, {12, 0}, {12, 12}, {5, 9}, {0, 12}, {0, 5}};
    const std::vector<Lattice> hole{{3, 3}, {3, 6}, {5, 5}, {8, 7}, {8, 3}};
    for (std::size_t outer = 0; outer < around.size(); ++outer)
        for (std::size_t inner = 0; inner < hole.size(); ++inner) {
            bool isFree = true;
            for (const auto& ring : {around, hole})
                for (std::size_t i = 0; i < ring.size(); ++i) {
                    const Lattice a = ring[i], b = ring[(i + 1) % ring.size()];
                    const bool isOwn =
                        a == around[outer] || b == around[outer] || a == hole[inner] || b == hole[inner];
                    isFree = isFree && (isOwn || !haveCommonPoint(a, b, around[outer], hole[inner]));
                }
            if (!isFree) continue;
            std::vector<Lattice> outline;
            for (std::size_t i = 0; i <= around.size(); ++i)
                outline.push_back(around[(outer + i) % around.size()]);
            for (std::size_t i = 0; i <= hole.size(); ++i) outline.push_back(hole[(inner + i) % hole.size()]);
            expectCoveredFromEverywhere(outline, static_cast<int>((outer + inner) % 6));
        }
}

TEST(ConcaveFaces, RepeatedCornersChangeNothing) {
    for (std::uint32_t seed = 0; seed < 300 && !HasFailure(); ++seed) {
        std::vector<Lattice> outline = randomOutline(seed);
        if (outline.empty()) continue;
        for (std::uint32_t i = 0; i < 3; ++i) {
            const auto at = static_cast<std::ptrdiff_t>(mix(seed + 77 * i) % outline.size());
            const Lattice same = outline[static_cast<std::size_t>(at)];
            outline.insert(outline.begin() + at, same);
        }
        expectCoveredFromEverywhere(outline, static_cast<int>(seed % 6));
    }
}

TEST(ConcaveFaces, OutlinesThatCrossThemselvesDependOnNoCornerAndNoDirection) {
    const std::vector<std::vector<Lattice>> outlines{
        {{0, 0}, {4, 4}, {4, 0}, {0, 4}},               // a bow tie without area
        {{0, 0}, {4, 4}, {4, 0}, {0, 3}},               // one with some
        {{0, 10}, {6, -8}, {-9, 3}, {9, 3}, {-6, -8}},  // a pentagram
        {{0, 0}, {8, 0}, {8, 4}, {2, 4}, {2, -2}, {5, -2}, {5, 7}, {0, 7}},
        {{0, 0}, {3, 0}, {1, 0}, {5, 0}},  // on a line
        {{2, 2}, {2, 2}, {2, 2}, {2, 2}},  // a point
    };
    for (std::vector<Lattice> outline : outlines)
        for (int plane = 0; plane < 6; ++plane) {
            std::set<std::multiset<std::array<Triple, 3>>> results;
            for (int direction = 0; direction < 2; ++direction) {
                for (std::size_t first = 0; first < outline.size(); ++first) {
                    const std::vector<Triple> points = inPlane(outline, plane);
                    std::vector<std::uint32_t> triangles;
                    ASSERT_TRUE(EarCutter().cut(points, triangles));
                    ASSERT_EQ(triangles.size(), 3 * (outline.size() - 2));
                    std::multiset<std::array<Triple, 3>> places;
                    for (std::size_t i = 0; i < triangles.size(); i += 3) {
                        std::array<Triple, 3> one{points[triangles[i]], points[triangles[i + 1]],
                                                  points[triangles[i + 2]]};
                        std::sort(one.begin(), one.end());
                        places.insert(one);
                    }
                    results.insert(places);
                    std::rotate(outline.begin(), outline.begin() + 1, outline.end());
                }
                std::reverse(outline.begin(), outline.end());
            }
            EXPECT_EQ(results.size(), 1U) << "plane " << plane << ", " << outline.size() << " corners";
        }
}

TEST(ConcaveFaces, ConvexOutlinesStayFansFromTheirFirstCorner) {
    for (std::size_t count = 3; count < 40; ++count)
        for (int plane = 0; plane < 6; ++plane) {
            // Points of a parabola, so that all coordinates are exact.
            std::vector<Lattice> outline;
            for (std::size_t i = 0; i < count; ++i) {
                const auto x = static_cast<std::int64_t>(i);
                outline.push_back({x, x * x});
            }
            for (std::size_t first = 0; first < count; ++first) {
                EXPECT_TRUE(isFan(inPlane(outline, plane))) << count << ' ' << first;
                std::rotate(outline.begin(), outline.begin() + 1, outline.end());
            }
        }
}

TEST(ConcaveFaces, OrientationsAreExact) {
    // Neighbours of points on a line: the determinant in double is 0 or has the wrong sign for many of them.
    const float tiny = std::ldexp(1.F, -24);
    for (int i = -8; i <= 8; ++i)
        for (int k = -8; k <= 8; ++k) {
            const PlanePoint a{.5F + static_cast<float>(i) * tiny, .5F + static_cast<float>(k) * tiny};
            const auto exact = static_cast<std::int64_t>(k) - i;
            EXPECT_EQ(orientation({12, 12}, {24, 24}, a), signOf(exact));
            EXPECT_EQ(orientation({24, 24}, {12, 12}, a), -signOf(exact));
        }
    EXPECT_EQ(orientation({3e38F, 0}, {0, 3e38F}, {-3e38F, -1e-38F}), 1);
    EXPECT_EQ(orientation({3e38F, 3e38F}, {1e-38F, 1e-38F}, {0, 0}), 0);
    EXPECT_EQ(orientation({3e38F, 3e38F}, {1e-38F, 2e-38F}, {0, 0}), 1);
}

TEST(ConcaveFaces, LongOutlinesAreCutInTime) {
    constexpr std::size_t kCorners = 20'000;
    // A star whose teeth have random lengths, and a comb.
    std::vector<Triple> star, comb;
    for (std::size_t i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / kCorners;
        const double radius = .5 + static_cast<double>(mix(static_cast<std::uint32_t>(i)) % 1000) / 1000;
        star.push_back(
            {static_cast<float>(radius * std::cos(angle)), static_cast<float>(radius * std::sin(angle)), 0});
        if (i < kCorners / 4) comb.push_back({static_cast<float>(i), i % 2 == 0 ? 0.F : 5.F, 0});
    }
    comb.push_back({static_cast<float>(kCorners / 4), -3, 0});
    comb.push_back({0, -3, 0});
    for (const std::vector<Triple>& outline : {star, comb}) {
        std::vector<std::uint32_t> triangles;
        EXPECT_TRUE(EarCutter().cut(outline, triangles));
        double area = 0, whole = 0;
        const auto across = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            return (static_cast<double>(outline[b][0]) - outline[a][0]) *
                       (static_cast<double>(outline[c][1]) - outline[a][1]) -
                   (static_cast<double>(outline[b][1]) - outline[a][1]) *
                       (static_cast<double>(outline[c][0]) - outline[a][0]);
        };
        for (std::size_t i = 0; i < triangles.size(); i += 3)
            area += std::abs(across(triangles[i], triangles[i + 1], triangles[i + 2]));
        for (std::uint32_t i = 1; i + 1 < outline.size(); ++i) whole += across(0, i, i + 1);
        EXPECT_NEAR(area, std::abs(whole), 1e-6 * std::abs(whole));
    }
}

TEST(ConcaveFaces, WhatTakesTooLongIsAFanWithAMessage) {
    // A spiral of narrow steps: every ear of one arm has the corners of all others beside it.
    std::string text;
    constexpr int kCorners = 400'000;
    for (int i = 0; i < kCorners; ++i)
        text += "v " + std::to_string(i % 2) + " " + std::to_string(i) + " 0\n";
    text += "f";
    // All corners of one column have one x, and the outline crosses itself everywhere.
    for (int i = 0; i < kCorners; ++i)
        text += " " + std::to_string(1 + static_cast<int>((static_cast<std::int64_t>(i) * 7919) % kCorners));
    const auto model = parseObj(text, "a.obj");
    ASSERT_TRUE(model);
    ASSERT_EQ(model.diagnostics.size(), 1U);
    EXPECT_EQ(model.diagnostics[0].id, "file-W17");
    EXPECT_EQ(model->splitTriangles.size(), 3U * (kCorners - 2));
    EXPECT_EQ(obj(*model, false).indices.size(), 3U * (kCorners - 2));
}

/// Seconds of processor time until an outline that runs round one triangle again and again is given up.
double secondsForRounds(std::size_t rounds) {
    std::vector<Triple> outline;
    for (std::size_t i = 0; i < rounds; ++i)
        outline.insert(outline.end(), {Triple{0, 0, 0}, Triple{1, 1, 1}, Triple{2, 0, 1}});
    std::vector<std::uint32_t> triangles;
    const std::clock_t start = std::clock();
    EXPECT_FALSE(EarCutter().cut(outline, triangles));
    EXPECT_EQ(triangles.size(), 3 * (outline.size() - 2));
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(ConcaveFaces, AnOutlineIsGivenUpAfterTheSameTimeHoweverLongItIs) {
    EXPECT_LT(secondsForRounds(100'000), 4 * secondsForRounds(20'000));
}

TEST(ConcaveFaces, KeepTextureCoordinatesAndNormalsOfTheirCorners) {
    // The arrow head of a notch, whose corners all have other vt and vn; the fan from corner 1 leaves it.
    const auto model = parseObj(
        "v -9 -9 0\nv 9 -9 0\nv 0 -3 0\nv 0 9 0\nvt 1 1\nvt 2 2\nvt 3 3\nvt 4 4\n"
        "vn 1 0 0\nvn 0 1 0\nvn 0 0 1\nvn -1 0 0\nf 1/4/1 3/3/2 2/2/3 4/1/4\nf 1 3 4\n",
        "a.obj");
    ASSERT_TRUE(model);
    EXPECT_EQ(model->splitFaces, std::vector<std::uint32_t>{0});
    const Mesh mesh = obj(*model);
    ASSERT_EQ(mesh.indices.size(), 9U);
    std::set<std::multiset<std::uint32_t>> triangles;
    for (std::size_t i = 0; i < 6; i += 3)
        triangles.insert({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    EXPECT_EQ(triangles, (std::set<std::multiset<std::uint32_t>>{{0, 1, 3}, {1, 2, 3}}));
    const Attribute& texCoord = *mesh.attribute(kTexCoord);
    EXPECT_EQ(std::vector(texCoord.values.begin(), texCoord.values.begin() + 8),
              (std::vector<float>{4, 4, 3, 3, 2, 2, 1, 1}));
    // The next face is still its own.
    EXPECT_EQ(mesh.vertexCount(), 7U);
    EXPECT_EQ(std::vector(mesh.indices.begin() + 6, mesh.indices.end()),
              (std::vector<std::uint32_t>{4, 5, 6}));
}

}  // namespace
}  // namespace glibra::geometry
