// The teapot compared with known facts about the original and with de Casteljau's construction.

#include "geometry/shapes/teapot.h"

#include <set>

#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

constexpr std::uint32_t kPatchVertices = 17 * 17;

using Curve = std::array<glm::dvec3, 4>;

glm::dvec3 deCasteljau(Curve p, double u) {
    for (std::size_t last = 3; last > 0; --last)
        for (std::size_t i = 0; i < last; ++i) p[i] = (1 - u) * p[i] + u * p[i + 1];
    return p[0];
}

glm::dvec3 surfacePoint(const Patch& patch, double s, double t) {
    Curve rows;
    for (std::size_t row = 0; row < 4; ++row) rows[row] = deCasteljau(patch[row], s);
    return deCasteljau(rows, t);
}

glm::dvec3 upright(const glm::dvec3& p) {
    return {.5 * p.x, .5 * (p.z - 1.5), -.5 * p.y};
}

/// Returns the triangles of some of the patches.
Mesh partOf(const Mesh& mesh, int firstPatch, int patches) {
    Mesh part = mesh;
    part.indices.clear();
    forEachTriangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const int patch = static_cast<int>(a / kPatchVertices);
        if (patch >= firstPatch && patch < firstPatch + patches)
            part.indices.insert(part.indices.end(), {a, b, c});
    });
    return part;
}

TEST(Teapot, HasTheStatedCounts) {
    EXPECT_EQ(countsOf(teapot()), (Counts{9248, 16256}));
    EXPECT_EQ(countsOf(wireTeapot()), stated(32 * 81, 4544));
    EXPECT_EQ(teapotCounts(), countsOf(teapot()));
    EXPECT_EQ(wireTeapotCounts(), countsOf(wireTeapot()));
}

TEST(Teapot, IsSound) {
    expectSound(teapot());
    expectSound(wireTeapot());
}

TEST(Teapot, FillsTheKnownBox) {
    // The original's box is -3 .. 3.434, -2 .. 2, 0 .. 3.15.
    const Mesh mesh = teapot();
    glm::dvec3 low(10), high(-10);
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        low = glm::min(low, positionAt(mesh, i));
        high = glm::max(high, positionAt(mesh, i));
    }
    expectNear(low, {-1.5, -.75, -1}, 2e-3);
    expectNear(high, {3.434 / 2, .825, 1}, 2e-3);
    EXPECT_EQ(static_cast<float>(low.y), -.75F);
    EXPECT_EQ(static_cast<float>(high.y), .825F);
}

TEST(Teapot, HandleIsTowardMinusXAndSpoutTowardPlusX) {
    const Mesh mesh = teapot();
    for (std::uint32_t i = kTeapotHandle * kPatchVertices; i < kTeapotSpout * kPatchVertices; ++i)
        EXPECT_LT(positionAt(mesh, i).x, -.74);
    for (std::uint32_t i = kTeapotSpout * kPatchVertices; i < mesh.vertexCount(); ++i)
        EXPECT_GT(positionAt(mesh, i).x, .84);
}

TEST(Teapot, VerticesLieOnTheBezierSurfaces) {
    const Mesh mesh = teapot();
    const std::array<Patch, 32> patches = teapotPatches();
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const glm::dvec3 st = texCoordAt(mesh, i);
        expectNear(positionAt(mesh, i), upright(surfacePoint(patches[i / kPatchVertices], st.x, st.y)), 2e-7);
    }
}

TEST(Teapot, TangentsAndNormalsAreThoseOfDifferences) {
    const Mesh mesh = teapot();
    const std::array<Patch, 32> patches = teapotPatches();
    constexpr double kStep = 1e-5;
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const Patch& patch = patches[i / kPatchVertices];
        const glm::dvec3 st = texCoordAt(mesh, i);
        const auto point = [&](double s, double t) { return upright(surfacePoint(patch, s, t)); };
        const glm::dvec3 alongT = point(st.x, st.y + kStep) - point(st.x, st.y - kStep);
        const glm::dvec3 alongS = point(st.x + kStep, st.y) - point(st.x - kStep, st.y);
        expectNear(tangentAt(mesh, i), glm::normalize(alongT), 1e-4);
        if (glm::length(alongS) > 1e-7) {
            expectNear(normalAt(mesh, i), glm::normalize(glm::cross(alongS, alongT)), 1e-3);
        }
    }
}

TEST(Teapot, PolesAreLevelAndEachASinglePlace) {
    const Mesh mesh = teapot();
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const glm::dvec3 p = positionAt(mesh, i);
        const std::uint32_t patch = i / kPatchVertices;
        const double t = texCoordAt(mesh, i).y;
        if (patch >= kTeapotBottom && patch < kTeapotHandle && t == 0) {
            EXPECT_EQ(p, glm::dvec3(0, -.75, 0));
            EXPECT_EQ(normalAt(mesh, i), glm::dvec3(0, -1, 0));
        }
        if (patch >= kTeapotLid && patch < kTeapotLid + 4 && t == 1) {
            EXPECT_EQ(p, glm::dvec3(0, .825F, 0));
            EXPECT_EQ(normalAt(mesh, i), glm::dvec3(0, 1, 0));
            EXPECT_LT(std::abs(tangentAt(mesh, i).y), 1e-7);
        }
    }
}

