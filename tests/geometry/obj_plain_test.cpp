// The reader of usual OBJ files compared with the line-by-line reader.

#include "geometry/obj/obj_plain.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <iterator>
#include <random>
#include <string>

namespace glibra::geometry {
namespace {

/// A word that both ignore, but with which parseObj uses the line-by-line reader.
constexpr const char* kUnknown = "unknown\n";

void expectEqual(const ObjModel& a, const ObjModel& b) {
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.texCoords, b.texCoords);
    EXPECT_EQ(a.normals, b.normals);
    EXPECT_EQ(a.corners, b.corners);
    EXPECT_EQ(a.faceStarts, b.faceStarts);
    EXPECT_EQ(a.colors, b.colors);
    EXPECT_EQ(a.groups, b.groups);
    EXPECT_EQ(a.splitFaces, b.splitFaces);
    EXPECT_EQ(a.splitTriangles, b.splitTriangles);
}

/// Lines as exporters write them, in any order: faces refer to vertices above and below them.
std::string randomModel(unsigned seed, int lines) {
    std::mt19937 random(seed);
    const auto below = [&](unsigned count) { return random() % count; };
    const auto number = [&] {
        const double value = (static_cast<double>(random()) / 4294967296. - .5) * 200;
        switch (below(4)) {
            case 0:
                return fmt::format("{:.6f}", value);
            case 1:
                return fmt::format("{:g}", value * 1e-7);
            case 2:
                return fmt::format("{}", value);
            default:
                return fmt::format("{:.0f}", value);
        }
    };
    std::string text = "v 0 0 0\nvt 0 0\nvn 0 0 1\nv 1 0 0\nv 0 1 3\nv 4 4 1\nv 9 2 2\nv 1 3 5\n";
    const std::string end = below(2) == 0 ? "\n" : "\r\n";
    for (int i = 0; i < lines; ++i) {
        switch (below(12)) {
            case 0:
                text += "# comment \\ " + number();
                break;
            case 1:
                text += "usemtl wood # of oak";
                break;
            case 2:
                text += "vt " + number() + " " + number();
                break;
            case 3:
                text += "\tvn  " + number() + "\t" + number() + " " + number() + " ";
                break;
            case 4:
                text += "v " + number() + " " + number() + " " + number() + " 1 1 1";
                break;
            case 5:
                text += "f 1 1 1 1";
                break;
            case 9:
                text += "v " + number() + " " + number() + " " + number() +
                        std::array{" 1", " 1 wide # 1", " 1 0 1e-60 1", " .5 -1 +2", " 1 2 3x"}[below(5)];
                break;
            case 10:
                text += below(2) == 0 ? "s off" : "s " + std::to_string(below(40)) + " # group";
                break;
            case 11:
                text += "f 2 3 4 5 6 # often concave";
                break;
            case 6:
                text += "f 1//1 1//1 1//1 # last";
                break;
            case 7:
                text += "f  1/1/1 1/1/1\t1/1/1";
                break;
            default:
                text += "f 1/1 1/1 1/ 1//";
                break;
        }
        text += end;
    }
    return text + "v 1 2 3\nf 2 1 2";
}

TEST(PlainObj, IsWhatTheReaderOfAnyFileReads) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        const std::string text = randomModel(seed, 60);
        const auto any = parseObj(text + "\n" + kUnknown, "model.obj");
        ASSERT_TRUE(any);
        ASSERT_EQ(any.diagnostics.size(), 1U) << any.diagnostics.front().text;
        const auto alone = parseObj(text, "model.obj");
        ASSERT_TRUE(alone);
        EXPECT_TRUE(alone.diagnostics.empty());
        expectEqual(*alone, *any);
    }
}

TEST(PlainObj, DoesNotDependOnThePieces) {
    const std::string text =
        "v 1 2 3\nv 4.5 -.5 +7\nv 1e-3 0 0\nvt .5 .25\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n"
        "f 1//1 2//1 3//1\ns 4\nf 3 2 1\nv 1 1 1 .5 .5 .5\ns off\n# done\n" +
        std::string(100, '\n');
    const auto whole = readPlainObj(text);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->faceCount(), 3U);
    for (const std::size_t bytes : {1U, 5U, 20U, 50U, 90U, 1000U}) {
        const auto pieces = readPlainObj(text, bytes);
        ASSERT_TRUE(pieces) << bytes;
        expectEqual(*pieces, *whole);
    }
}

TEST(PlainObj, IsNothingThatHasToBeRemarkedOn) {
    const std::string model = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    ASSERT_TRUE(readPlainObj(model));
    for (const char* line : {"v 1 2",
                             "v 1 2 x",
                             "v 1,2 3 4",
                             "v 1e99 0 0",
                             "v inf 0 0",
                             "vt",
                             "vn 1 0",
                             "f 1 2",
                             "f 1 2 4",
                             "f 0 1 2",
                             "f -1 -2 -3",
                             "f 1/1 2/1 3/1",
                             "f 1//1 2//1 3//1",
                             "f 1 2 3x",
                             "f 1 2 \\\n3",
                             "l 1 2",
                             "s on",
                             "s -1",
                             "s 1x",
                             "s",
                             "g a\\\n",
                             "# a\rv 1 1 1",
                             "o\v",
                             "vp 1 2",
                             "f 1 2 99999999"}) {
        EXPECT_FALSE(readPlainObj(model + line + "\n")) << line;
        EXPECT_FALSE(readPlainObj(std::string(line) + "\n" + model + std::string(200, ' '))) << line;
    }
    EXPECT_FALSE(readPlainObj(""));
    EXPECT_FALSE(readPlainObj("v 0 0 0\n"));
}

}  // namespace
}  // namespace glibra::geometry
