// The OBJ reader compared with tinyobjloader on generated files.

#include <gtest/gtest.h>
#include <tiny_obj_loader.h>

#include <cmath>
#include <sstream>

#include "geometry/mix.h"
#include "geometry/obj/obj_model.h"

namespace glibra::geometry {
namespace {

/// A file of random polygons in all corner forms, with groups, materials, comments and odd blanks in between.
std::string generatedFile(std::uint32_t seed) {
    std::uint32_t counter = 0;
    const auto random = [&](std::uint32_t below) {
        return mix(mix(counter++) ^ (seed * 0x9e3779b9U)) % below;
    };
    const auto number = [&] {
        const double value = (static_cast<double>(random(2'000'001)) - 1e6) / 4096;
        switch (random(4)) {
            case 0:
                return std::to_string(value);
            case 1:
                return std::to_string(static_cast<int>(value));
            case 2:
                return std::to_string(value) + "e-2";
            default:
                return std::to_string(std::abs(value)).substr(std::abs(value) < 1 ? 1 : 0);
        }
    };
    const auto blanks = [&] { return std::string(1 + random(3), random(2) ? ' ' : '\t'); };
    const std::string end = random(2) ? "\n" : "\r\n";
    std::string text = "# generated" + end;
    std::uint32_t v = 0, vt = 0, vn = 0;
    const bool hasColors = random(2) == 0;  // the other reader drops them unless all vertices have them
    // One statement each, so that the numbers come in the same order with every compiler.
    const auto putLine = [&](const char* word, int numbers) {
        text += word;
        for (; numbers > 0; --numbers) {
            text += blanks();
            text += number();
        }
        text += end;
    };
    for (int block = 0; block < 12; ++block) {
        if (random(2)) text.append("o object").append(std::to_string(block)).append(end);
        for (std::uint32_t n = 3 + random(20); n > 0; --n, ++v) putLine("v", hasColors ? 6 : 3);
        for (std::uint32_t n = 1 + random(9); n > 0; --n, ++vt) putLine("vt", 2);
        for (std::uint32_t n = 1 + random(9); n > 0; --n, ++vn) putLine("vn", 3);
        if (random(2)) text.append("g part").append(std::to_string(block)).append(end);
        const std::string groups[] = {"", "s 1", "s off", "s 0", "s " + std::to_string(random(100))};
        if (const std::string& group = groups[block == 0 ? 4 : random(5)]; !group.empty())
            text.append(group).append(end);
        for (std::uint32_t i = 0, n = random(30); i < n; ++i) {
            const std::uint32_t form = random(4);
            text += "f";
            // The corners of a face are different, since the other reader may drop equal ones.
            const std::uint32_t first = random(v);
            for (std::uint32_t c = 0, corners = 3 + random(v >= 7 ? 4 : 1); c < corners; ++c) {
                const auto index = [&](std::uint32_t at, std::uint32_t count) {
                    return random(3) == 0 ? std::to_string(static_cast<int>(at) - static_cast<int>(count))
                                          : std::to_string(at + 1);
                };
                text += blanks();
                text += index((first + c) % v, v);
                if (form == 1 || form == 3) text += "/" + index(random(vt), vt);
                if (form == 2) text += '/';
                if (form >= 2) text += "/" + index(random(vn), vn);
            }
            if (random(5) == 0) text += ' ';
            text += end;
        }
    }
    return text.append("f 1 2 3").append(end);
}

void expectClose(float ours, float theirs) {
    EXPECT_NEAR(ours, theirs, 1e-6 + 1e-6 * std::abs(ours));
}

TEST(ObjOracle, TinyobjloaderReadsTheSameModels) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const std::string text = generatedFile(seed);
        const auto ours = parseObj(text, "generated.obj");
        ASSERT_TRUE(ours) << text;
        EXPECT_TRUE(ours.diagnostics.empty());

        tinyobj::attrib_t theirs;
        std::vector<tinyobj::shape_t> shapes;
        std::vector<tinyobj::material_t> materials;
        std::string warnings, errors;
        std::istringstream stream(text);
        ASSERT_TRUE(tinyobj::LoadObj(&theirs, &shapes, &materials, &warnings, &errors, &stream, nullptr,
                                     false, false));
        ASSERT_EQ(ours->colors.empty(), theirs.colors.empty());
        for (std::size_t i = 0; i < ours->colors.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) expectClose(ours->colors[i][c], theirs.colors[3 * i + c]);

        ASSERT_EQ(ours->positions.size() * 3, theirs.vertices.size());
        ASSERT_EQ(ours->texCoords.size() * 2, theirs.texcoords.size());
        ASSERT_EQ(ours->normals.size() * 3, theirs.normals.size());
        for (std::size_t i = 0; i < ours->positions.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                expectClose(ours->positions[i][c], theirs.vertices[3 * i + c]);
        for (std::size_t i = 0; i < ours->texCoords.size(); ++i)
            for (std::size_t c = 0; c < 2; ++c)
                expectClose(ours->texCoords[i][c], theirs.texcoords[2 * i + c]);
        for (std::size_t i = 0; i < ours->normals.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) expectClose(ours->normals[i][c], theirs.normals[3 * i + c]);

        std::size_t face = 0, corner = 0;
        for (const tinyobj::shape_t& shape : shapes) {
            std::size_t at = 0, groupAt = 0;
            for (const auto corners : shape.mesh.num_face_vertices) {
                ASSERT_LT(face, ours->faceCount());
                EXPECT_EQ(ours->groups[face], shape.mesh.smoothing_group_ids[groupAt++]);
                EXPECT_EQ(ours->faceStarts[face + 1] - ours->faceStarts[face],
                          static_cast<std::uint32_t>(corners));
                for (std::size_t c = 0; c < static_cast<std::size_t>(corners); ++c, ++corner, ++at) {
                    const tinyobj::index_t& index = shape.mesh.indices[at];
                    const ObjCorner& mine = ours->corners[corner];
                    EXPECT_EQ(mine.position, static_cast<std::uint32_t>(index.vertex_index));
                    EXPECT_EQ(mine.texCoord, static_cast<std::uint32_t>(index.texcoord_index));
                    EXPECT_EQ(mine.normal, static_cast<std::uint32_t>(index.normal_index));
                }
                ++face;
            }
        }
        EXPECT_EQ(face, ours->faceCount());
    }
}

}  // namespace
}  // namespace glibra::geometry
