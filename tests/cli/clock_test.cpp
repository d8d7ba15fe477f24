// A wall clock that jumps by years changes no verdict and ends nothing early or late.

#include <gtest/gtest.h>

#include <chrono>

#include "program.h"

namespace glibra::test {
namespace {

#ifdef GLIBRA_JUMPING_CLOCK

std::string jumping() {
    return preload(GLIBRA_JUMPING_CLOCK);
}

class JumpingClock : public testing::Test {
  protected:
    void SetUp() override {
        folder.write("a.vert",
                     "#version 330 core\nvoid main() { gl_Position = vec4(aVertex.xy, 0., 1.); }\n");
        folder.write("a.frag",
                     "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(fract(gl_FragCoord.xy / 17.), "
                     "fract(Timer), 1.); }\n");
        folder.write(
            "e.frag",
            "#version 330 core\nuniform int uMany;\nout vec4 f;\nvoid main() { float s = 0.; for (int i "
            "= 0; i < 2000000000 && s >= 0.; i++) s += abs(sin(float(i + uMany))); f = vec4(s); }\n");
        folder.write("a.glib",
                     "WindowSize 40 30\nVertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0 1 1 1\n");
        folder.write(
            "e.glib",
            "WindowSize 500 400\nVertex a.vert\nFragment e.frag\nProgram P uMany 1\nQuadXY 0 1 1 1\n");
        folder.write(
            "s.toml",
            "[[shot]]\nscript = \"a.glib\"\n[[shot]]\nname = \"b\"\nscript = \"a.glib\"\ntime = 0.5\n"
            "[[shot]]\nscript = \"e.glib\"\ntimeout = 2\n[[shot]]\nname = \"c\"\nscript = \"a.glib\"\n"
            "time = 0.7\n");
    }
    Folder folder;
};

TEST_F(JumpingClock, TheShimMovesTheWallClock) {
    // date(1) shows whether the library does anything.
    const Finished first = shell(folder.path(), jumping() + " date +%Y");
    const Finished now = shell(folder.path(), "date +%Y");
    EXPECT_NE(first.out, now.out);
}

TEST_F(JumpingClock, VerdictsAndTimeLimitsAreTheSame) {
    ASSERT_EQ(glibra(folder.path(), "test s.toml --update --only a --only b --only c").status, 0);
    for (const char* jobs : {"1", "2"}) {
        const auto start = std::chrono::steady_clock::now();
        const Finished run = glibra(folder.path(), std::string("test s.toml --jobs ") + jobs, jumping());
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        EXPECT_EQ(run.status, 3) << run.out << run.err;
        EXPECT_TRUE(contains(run.out, "1 timed-out, 3 passed")) << run.out;
        EXPECT_GE(seconds, 2.0) << "the limit came early";
        EXPECT_LT(seconds, 60.0) << "the limit came late";
        EXPECT_FALSE(contains(run.out + run.err, " in -")) << "a negative time is shown: " << run.out;
    }
}

TEST_F(JumpingClock, ScenesAndAnimationsAreTheSame) {
    ASSERT_EQ(glibra(folder.path(), "render a.glib --frames 12 -o free/f.png").status, 0);
    ASSERT_EQ(glibra(folder.path(), "render a.glib --frames 12 -o jumping/f.png", jumping()).status, 0);
    for (const char* each : {"f_0000.png", "f_0005.png", "f_0011.png"})
        EXPECT_EQ(readFile(folder.path() / "free" / each), readFile(folder.path() / "jumping" / each))
            << each;
    EXPECT_EQ(glibra(folder.path(), "render e.glib --timeout 1", jumping()).status, 3);
}

#endif

}  // namespace
}  // namespace glibra::test
