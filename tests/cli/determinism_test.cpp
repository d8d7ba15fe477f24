// A picture has the same bits with EGL and OSMesa, with one thread and two, drawn once or twice, in tiles or
// as a whole.

#include <gtest/gtest.h>

#include <algorithm>

#include "program.h"

namespace glibra::test {
namespace {

class Determinism : public testing::Test {
  protected:
    void SetUp() override {
        folder.write("a.vert",
                     "#version 330 core\nout vec3 vN;\nout vec3 vMC;\nvoid main() {\n  vN = uNormalMatrix * "
                     "aNormal;\n  vMC = "
                     "aVertex.xyz;\n  gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n");
        folder.write(
            "a.frag",
            "#version 330 core\nin vec3 vN;\nin vec3 vMC;\nout vec4 fColor;\nvoid main() {\n  vec4 n = "
            "texture(Noise3, vMC);\n  float s = n.r + n.g + n.b + n.a - 1.;\n  vec3 c = s * vec3(1., .6, .2) "
            "* "
            "abs(normalize(vN).z);\n  if (mod(floor(gl_FragCoord.x / 8.) + floor(gl_FragCoord.y / 8.), 2.) < "
            "1.) c "
            "*= .8;\n  fColor = vec4(c, 1.);\n}\n");
        folder.write("scene.glib",
                     "LookAt 1 2 4  0 0 0  0 1 0\nVertex a.vert\nFragment a.frag\nProgram "
                     "P\nTeapot\nTranslate 0 -1 0\n"
                     "QuadXZ -.2 3 40 40\nVertex\nFragment\nColor 1 1 0\nLineWidth 5\nTranslate 0 1.5 "
                     "0\nProgram Flat\n"
                     "WireSphere .8 12 8\nPointSize 20\nPointCloud 3 3 3\n");
    }

    /// Renders with these arguments and environment and returns the bytes of the file.
    std::string picture(const std::string& arguments, const std::string& environment = {}) {
        const Finished run = glibra(folder.path(), "render scene.glib -o out.png " + arguments, environment);
        EXPECT_EQ(run.status, 0) << run.err;
        std::string bytes = readFile(folder / "out.png");
        EXPECT_GT(bytes.size(), 10000U);
        return bytes;
    }

    Folder folder;
};

TEST_F(Determinism, RunTwice) {
    EXPECT_EQ(picture(""), picture(""));
}

TEST_F(Determinism, EglAndOsmesa) {
    if (!hasOsmesa()) GTEST_SKIP() << kNoOsmesa;
    EXPECT_EQ(picture("--driver egl"), picture("--driver osmesa"));
}

TEST_F(Determinism, OneThreadAndTwo) {
    EXPECT_EQ(picture("", "LP_NUM_THREADS=1"), picture("", "LP_NUM_THREADS=2"));
    EXPECT_EQ(picture("", "LP_NUM_THREADS=0"), picture("", "LP_NUM_THREADS=2"));
}

TEST_F(Determinism, WithAndWithoutShaderCache) {
    EXPECT_EQ(picture("", "MESA_SHADER_CACHE_DISABLE=true"), picture(""));
}

TEST_F(Determinism, TilesJoinWithoutASeam) {
    const std::string whole = picture("--size 500x430");
    for (const char* tile : {"96", "177", "256"}) {
        const Finished run = glibra(
            folder.path(), std::string("render scene.glib -o tiled.png --size 500x430 --tile ") + tile);
        ASSERT_EQ(run.status, 0) << run.err;
        folder.write("whole.png", whole);
        // The clip coordinates of a tile are rounded differently, so pixels on an edge may change. No others
        // may.
        const Finished compared = glibra(folder.path(), "compare whole.png tiled.png --fraction 0.0005");
        EXPECT_EQ(compared.status, 0) << tile << ": " << compared.out;
    }
}

TEST_F(Determinism, SeveralJobsWriteTheSameFilesAsOne) {
    for (int i = 0; i < 5; ++i)
        folder.write("s" + std::to_string(i) + ".glib",
                     "LookAt 0 0 " + std::to_string(3 + i) + " 0 0 0 0 1 0\nWireTeapot\n");
    const std::string scenes = "render s0.glib s1.glib s2.glib s3.glib s4.glib ";
    ASSERT_EQ(glibra(folder.path(), scenes + "-o one --jobs 1").status, 0);
    ASSERT_EQ(glibra(folder.path(), scenes + "-o three --jobs 3").status, 0);
    for (int i = 0; i < 5; ++i) {
        const std::string name = "s" + std::to_string(i) + ".png";
        EXPECT_EQ(readFile(folder / ("one/" + name)), readFile(folder / ("three/" + name))) << name;
    }
}

TEST_F(Determinism, FramesOfAnAnimationAreThePicturesOfTheirTimes) {
    folder.write(
        "a.frag",
        "#version 330 core\nin vec3 vN;\nout vec4 f;\nvoid main() { f = vec4(Timer, abs(vN.xy), 1.); }\n");
    folder.write("scene.glib",
                 "LookAt 0 0 4 0 0 0 0 1 0\nTimer 2\nVertex a.vert\nFragment a.frag\nProgram P\nTeapot\n");
    const Finished film = glibra(folder.path(), "render scene.glib -o film.png --frames 12 --fps 10");
    ASSERT_EQ(film.status, 0) << film.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "film_0012.png"));
    for (const int frame : {0, 3, 11}) {
        const std::string number = frame < 10 ? "0" + std::to_string(frame) : std::to_string(frame);
        folder.write("still.png", picture("--time " + std::to_string(frame / 10.0)));
        const Finished compared = glibra(folder.path(), "compare still.png film_00" + number + ".png");
        EXPECT_EQ(compared.status, 0) << frame << ": " << compared.out;
    }
}

