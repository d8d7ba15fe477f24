// FullScreen, SkyBox, and solids with adjacency, as pictures.

#include <gtest/gtest.h>

#include <cmath>

#include "../gpu/stored_numbers.h"
#include "scene_text.h"

namespace glibra::test {
namespace {

constexpr std::array<int, 3> kRedPixel{255, 0, 0};

const std::map<std::string, std::string> kDirections{
    {"a.vert",
     "#version 330 core\nout vec3 vDirection;\nvoid main() {\n  vDirection = aTexCoord0.stp;\n"
     "  gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n"},
    {"a.frag",
     "#version 330 core\nin vec3 vDirection;\nout vec4 fColor;\nvoid main() {\n"
     "  fColor = vec4(.5 + .5 * normalize(vDirection), 1.);\n}\n"}};
const std::string kSky = "Vertex a.vert\nFragment a.frag\nProgram Sky\nSkyBox";

/// A program that shows the current colour.
const std::string kShowColor = "Vertex flat.vert\nGeometry\nFragment flat.frag\nProgram Flat\n";
std::map<std::string, std::string> withFlat(std::map<std::string, std::string> files) {
    files["flat.vert"] =
        "#version 330 core\nout vec4 vColor;\nvoid main() {\n  vColor = aColor;\n"
        "  gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n";
    files["flat.frag"] =
        "#version 330 core\nin vec4 vColor;\nout vec4 fColor;\nvoid main() { fColor = vColor; }\n";
    return files;
}

TEST(FullScreen, CoversEveryPixelWhateverTheView) {
    for (const char* view :
         {"", "Ortho 0 9 0 2\n", "Perspective 3 5 6\nLookAt 9 8 7 1 2 3 0 0 1\nScale .01\n"})
        EXPECT_EQ(countPixels(picture("WindowSize 37 22\n" + std::string(view) + "Color 1 0 0\nFullScreen\n"),
                              kRedPixel),
                  37 * 22)
            << view;
}

TEST(FullScreen, TextureCoordinatesAreThoseOfThePixels) {
    const auto files = std::map<std::string, std::string>{
        {"a.vert",
         "#version 330 core\nout vec2 vST;\nvoid main() { vST = aTexCoord0.st; gl_Position = aVertex; }\n"},
        {"a.frag",
         "#version 330 core\nin vec2 vST;\nout vec4 fColor;\nvoid main() { fColor = vec4(vST, 0., 1.); }\n"}};
    const Picture seen =
        picture("WindowSize 64 32\nVertex a.vert\nFragment a.frag\nProgram P\nFullScreen\n", files);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            const std::array<int, 3> color = pixel(seen, x, y);
            expectStored(color[0], (x + .5) / 64 * 255, .01);
            expectStored(color[1], (31 - y + .5) / 32 * 255, .01);
        }
}

TEST(SkyBox, EachPixelReadsTheDirectionInWhichItLies) {
    // The eye looks along +x from anywhere; up is y, so right is +z.
    for (const char* eye : {"0 0 0 1 0 0", "5 6 7 6 6 7"}) {
        const Picture seen = picture("WindowSize 41 31\nPerspective 70 .1 50\nLookAt " + std::string(eye) +
                                         " 0 1 0\nTranslate 3 0 0\n" + kSky + "\n",
                                     kDirections);
        const double tangent = std::tan(35 * 3.14159265358979 / 180);
        for (int y = 0; y < 31; ++y)
            for (int x = 0; x < 41; ++x) {
                const double right = (x - 20) / 15.5 * tangent, up = (15 - y) / 15.5 * tangent;
                const double length = std::sqrt(1 + right * right + up * up);
                const std::array<int, 3> color = pixel(seen, x, y);
                expectStored(color[0], (.5 + .5 / length) * 255, .02);
                expectStored(color[1], (.5 + .5 * up / length) * 255, .02);
                expectStored(color[2], (.5 + .5 * right / length) * 255, .02);
            }
    }
}

TEST(SkyBox, IsBehindEverythingWhateverItsSizeAndOrder) {
    const std::string head = "WindowSize 40 40\nPerspective 50 2 30\nLookAt 0 0 25 0 0 0 0 1 0\n";
    const std::string wall = kShowColor + "Color 1 1 1\nQuadXY 0 4\n";
    const Picture first = picture(head + kSky + "\n" + wall, withFlat(kDirections));
    EXPECT_GT(countPixels(first, kWhite), 100);
    EXPECT_LT(countPixels(first, kWhite), 800);
    // 1: inside the near plane; 1000: beyond the far plane.
    for (const char* size : {"", " 1", " 20", " 1000"})
        EXPECT_TRUE(isSame(first, picture(head + wall + kSky + size + "\n", withFlat(kDirections)))) << size;
}

TEST(SkyBox, StaysWhereItIsWhenTheWindowMovesTheScene) {
    const std::string scene = "WindowSize 40 30\nPerspective 60\nLookAt 1 1 1 4 2 0 0 1 0\n" + kSky + "\n";
    const Picture still = picture(scene, kDirections);
    for (const bool ofScene : {true, false}) {
        RenderOptions moved;
        (ofScene ? moved.viewState.scene : moved.viewState.eye) = {1, 0, 0, 0, 0, 1, 0, 0,
                                                                   0, 0, 1, 0, 5, 3, 2, 1};
        const Picture seen = picture(scene, kDirections, moved);
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 40; ++x)
                for (std::size_t i = 0; i < 3; ++i)
                    EXPECT_NEAR(pixel(seen, x, y)[i], pixel(still, x, y)[i], 1) << ofScene;
    }
}

