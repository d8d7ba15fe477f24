// Animations of scenes that change with time: whole, in parts and frame by frame.

#include <gtest/gtest.h>

#include "program.h"

namespace glibra::test {
namespace {

class AnimatedScene : public testing::Test {
  protected:
    void SetUp() override {
        folder.write(
            "scene.glib",
            "WindowSize 80 60\nBackground .1 .1 .2\nLet rate <0 1 4>\n"
            "Camera eye LookAt 0 1 6  0 0 0  0 1 0  Perspective 40 .1 100\n"
            "Group ball x 0\nTranslate (x) (sin(rate*time)) 0\nColor (fract(.3*time)) .5 .8\nSphere .6\n"
            "EndGroup\nRepeat 3\nDraw ball x (1.5*i - 1.5)\nEndRepeat\n");
    }
    std::string frame(int number) { return readFile(folder / ("a_000" + std::to_string(number) + ".png")); }

    Folder folder;
};

TEST_F(AnimatedScene, IsTheSameWholeInPartsAndFrameByFrame) {
    const Finished whole = glibra(folder.path(), "render scene.glib -o a.png --frames 6 --fps 4 --jobs 1");
    ASSERT_EQ(whole.status, 0) << whole.err;
    std::string frames[6];
    for (int i = 0; i < 6; ++i) {
        frames[i] = frame(i);
        EXPECT_GT(frames[i].size(), 100U) << i;
        if (i > 0) {
            EXPECT_NE(frames[i], frames[i - 1]) << "frame " << i << " differs from the one before it";
        }
    }
    const Finished parts = glibra(folder.path(), "render scene.glib -o a.png --frames 6 --fps 4 --jobs 2");
    ASSERT_EQ(parts.status, 0) << parts.err;
    for (int i = 0; i < 6; ++i) EXPECT_EQ(frame(i), frames[i]) << i;
    for (int i = 0; i < 6; ++i) {
        const Finished one =
            glibra(folder.path(), "render scene.glib -o one.png --time " + std::to_string(.25 * i));
        ASSERT_EQ(one.status, 0) << one.err;
        ASSERT_EQ(glibra(folder.path(), "compare --exact one.png a_000" + std::to_string(i) + ".png").status,
                  0)
            << i;
    }
}

TEST_F(AnimatedScene, VariablesAreSetOnTheCommandLineAndInSuites) {
    folder.write("suite.toml",
                 "goldens = \"goldens\"\n[[shot]]\nscript = \"scene.glib\"\ntime = 1\nset = { rate = 2 }\n");
    ASSERT_EQ(glibra(folder.path(), "test suite.toml --update").status, 0);
    const Finished set = glibra(folder.path(), "render scene.glib -o set.png --time 1 --set rate=2");
    ASSERT_EQ(set.status, 0) << set.err;
    EXPECT_EQ(set.err.find("W23"), std::string::npos) << set.err;
    const Finished compared = glibra(folder.path(), "compare --exact set.png goldens/scene.png");
    EXPECT_EQ(compared.status, 0) << compared.out << compared.err << shell(folder.path(), "ls goldens").out;
    const Finished wrong = glibra(folder.path(), "render scene.glib -o wrong.png --set rat=2");
    EXPECT_NE(wrong.err.find("rat"), std::string::npos) << wrong.err;
}

TEST_F(AnimatedScene, NoSkipDrawsTheSamePictures) {
    ASSERT_EQ(glibra(folder.path(), "render scene.glib -o a.png --frames 3 --fps 2").status, 0);
    std::string frames[3];
    for (int i = 0; i < 3; ++i) frames[i] = frame(i);
    ASSERT_EQ(glibra(folder.path(), "render scene.glib -o a.png --frames 3 --fps 2 --no-skip").status, 0);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(frame(i), frames[i]) << i;
}

}  // namespace
}  // namespace glibra::test