TEST_F(Determinism, SeveralJobsWriteTheSameAnimationAsOne) {
    folder.write(
        "a.frag",
        "#version 330 core\nin vec3 vN;\nout vec4 f;\nvoid main() { f = vec4(Timer, abs(vN.xy), 1.); }\n");
    // 50 frames, the last 10 of which repeat the first 10.
    folder.write("repeat.glib",
                 "WindowSize 90 80\nLookAt 0 0 4 0 0 0 0 1 0\nTimer 4\nVertex a.vert\nFragment a.frag\n"
                 "Program P uNone 1\nTeapot\n");
    const std::string command = "render repeat.glib --frames 50 --fps 10 ";
    const Finished one = glibra(folder.path(), command + "-o one/f.png --jobs 1");
    ASSERT_EQ(one.status, 0) << one.err;
    for (const std::string jobs : {"2", "5"}) {
        const Finished several =
            glibra(folder.path(), command + "-o several" + jobs + "/f.png --jobs " + jobs);
        ASSERT_EQ(several.status, 0) << several.err;
        EXPECT_EQ(several.err, one.err) << "the warning about uNone stands there once";
        for (int i = 0; i < 50; ++i) {
            const std::string name = (i < 10 ? "f_000" : "f_00") + std::to_string(i) + ".png";
            EXPECT_EQ(readFile(folder / ("several" + jobs + "/" + name)), readFile(folder / ("one/" + name)))
                << name;
        }
        EXPECT_FALSE(std::filesystem::exists(folder / ("several" + jobs + "/f_0050.png")));
    }
}

TEST_F(Determinism, SeveralJobsReportNanAsOneDoes) {
    // From .5 seconds on, the square root of a negative number occurs in more and more pixels, so that every
    // frame would have another message. Another draw adds its own in a frame that another process draws.
    folder.write("a.frag",
                 "#version 330 core\nuniform float uStart;\nout vec4 f;\nvoid main() { f = "
                 "vec4(sqrt(1. + gl_FragCoord.x / 99. - 4. * Timer + uStart)); }\n");
    folder.write("scene.glib",
                 "WindowSize 90 80\nLookAt 0 0 4 0 0 0 0 1 0\nTimer 2\nVertex a.vert\nFragment a.frag\n"
                 "Program P uStart 0.\nQuadXY 0 .5\nTranslate .5 .5 .1\nProgram Q uStart .5\nQuadXY 0 .5\n");
    const std::string command = "render scene.glib --check-nan --frames 32 --fps 20 -o f.png ";
    const Finished one = glibra(folder.path(), command + "--jobs 1");
    ASSERT_EQ(one.status, 0) << one.err;
    EXPECT_EQ(std::count(one.err.begin(), one.err.end(), '\n'), 3) << one.err;
    EXPECT_NE(one.err.find("the picture has only one colour (frame "), std::string::npos) << one.err;
    EXPECT_NE(one.err.find("scene.glib:7:1: warning: QuadXY leaves NaN"), std::string::npos) << one.err;
    EXPECT_NE(one.err.find("scene.glib:10:1: warning: QuadXY leaves NaN"), std::string::npos) << one.err;
    for (const std::string jobs : {"2", "3", "4"}) {
        EXPECT_EQ(glibra(folder.path(), command + "--jobs " + jobs).err, one.err) << jobs;
        const Finished strict = glibra(folder.path(), command + "--strict --jobs " + jobs);
        EXPECT_EQ(strict.status, 3);
        EXPECT_EQ(strict.err, glibra(folder.path(), command + "--strict --jobs 1").err);
    }
}

TEST_F(Determinism, Gl41DrawsTheSamePictureUpToRounding) {
    folder.write("whole.png", picture(""));
    const Finished old =
        glibra(folder.path(), "render scene.glib -o old.png", "MESA_GL_VERSION_OVERRIDE=4.1");
    ASSERT_EQ(old.status, 0) << old.err;
    const Finished compared = glibra(folder.path(), "compare whole.png old.png --max 1");
    EXPECT_EQ(compared.status, 0) << compared.out;
}

}  // namespace
}  // namespace glibra::test
