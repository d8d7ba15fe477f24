// render --incomplete: a missing file costs what it feeds, the picture is marked, and the exit status is 3.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "image/read.h"
#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

class Incomplete : public testing::Test {
  protected:
    Incomplete() {
        folder.write("v.vert", "void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
        folder.write("green.frag", "void main() { gl_FragColor = vec4(0., 1., 0., 1.); }\n");
        folder.write("bad.frag", "void main() { gl_FragColor = nonsense; }\n");
        folder.write("map.frag",
                     "uniform sampler2D uMap;\nvoid main() { gl_FragColor = texture2D(uMap, vec2(.5)); }\n");
    }

    /// Draws the scene with --incomplete and returns the picture, which must exist with exit status 3.
    image::Image drawn(const std::string& scene, const std::string& options = {}) {
        folder.write("a.glib", "Background 0 0 1\nOrtho -2 2 -2 2\nLookAt 0 0 5 0 0 0 0 1 0\n" + scene);
        EXPECT_EQ(glibra(folder.path(), "render a.glib -o whole.png --size 100x100" + options).status, 3);
        EXPECT_FALSE(fs::exists(folder / "whole.png")) << "without --incomplete nothing is drawn";
        run = glibra(folder.path(), "render a.glib -o a.png --size 100x100 --incomplete" + options);
        EXPECT_EQ(run.status, 3) << run.err;
        const Result<image::Image> picture = image::readImage(folder / "a.png");
        return picture ? *picture : image::Image();
    }

    static std::string pixel(const image::Image& picture, int x, int y) {
        if (picture.data.empty()) return "no picture";
        const std::byte* at = picture.row(y).data() + static_cast<std::size_t>(x * picture.components);
        return std::to_string(std::to_integer<int>(at[0])) + " " +
               std::to_string(std::to_integer<int>(at[1])) + " " +
               std::to_string(std::to_integer<int>(at[2]));
    }

    /// The yellow and black of the mark are in the corner, and only at the edge.
    static void expectMarked(const image::Image& picture) {
        EXPECT_EQ(pixel(picture, 0, 0), "255 204 0");
        bool hasBlack = false;
        for (int x = 0; x < 100; ++x) hasBlack = hasBlack || pixel(picture, x, 99) == "0 0 0";
        EXPECT_TRUE(hasBlack);
        EXPECT_EQ(pixel(picture, 50, 5), "0 0 255");
    }

    Folder folder;
    Finished run;
};

// Left of the middle a green ball, right of it what is wrong.
constexpr const char* kGreen =
    "Vertex v.vert\nFragment green.frag\nProgram G\nPushMatrix\nTranslate -1 0 0\nSphere .7\nPopMatrix\n";

TEST_F(Incomplete, AMissingShaderCostsItsObject) {
    const image::Image picture =
        drawn(std::string(kGreen) +
              "Vertex v.vert\nFragment none.frag\nProgram N\nPushMatrix\nTranslate 1 0 0\n"
              "Sphere .7\nPopMatrix\n");
    EXPECT_EQ(pixel(picture, 25, 50), "0 255 0");
    EXPECT_NE(pixel(picture, 75, 50), "0 0 255") << "its shape is shown";
    EXPECT_NE(pixel(picture, 75, 50), "0 255 0");
    expectMarked(picture);
    EXPECT_NE(run.err.find("none.frag"), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("[file-E01]"), run.err.rfind("[file-E01]")) << "once: " << run.err;
}

TEST_F(Incomplete, AShaderThatDoesNotCompileCostsItsObject) {
    const image::Image picture =
        drawn(std::string(kGreen) +
              "Vertex v.vert\nFragment bad.frag\nProgram N\nPushMatrix\nTranslate 1 0 0\n"
              "Sphere .7\nPopMatrix\n");
    EXPECT_EQ(pixel(picture, 25, 50), "0 255 0");
    expectMarked(picture);
    EXPECT_NE(run.err.find("bad.frag:1:"), std::string::npos) << run.err;
}

TEST_F(Incomplete, AMissingModelCostsItself) {
    const image::Image picture = drawn(std::string(kGreen) + "Obj none.obj\n");
    EXPECT_EQ(pixel(picture, 25, 50), "0 255 0");
    EXPECT_EQ(pixel(picture, 75, 50), "0 0 255");
    expectMarked(picture);
}

TEST_F(Incomplete, AMissingTextureCostsItsTexels) {
    const image::Image picture =
        drawn(std::string(kGreen) +
              "Texture 5 none.bmp\nVertex v.vert\nFragment map.frag\nProgram M uMap 5\n"
              "PushMatrix\nTranslate 1 0 0\nSphere .7\nPopMatrix\n");
    EXPECT_EQ(pixel(picture, 25, 50), "0 255 0");
    EXPECT_NE(pixel(picture, 75, 50), "0 0 255") << "the ball is there, without its picture";
    expectMarked(picture);
}

TEST_F(Incomplete, AnUnknownCommandCostsItself) {
    const image::Image picture = drawn(std::string(kGreen) + "Spere 1\n");
    EXPECT_EQ(pixel(picture, 25, 50), "0 255 0");
    expectMarked(picture);
}

TEST_F(Incomplete, AnAnimationIsDrawnToItsEnd) {
    folder.write("a.glib", std::string("LookAt 0 0 5 0 0 0 0 1 0\n") + kGreen + "Obj none.obj\n");
    run = glibra(folder.path(), "render a.glib -o f.png --size 20x20 --frames 3 --incomplete");
    EXPECT_EQ(run.status, 3);
    for (const char* each : {"f_0000.png", "f_0001.png", "f_0002.png"})
        EXPECT_TRUE(fs::exists(folder / each)) << each;
}

TEST_F(Incomplete, AWholeSceneIsNotMarked) {
    folder.write("a.glib", std::string("LookAt 0 0 5 0 0 0 0 1 0\n") + kGreen);
    ASSERT_EQ(glibra(folder.path(), "render a.glib -o a.png --size 64x64").status, 0);
    ASSERT_EQ(glibra(folder.path(), "render a.glib -o b.png --size 64x64 --incomplete").status, 0);
    EXPECT_EQ(readFile(folder / "a.png"), readFile(folder / "b.png"));
}

TEST_F(Incomplete, ASceneThatCannotBeReadHasNoPicture) {
    run = glibra(folder.path(), "render none.glib -o a.png --incomplete");
    EXPECT_EQ(run.status, 3);
    EXPECT_FALSE(fs::exists(folder / "a.png"));
}

}  // namespace
}  // namespace glibra::test
