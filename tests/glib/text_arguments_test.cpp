// Files, textures, targets, topologies, switches (language, 3.3 to 3.5).

#include <gtest/gtest.h>

#include "scene.h"

namespace glibra::glib::test {
namespace {

TEST(Files, NameMayBeMissing) {
    for (const char* word : {"Obj", "WireObj", "ObjAdj", "ObjPatch", "Shp", "Vertex", "TessControl",
                             "TessEvaluation", "Geometry", "Fragment"}) {
        EXPECT_TRUE(idsOf(word).empty()) << word;
        EXPECT_EQ(textOf(word), "") << word;
        EXPECT_EQ(textOf(std::string(word) + " a.b"), "a.b") << word;
    }
}

TEST(Files, NumberMayBeAName) {
    EXPECT_EQ(textOf("Obj 138"), "138");
}

TEST(Texture, FileForm) {
    EXPECT_EQ(numbersOf("Texture2D 5 wood.bmp"), Numbers{5});
    EXPECT_EQ(textOf("Texture2D 5 wood.bmp"), "wood.bmp");
    EXPECT_EQ(textOf("Texture2D 5 2.bmp"), "2.bmp");
    EXPECT_EQ(textOf("Texture 5 \"512\""), "512");
    EXPECT_EQ(read("Texture2D 5 wood.bmp").commands.at(0).textPosition().column, 13);
    EXPECT_EQ(idsOf("Texture2D 5 wood.bmp more"), Ids{"glib-W07"});
}

TEST(Texture, EmptyForm) {
    EXPECT_EQ(numbersOf("Texture1D 5 256"), (Numbers{5, 256}));
    EXPECT_EQ(numbersOf("Texture2D 6 1024 512"), (Numbers{6, 1024, 512}));
    EXPECT_EQ(numbersOf("Texture3D 6 8 16 32"), (Numbers{6, 8, 16, 32}));
    EXPECT_EQ(numbersOf("Texture 6 8"), (Numbers{6, 8}));
    EXPECT_EQ(numbersOf("Texture 6 8 16"), (Numbers{6, 8, 16}));
    EXPECT_EQ(numbersOf("Texture 6 8 16 32"), (Numbers{6, 8, 16, 32}));
    EXPECT_EQ(textOf("Texture2D 6 1024 512"), "RGBA8");
}

TEST(Texture, FormatWordInAnyCase) {
    for (const char* format : {"RGBA8", "RGBA16F", "RGBA32F", "R32F"})
        EXPECT_EQ(textOf(std::string("Texture2D 6 64 64 ") + format), format);
    EXPECT_EQ(textOf("Texture2D 6 64 64 rgba16f"), "RGBA16F");
    EXPECT_EQ(idsOf("Texture2D 6 64 64 RGB565"), Ids{"glib-E16"});
}

TEST(Texture, TooFewSizesAreRefused) {
    for (const char* text : {"Texture2D 6 1024", "Texture3D 6 64 64", "Texture3D 6 64", "Texture2D 6",
                             "Texture", "Texture 6", "Texture2D 6 RGBA8", "Texture2D 6 64 R32F"})
        EXPECT_EQ(idsOf(text), Ids{"glib-E04"}) << text;
}

TEST(Texture, SurplusSizesAreIgnored) {
    EXPECT_EQ(numbersOf("Texture2D 6 8 8 8"), (Numbers{6, 8, 8}));
    EXPECT_EQ(idsOf("Texture2D 6 8 8 8"), Ids{"glib-W07"});
    EXPECT_EQ(textOf("Texture1D 6 8 8 R32F"), "R32F");
    EXPECT_EQ(idsOf("Texture1D 6 8 8 R32F"), Ids{"glib-W07"});
}

TEST(Texture, SizesHaveLimits) {
    EXPECT_TRUE(idsOf("Texture2D 6 16384 16384").empty());
    EXPECT_EQ(idsOf("Texture2D 6 16385 1"), Ids{"glib-E15"});
    EXPECT_EQ(idsOf("Texture3D 6 2049 1 1"), Ids{"glib-E15"});
    EXPECT_EQ(idsOf("Texture 6 2049 1 1"), Ids{"glib-E15"});
    EXPECT_TRUE(idsOf("Texture 6 2049 1").empty());
    EXPECT_EQ(idsOf("Texture2D 6 16384 16384 RGBA16F"), Ids{"glib-E15"});
    EXPECT_EQ(idsOf("Texture3D 6 2048 2048 65"), Ids{"glib-E15"});
    EXPECT_EQ(idsOf("Texture2D 6 0 64"), Ids{"glib-E05"});
    EXPECT_EQ(idsOf("Texture2D 6 -64 64"), Ids{"glib-W28"});
    EXPECT_EQ(numbersOf("Texture2D 6 64.5 64"), (Numbers{6, 64, 64}));
}

TEST(Units, MustLieBetween0And127) {
    EXPECT_TRUE(idsOf("Texture2D 0 a.bmp\nTexture2D 127 a.bmp").empty());
    for (const char* text : {"Texture2D 128 a.bmp", "Texture1D -1 a.tex", "CubeMap 200 a b c d e f",
                             "RenderToTexture 128", "Texture2D 1e9 64 64"})
        EXPECT_EQ(idsOf(text), Ids{"glib-E12"}) << text;
}

TEST(CubeMapFiles, AreSix) {
    const Script script = read("CubeMap 6 px.bmp nx.bmp py.bmp ny.bmp pz.bmp nz.bmp");
    EXPECT_EQ(script.commands.at(0).numbers, Numbers{6});
    EXPECT_EQ(textsOf(script.commands[0]),
              (Words{"px.bmp", "nx.bmp", "py.bmp", "ny.bmp", "pz.bmp", "nz.bmp"}));
    EXPECT_EQ(idsOf("CubeMap"), Ids{"glib-E04"});
    EXPECT_EQ(idsOf("CubeMap 6 a b c d e f g"), Ids{"glib-W07"});
}

TEST(RenderToTexture, TakesUpToEightUnits) {
    EXPECT_EQ(numbersOf("RenderToTexture 6 7 8"), (Numbers{6, 7, 8}));
    EXPECT_TRUE(idsOf("RenderToTexture 1 2 3 4 5 6 7 8").empty());
    EXPECT_EQ(idsOf("RenderToTexture 1 2 3 4 5 6 7 8 9"), Ids{"glib-E15"});
}

TEST(Clamp, TakesSixWords) {
    for (const char* on : {"Clamp", "Clamp on", "Clamp 1", "Clamp TRUE", "Clamp 1."})
        EXPECT_EQ(numbersOf(on), Numbers{1}) << on;
    for (const char* off : {"Clamp OFF", "Clamp 0", "Clamp false"})
        EXPECT_EQ(numbersOf(off), Numbers{0}) << off;
    EXPECT_EQ(idsOf("Clamp maybe"), Ids{"glib-E16"});
    EXPECT_EQ(idsOf("Clamp 2"), Ids{"glib-E16"});
}

TEST(Topology, IsStoredWithoutPrefixInLowerCase) {
    EXPECT_EQ(textOf("glBegin gl_patches"), "patches");
    EXPECT_EQ(textOf("glBegin GL_Lines_Adjacency"), "lines_adjacency");
    EXPECT_EQ(textOf("GeometryInput gl_triangles"), "triangles");
    EXPECT_EQ(textOf("GeometryInputType triangles_adjacency"), "triangles_adjacency");
    EXPECT_EQ(textOf("GeometryOutputType gl_line_strip"), "line_strip");
    EXPECT_EQ(textOf("GeometryOutput triangles_strip"), "triangle_strip");
}

TEST(Topology, EveryWordOfAListIsKnown) {
    for (const char* word :
         {"points", "lines", "line_strip", "line_loop", "triangles", "triangle_strip", "triangle_fan",
          "polygon", "quads", "quad_strip", "lines_adjacency", "line_strip_adjacency", "triangles_adjacency",
          "triangle_strip_adjacency", "patches"})
        EXPECT_EQ(textOf(std::string("glBegin ") + word), word);
}

TEST(Topology, UnknownWordsAreRefused) {
    EXPECT_EQ(idsOf("glBegin hexagons"), Ids{"glib-E08"});
    EXPECT_EQ(idsOf("glBegin triangles_strip"), Ids{"glib-E08"});
    EXPECT_EQ(idsOf("GeometryInput quads"), Ids{"glib-E08"});
    EXPECT_EQ(idsOf("GeometryOutput triangles"), Ids{"glib-E08"});
    EXPECT_EQ(idsOf("glBegin"), Ids{"glib-E04"});
}

TEST(Topology, ListWithAnUnknownWordIsLeftOutAsAWhole) {
    EXPECT_EQ(wordsOf("glBegin hexagons\nglVertex 0 0 0\nColor 1 0 0\nglEnd\nTeapot"),
              (Words{"Color", "Teapot"}));
    EXPECT_EQ(wordsOf("glBegin hexagons\nglVertex 0 0 0\nglBegin points\nglVertex 0 0 0\nglEnd"),
              (Words{"glBegin", "glVertex", "glEnd"}));
}

}  // namespace
}  // namespace glibra::glib::test
