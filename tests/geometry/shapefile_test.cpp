// Shapefiles that are written here byte by byte after the format's description.

#include "geometry/obj/shapefile.h"

#include <limits>
#include <string>

#include "mesh_checks.h"
#include "shapefile_writer.h"

namespace glibra::geometry {
namespace {

Result<Mesh> parseShpBytes(const std::string& bytes) {
    return parseShp(std::as_bytes(std::span(bytes)), "maps/city.shp");
}

void expectDamaged(const std::string& bytes) {
    const auto mesh = parseShpBytes(bytes);
    EXPECT_FALSE(mesh);
    ASSERT_EQ(mesh.diagnostics.size(), 1U);
    EXPECT_EQ(mesh.diagnostics[0].id, "file-E04");
    EXPECT_EQ(mesh.diagnostics[0].place.file, "maps/city.shp");
}

const std::vector<glm::dvec3> kFour{{0, 0, 7}, {1, 0, 8}, {1, 2, 9}, {0, 2, 10}};

TEST(Shapefile, PolylinesBecomeSegments) {
    for (const std::uint32_t type : {3U, 13U, 23U}) {
        const auto mesh = parseShpBytes(shapefile(type, {polyRecord(type, {0}, kFour)}));
        ASSERT_TRUE(mesh);
        EXPECT_EQ(mesh->topology, Topology::lines);
        EXPECT_EQ(mesh->indices, (std::vector<std::uint32_t>{0, 1, 1, 2, 2, 3}));
        EXPECT_EQ(positionAt(*mesh, 2), glm::dvec3(1, 2, type == 13 ? 9 : 0));
        EXPECT_EQ(normalAt(*mesh, 2), glm::dvec3(0, 0, 1));
        EXPECT_EQ(tangentAt(*mesh, 2), glm::dvec3(0, 1, 0));
        EXPECT_EQ(mesh->attribute(kTexCoord), nullptr);
        expectSound(*mesh);
    }
}

TEST(Shapefile, PartsAreSeparateLines) {
    const auto mesh = parseShpBytes(shapefile(3, {polyRecord(3, {0, 2}, kFour), polyRecord(3, {0}, kFour)}));
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 5, 6, 6, 7}));
}

TEST(Shapefile, RingsAreClosedOnce) {
    for (const std::uint32_t type : {5U, 15U, 25U}) {
        EXPECT_EQ(parseShpBytes(shapefile(type, {polyRecord(type, {0}, kFour)}))->indices.size() / 2, 4U);
        std::vector<glm::dvec3> closed = kFour;
        closed.push_back(kFour.front());
        EXPECT_EQ(parseShpBytes(shapefile(type, {polyRecord(type, {0}, closed)}))->indices.size() / 2, 4U);
    }
}

TEST(Shapefile, PointsAndMultipointsArePoints) {
    for (const std::uint32_t z : {0U, 10U, 20U}) {
        const auto points =
            parseShpBytes(shapefile(1 + z, {pointRecord(1 + z, kFour[1]), pointRecord(1 + z, kFour[2])}));
        ASSERT_TRUE(points);
        EXPECT_EQ(points->topology, Topology::points);
        EXPECT_EQ(points->indices, (std::vector<std::uint32_t>{0, 1}));
        EXPECT_EQ(positionAt(*points, 1), glm::dvec3(1, 2, z == 10 ? 9 : 0));
        const auto many = parseShpBytes(shapefile(8 + z, {multipointRecord(8 + z, kFour)}));
        ASSERT_TRUE(many);
        EXPECT_EQ(many->topology, Topology::points);
        EXPECT_EQ(many->indices.size(), 4U);
        EXPECT_EQ(positionAt(*many, 3), glm::dvec3(0, 2, z == 10 ? 10 : 0));
    }
}

TEST(Shapefile, NullShapesAreSkippedAndMultipatchesNamed) {
    const auto mesh =
        parseShpBytes(shapefile(3, {nullRecord(), polyRecord(3, {0}, kFour), nullRecord(), multipatchRecord(),
                                    multipatchRecord(), multipatchRecord()}));
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->indices.size() / 2, 3U);
    ASSERT_EQ(mesh.diagnostics.size(), 1U);
    EXPECT_EQ(mesh.diagnostics[0].id, "file-W11");
    EXPECT_EQ(mesh.diagnostics[0].text, "3 multipatch shapes skipped");
}

TEST(Shapefile, AnEmptyOneIsAnEmptyMesh) {
    const auto mesh = parseShpBytes(shapefile(3, {}));
    ASSERT_TRUE(mesh);
    EXPECT_TRUE(mesh->indices.empty());
    EXPECT_EQ(mesh->vertexCount(), 0U);
}

TEST(Shapefile, OtherFilesAreRefused) {
    expectDamaged("");
    expectDamaged("not a shapefile");
    expectDamaged(std::string(100, '\0'));
    expectDamaged(std::string(5000, 'x'));
}

TEST(Shapefile, EveryTruncationIsNoticed) {
    const std::string whole = shapefile(13, {polyRecord(13, {0}, kFour), polyRecord(13, {0, 1}, kFour)});
    ASSERT_TRUE(parseShpBytes(whole));
    for (std::size_t length = 0; length < whole.size(); ++length) expectDamaged(whole.substr(0, length));
}

TEST(Shapefile, BytesAfterTheStatedLengthAreIgnored) {
    const auto mesh = parseShpBytes(shapefile(3, {polyRecord(3, {0}, kFour)}) + "rest");
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->indices.size() / 2, 3U);
}

TEST(Shapefile, LyingCountsAreNoticed) {
    const std::string whole = shapefile(3, {polyRecord(3, {0, 2}, kFour)});
    constexpr std::size_t kRecord = 108, kParts = kRecord + 36, kPoints = kRecord + 40,
                          kSecondPart = kRecord + 48;
    const auto patched = [&](std::size_t at, std::uint32_t value) {
        std::string copy = whole;
        for (std::size_t i = 0; i < 4; ++i) copy[at + i] = static_cast<char>(value >> (8 * i) & 0xff);
        return copy;
    };
    ASSERT_TRUE(parseShpBytes(patched(kSecondPart, 3)));
    for (const std::uint32_t lie : {7U, 1000U, 0x7fffffffU, 0x80000000U, 0xffffffffU}) {
        expectDamaged(patched(kParts, lie));
        expectDamaged(patched(kPoints, lie));
        expectDamaged(patched(kSecondPart, lie));
    }
    expectDamaged(patched(kRecord, 77));  // unknown type
    std::string length = whole;
    length[104] = '\x7f';  // content length
    expectDamaged(length);
}

TEST(Shapefile, CoordinatesMustBeFiniteAsFloat) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e39})
        expectDamaged(shapefile(3, {polyRecord(3, {0}, {{0, 0, 0}, {1, bad, 0}})}));
}

TEST(Shapefile, MixedPointsAndLinesAreRefused) {
    expectDamaged(shapefile(3, {polyRecord(3, {0}, kFour), pointRecord(1, kFour[0])}));
}

}  // namespace
}  // namespace glibra::geometry