TEST(SkyBox, IsDrawnTheSameInTiles) {
    RenderOptions tiled;
    tiled.tileSize = 16;
    const std::string scene = "WindowSize 40 30\nPerspective 60\nLookAt 1 1 1 4 2 0 0 1 0\n" + kSky +
                              "\nProgram Q\nColor 1 1 1\nSphere .3\n";
    EXPECT_TRUE(isSame(picture(scene, kDirections), picture(scene, kDirections, tiled)));
}

/// Draws the edges between triangles that face the eye and those that do not.
std::map<std::string, std::string> outlined(const std::string& input) {
    const std::string facing =
        "bool faces(vec3 a, vec3 b, vec3 c) { return dot(cross(b - a, c - a), a) < 0.; }\n";
    const std::string send =
        "void send(int i) { gl_Position = uProjectionMatrix * gl_in[i].gl_Position; EmitVertex(); }\n"
        "vec3 at(int i) { return gl_in[i].gl_Position.xyz; }\n";
    const std::string body =
        input == "triangles_adjacency"
            ? "  if (!faces(at(0), at(2), at(4))) return;\n  for (int i = 0; i < 6; i += 2) {\n"
              "    int j = (i + 2) % 6;\n    if (faces(at(j), at(i), at(i + 1))) continue;\n"
              "    send(i); send(j); EndPrimitive();\n  }\n"
            : "  if (faces(at(0), at(1), at(2)) == faces(at(3), at(2), at(1))) return;\n"
              "  send(1); send(2); EndPrimitive();\n";
    return {{"a.vert", "#version 330 core\nvoid main() { gl_Position = uModelViewMatrix * aVertex; }\n"},
            {"a.geom", "#version 330 core\nlayout(" + input +
                           ") in;\nlayout(line_strip, max_vertices = 6) out;\n" + facing + send +
                           "void main() {\n" + body + "}\n"},
            {"a.frag", "#version 330 core\nout vec4 fColor;\nvoid main() { fColor = vec4(1.); }\n"}};
}
const std::string kOutline =
    "WindowSize 101 101\nBackground 0\nPerspective 40\nLookAt 0 0 5 0 0 0 0 1 0\n"
    "Vertex a.vert\nGeometry a.geom\nFragment a.frag\nProgram Outline\n";

TEST(SolidsWithAdjacency, ASpheresOutlineIsItsCircle) {
    const double radius = std::tan(std::asin(1 / 5.)) / std::tan(20 * 3.14159265358979 / 180) * 50.5;
    for (const char* input : {"triangles_adjacency", "lines_adjacency"}) {
        const Picture seen = picture(kOutline + "Sphere 1 90 60\n", outlined(input));
        int count = 0;
        for (int y = 0; y < 101; ++y)
            for (int x = 0; x < 101; ++x) {
                if (pixel(seen, x, y) != kWhite) continue;
                ++count;
                EXPECT_NEAR(std::hypot(x - 50, y - 50), radius, 1.6) << input;
            }
        // Lines of one pixel that go around once.
        EXPECT_GT(count, 4 * radius) << input;
        EXPECT_LT(count, 8 * radius) << input;
    }
}

TEST(SolidsWithAdjacency, AModelIsDrawnAsObjAdj) {
    auto files = outlined("triangles_adjacency");
    // An octahedron.
    files["a.obj"] =
        "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\nf 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\n"
        "f 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
    const Picture seen = picture(kOutline + "Rotate 20 1 1 0\nObj a.obj\n", files);
    EXPECT_GT(countPixels(seen, kWhite), 50);
    EXPECT_TRUE(isSame(seen, picture(kOutline + "Rotate 20 1 1 0\nObjAdj a.obj\n", files)));
}

TEST(SolidsWithAdjacency, OneShapeServesBothKindsOfPrograms) {
    const std::string scene = kOutline + "Torus\nTranslate 0 0 -.05\nColor 1 0 0\n" + kShowColor + "Torus\n";
    const auto files = withFlat(outlined("triangles_adjacency"));
    const Picture both = picture(scene, files);
    EXPECT_GT(countPixels(both, kWhite), 100);
    EXPECT_GT(countPixels(both, kRedPixel), 1000);
    RenderOptions all;
    all.skip = false;
    EXPECT_TRUE(isSame(both, picture(scene, files, all)));
}

}  // namespace
}  // namespace glibra::test
