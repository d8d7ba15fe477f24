// Models whose files say more than triangles: outlines, colours, lines and points reach the picture.

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

#include "script_problems.h"

namespace glibra::test {
namespace {

/// A window of 16 pixels for -1..1; shapes have their own colour.
std::string colored(const std::string& statements) {
    return "WindowSize 16 16\nBackground 0 0 0\nOrtho -1 1 -1 1\nVertex inline\n#version 330 core\n"
           "in vec4 aVertex;\nin vec4 aColor;\nout vec4 vColor;\nvoid main() {\n    vColor = aColor;\n"
           "    gl_Position = uModelViewProjectionMatrix * aVertex;\n}\nEndVertex\nFragment inline\n"
           "#version 330 core\nin vec4 vColor;\nout vec4 fColor;\nvoid main() { fColor = vColor; }\n"
           "EndFragment\nProgram Colored\n" +
           statements;
}

TEST(ModelPictures, ColoursOfVerticesReplaceTheCurrentOne) {
    const std::string half = "v -1 -1 0 0 1 0\nv 3 -1 0 0 1 0\nv -1 3 0 0 1 0\nf 1 2 3\n";
    EXPECT_EQ(problemsOf(colored("Color 1 0 0\nObj a.obj\nExpect pixel 8 8 [0 1 0]\n"), {{"a.obj", half}}),
              "");
    const std::string plain = "v -1 -1 0\nv 3 -1 0\nv -1 3 0\nf 1 2 3\n";
    EXPECT_EQ(problemsOf(colored("Color 1 0 0\nObj a.obj\nExpect pixel 8 8 [1 0 0]\n"), {{"a.obj", plain}}),
              "");
    // One mesh of each kind has them.
    for (const char* word : {"ObjAdj", "WireObj"})
        EXPECT_EQ(problemsOf(colored(std::string("Color 1 0 0\nTranslate .0625 .0625 0\n") + word +
                                     " a.obj\nExpect pixel 0 8 [0 1 0]\n"),
                             {{"a.obj", half}}),
                  "")
            << word;
}

TEST(ModelPictures, ConcaveFacesKeepTheirNotch) {
    for (const char* face : {"1 3 2 4", "3 2 4 1", "2 4 1 3", "4 1 3 2", "4 2 3 1", "2 3 1 4"})
        EXPECT_EQ(
            problemsOf(
                colored("Color 1 1 1\nObj a.obj\nExpect pixel 8 8 [1 1 1]\nExpect pixel 3 3 [1 1 1]\n"
                        "Expect pixel 8 2 [0 0 0]\nExpect pixel 7 3 [0 0 0]\n"),
                {{"a.obj", std::string("v -.9 -.9 0\nv .9 -.9 0\nv 0 -.3 0\nv 0 .9 0\nf ") + face + "\n"}}),
            "")
            << face;
}

TEST(ModelPictures, WireObjDrawsLinesAndPoints) {
    // Centres of pixels: 2 / 16 from each other.
    const std::string file =
        "v -.6875 .4375 0\nv .6875 .4375 0\nv .0625 -.4375 0\nv -.6875 -.6875 0\nl 1 2\np 3 4\n";
    EXPECT_EQ(
        problemsOf(colored("Color 0 1 1\nWireObj a.obj\nExpect pixel 8 11 [0 1 1]\nExpect pixel 8 4 [0 1 1]\n"
                           "Expect pixel 2 2 [0 1 1]\nExpect pixel 8 5 [0 0 0]\nExpect pixel 5 3 [0 0 0]\n"),
                   {{"a.obj", file}}),
        "");
    EXPECT_EQ(problemsOf(colored("Color 0 1 1\nPointSize 3\nWireObj a.obj\nExpect pixel 9 5 [0 1 1]\n"
                                 "Expect pixel 8 7 [0 0 0]\n"),
                         {{"a.obj", file}}),
              "");
    // Points alone, and drawn more than once.
    EXPECT_EQ(problemsOf(colored("Color 0 1 1\nWireObj a.obj\nTranslate .25 0 0\nWireObj a.obj\n"
                                 "Expect pixel 8 4 [0 1 1]\nExpect pixel 10 4 [0 1 1]\n"),
                         {{"a.obj", "v .0625 -.4375 0\np 1\n"}}),
              "");
}

/// Two points as a shapefile: a header of 100 bytes, then two records of 28.
std::string twoPoints(double x, double y, double x2, double y2) {
    std::string file(156, '\0');
    const auto big = [&](std::size_t at, std::uint32_t value) {
        for (std::size_t i = 0; i < 4; ++i) file[at + i] = static_cast<char>(value >> (24 - 8 * i) & 0xffU);
    };
    const auto put = [&](std::size_t at, const auto& value) { std::memcpy(&file[at], &value, sizeof value); };
    big(0, 9994);
    big(24, 78);
    put(28, std::uint32_t{1000});
    put(32, std::uint32_t{1});
    std::size_t at = 100;
    for (const auto& [px, py] : {std::pair(x, y), std::pair(x2, y2)}) {
        big(at, at == 100 ? 1 : 2);
        big(at + 4, 10);
        put(at + 8, std::uint32_t{1});
        put(at + 12, px);
        put(at + 20, py);
        at += 28;
    }
    return file;
}

TEST(ModelPictures, PointsOfAShapefileAreNotJoined) {
    EXPECT_EQ(
        problemsOf(colored("Color 0 1 1\nShp a.shp\nExpect pixel 2 8 [0 1 1]\nExpect pixel 13 8 [0 1 1]\n"
                           "Expect pixel 8 8 [0 0 0]\n"),
                   {{"a.shp", twoPoints(-.6875, .0625, .6875, .0625)}}),
        "");
}

}  // namespace
}  // namespace glibra::test
