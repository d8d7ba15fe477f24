// Model files with random damage: the reader must always give an answer, and a valid one.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "geometry/mix.h"
#include "geometry/obj/obj_model.h"
#include "geometry/obj/shapefile.h"
#include "mesh_checks.h"
#include "shapefile_writer.h"

namespace glibra::geometry {
namespace {

/// Overwrites, inserts, removes and doubles parts of the text, depending on the seed.
std::string damaged(std::string text, std::uint32_t seed) {
    std::uint32_t counter = 0;
    const auto random = [&](std::size_t below) {
        return static_cast<std::size_t>(mix(mix(counter++) ^ (seed * 0x9e3779b9U))) %
               std::max<std::size_t>(below, 1);
    };
    constexpr std::string_view kFavourites = "\\\n\r/#-+.e0 9fv\tn\xff";
    for (std::size_t i = 0, n = 1 + random(12); i < n; ++i) {
        const std::size_t at = random(text.size());
        const std::size_t length = std::min(random(20), text.size() - std::min(at, text.size()));
        switch (random(5)) {
            case 0:
                text.insert(at, 1, kFavourites[random(kFavourites.size())]);
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, text.substr(random(text.size()), length));
                break;
            case 3:
                text.insert(at, std::string(random(4), static_cast<char>(random(256))));
                break;
            default:
                if (!text.empty()) text[at] = static_cast<char>(random(256));
        }
    }
    return text;
}

void expectValid(const ObjModel& model) {
    ASSERT_GE(model.faceStarts.size(), 2U);
    EXPECT_EQ(model.faceStarts.back(), model.corners.size());
    for (std::size_t i = 0; i + 1 < model.faceStarts.size(); ++i)
        EXPECT_GE(model.faceStarts[i + 1], model.faceStarts[i] + 3);
    for (const ObjCorner& corner : model.corners) {
        EXPECT_LT(corner.position, model.positions.size());
        EXPECT_TRUE(corner.texCoord == kNoIndex || corner.texCoord < model.texCoords.size());
        EXPECT_TRUE(corner.normal == kNoIndex || corner.normal < model.normals.size());
    }
}

TEST(DamagedObj, IsReadOrRefusedButNeverUnsound) {
    const std::string whole =
        "# model\nmtllib a.mtl\no thing\nv 0 0 0\nv 1.5 0 -2e-3\nv 0 1 0\nv 0 0 1 1 1 1\nvt 0 0\nvt 1 0 "
        ".5\nvt 0 1\n"
        "vn 0 0 1\nvn 0 1 0\ng part\nusemtl x\ns 1\nf 1/1/1 2/2/1 3/3/1\nf 1//2 3//2 4//2\nf -1 -2 -3 \\\n "
        "-4\nl 1 2\n"
        "f 1/1 2/2 4/3\nf 4 3 2 1\n";
    int read = 0;
    for (std::uint32_t seed = 0; seed < 6000; ++seed) {
        const auto model = parseObj(damaged(whole, seed), "damaged.obj");
        if (!model) {
            EXPECT_TRUE(hasError(model.diagnostics));
            continue;
        }
        ++read;
        EXPECT_FALSE(hasError(model.diagnostics));
        expectValid(*model);
        for (const Mesh& mesh : {obj(*model), objAdj(*model), wireObj(*model), objPatch(*model, false)})
            expectSound(mesh, false);
        EXPECT_EQ(obj(*model).indices.size(), 3 * model->triangleCount());
        EXPECT_EQ(objAdj(*model).indices.size(), 6 * model->triangleCount());
    }
    EXPECT_GT(read, 1000);
}

TEST(DamagedObj, NoiseIsRefused) {
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        std::string noise;
        for (std::uint32_t i = 0; i < 3000; ++i) noise += static_cast<char>(mix(i ^ mix(seed)));
        EXPECT_FALSE(parseObj(noise, "noise.obj"));
    }
}

TEST(DamagedShapefile, IsReadOrRefusedButNeverUnsound) {
    const std::vector<glm::dvec3> points{{0, 0, 1}, {1, 0, 2}, {1, 1, 3}, {0, 1, 4}, {0, 0, 1}};
    const std::vector<std::string> files{
        shapefile(3, {polyRecord(3, {0, 2}, points), nullRecord(), polyRecord(3, {0}, points)}),
        shapefile(15, {polyRecord(15, {0}, points), multipatchRecord()}),
        shapefile(11, {pointRecord(11, points[1]), pointRecord(11, points[2])}),
        shapefile(28, {multipointRecord(28, points)})};
    int read = 0;
    for (std::uint32_t seed = 0; seed < 8000; ++seed) {
        const std::string bytes = damaged(files[seed % files.size()], seed);
        const auto mesh = parseShp(std::as_bytes(std::span(bytes)), "damaged.shp");
        EXPECT_EQ(static_cast<bool>(mesh), !hasError(mesh.diagnostics));
        if (!mesh) continue;
        ++read;
        expectSound(*mesh);
        EXPECT_EQ(mesh->indices.size() % static_cast<std::size_t>(verticesPerPrimitive(mesh->topology)), 0U);
    }
    EXPECT_GT(read, 400);
}

}  // namespace
}  // namespace glibra::geometry