TEST(Teapot, PatchesMeetBitForBit) {
    const Mesh mesh = teapot();
    Mesh body = partOf(mesh, 0, kTeapotLid);
    const Mesh bottom = partOf(mesh, kTeapotBottom, 4);
    body.indices.insert(body.indices.end(), bottom.indices.begin(), bottom.indices.end());
    // These edges stay open: the inside of the rim, the edge of the lid, both ends of handle and spout.
    EXPECT_EQ(openEdges(body), 64U);
    EXPECT_EQ(openEdges(partOf(mesh, kTeapotLid, 8)), 64U);
    EXPECT_EQ(openEdges(partOf(mesh, kTeapotHandle, 4)), 64U);
    EXPECT_EQ(openEdges(partOf(mesh, kTeapotSpout, 4)), 64U);
}

TEST(Teapot, PatchesMeetSmoothly) {
    const Mesh mesh = teapot();
    const std::vector<std::uint32_t> welded = weldedByBits(mesh);
    const auto part = [](std::uint32_t vertex) {
        const std::uint32_t patch = vertex / kPatchVertices;
        return patch < kTeapotLid      ? 0
               : patch < kTeapotBottom ? 1
               : patch < kTeapotHandle ? 0
               : patch < kTeapotSpout  ? 2
                                       : 3;
    };
    std::map<std::pair<std::uint32_t, int>, std::uint32_t> firstAt;
    int meetings = 0;
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const auto [first, isNew] = firstAt.emplace(std::pair{welded[i], part(i)}, i);
        if (isNew) continue;
        ++meetings;
        EXPECT_GT(glm::dot(normalAt(mesh, i), normalAt(mesh, first->second)), 1 - 1e-5) << i;
    }
    EXPECT_GT(meetings, 900);
}

TEST(Teapot, SurfacesOfRevolutionAreFourfold) {
    const Mesh mesh = teapot();
    std::set<PositionBits> places;
    const auto bitsOf = [](const glm::dvec3& p) {
        PositionBits bits;
        for (int c = 0; c < 3; ++c)
            bits[static_cast<std::size_t>(c)] = std::bit_cast<std::uint32_t>(static_cast<float>(p[c] + 0.));
        return bits;
    };
    const std::uint32_t count = kTeapotHandle * kPatchVertices;
    for (std::uint32_t i = 0; i < count; ++i) places.insert(bitsOf(positionAt(mesh, i)));
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 p = positionAt(mesh, i);
        EXPECT_TRUE(places.contains(bitsOf({p.z, p.y, -p.x})));
    }
}

TEST(Teapot, HandleAndSpoutAreMirroredAcrossThePlaneZZero) {
    const Mesh mesh = teapot();
    for (std::uint32_t i = kTeapotHandle * kPatchVertices; i < mesh.vertexCount(); ++i) {
        // Each half is one patch of a pair; s runs the other way on the second.
        const std::uint32_t patch = i / kPatchVertices, row = i % kPatchVertices / 17;
        const std::uint32_t column = i % kPatchVertices % 17;
        const std::uint32_t twin = (patch ^ 1U) * kPatchVertices + row * 17 + 16 - column;
        const glm::dvec3 p = positionAt(mesh, i), q = positionAt(mesh, twin);
        expectNear(p, {q.x, q.y, -q.z}, 2e-7);
    }
}

TEST(Teapot, IsWoundFromOutside) {
    const Mesh mesh = teapot();
    EXPECT_EQ(wronglyWound(mesh), 0U);
    for (std::uint32_t i = 0; i < kTeapotLid * kPatchVertices; ++i) {
        const glm::dvec3 p = positionAt(mesh, i), n = normalAt(mesh, i);
        // The body's normals point away from the axis, but for the inner side of the rim.
        if (i >= kTeapotBody * kPatchVertices) {
            EXPECT_GT(n.x * p.x + n.z * p.z, 0);
        }
    }
    // Handle and spout: each half faces its own side, but for the lip of the spout, which turns inward.
    for (std::uint32_t i = kTeapotHandle * kPatchVertices; i < mesh.vertexCount(); ++i) {
        const std::uint32_t column = i % kPatchVertices % 17;
        const double side = i / kPatchVertices % 2 == 0 ? 1 : -1;
        const bool isLip = i >= (kTeapotSpout + 2) * kPatchVertices && texCoordAt(mesh, i).y > .4;
        if (column > 0 && column < 16 && !isLip) {
            EXPECT_GT(normalAt(mesh, i).z * side, 0) << i;
        }
    }
}

TEST(Teapot, TRunsAlongTheProfileAndTheLength) {
    const Mesh mesh = teapot();
    const auto corner = [&](int patch, double t) {
        return positionAt(mesh, static_cast<std::uint32_t>(patch) * kPatchVertices + (t == 0 ? 0 : 16 * 17));
    };
    EXPECT_LT(corner(kTeapotBody, 0).y, corner(kTeapotBody, 1).y);
    EXPECT_GT(glm::length(corner(kTeapotBottom, 1)), 0);
    EXPECT_EQ(corner(kTeapotLid, 1), glm::dvec3(0, .825F, 0));
    EXPECT_GT(corner(kTeapotHandle, 0).y, corner(kTeapotHandle + 2, 1).y);
    EXPECT_LT(corner(kTeapotSpout, 0).y, corner(kTeapotSpout + 2, 1).y);
    // The rim continues where the body ends, from the outside to the inside.
    EXPECT_EQ(corner(kTeapotRim, 0), corner(kTeapotBody, 1));
}

}  // namespace
}  // namespace glibra::geometry
