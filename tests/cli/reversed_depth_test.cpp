// Reversed depth with drivers that cannot let z go from 0 to w.

#include <gtest/gtest.h>

#include <string>

#include "program.h"

namespace glibra::test {
namespace {

constexpr const char* kReversed = R"(WindowSize 96 64
Camera eye LookAt 3 2 6  0 0 0  0 1 0  Perspective 50 .1 100
Texture2D map 64 64 rgba8
Pass map reversed
    Color 1 1 0
    Torus .4 1.6
EndPass
Pass window reversed clear {0 0 .2} depth .99
    Color 1 0 0
    Sphere 1
    State offset 1 0  depthrange .1 1
    Color 0 1 0
    Box 1.6
EndPass
)";

constexpr const char* kWithout = "MESA_EXTENSION_OVERRIDE='-GL_ARB_clip_control -GL_EXT_clip_control'";

TEST(ReversedDepth, HasTheSamePictureWithoutClipControl) {
    const Folder folder;
    folder.write("scene.glib", kReversed);
    ASSERT_EQ(glibra(folder.path(), "render scene.glib -o exact.png").status, 0);
    const std::string exact = readFile(folder / "exact.png");
    struct Way {
        const char* arguments;
        std::string environment;
        bool isTold;
    };
    const std::string old = "MESA_GL_VERSION_OVERRIDE=4.1 ";
    for (const Way& each :
         {Way{"", "LP_NUM_THREADS=1", false}, Way{"", old, false}, Way{"", old + kWithout, true},
          Way{"--driver gles", "", false}, Way{"--driver gles", kWithout, true}}) {
        SCOPED_TRACE(each.environment + each.arguments);
        const Finished run = glibra(
            folder.path(), std::string("render scene.glib -o out.png ") + each.arguments, each.environment);
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_EQ(readFile(folder / "out.png"), exact);
        const std::size_t told = run.err.find("draw-W21");
        EXPECT_EQ(told != std::string::npos, each.isTold) << run.err;
        EXPECT_EQ(told, run.err.rfind("draw-W21")) << "once: " << run.err;
    }
}

TEST(ReversedDepth, SaysWhatIsInexactWithoutClipControl) {
    const Folder folder;
    folder.write("scene.glib",
                 "WindowSize 8 8\nCamera eye LookAt 0 0 0  0 0 -1  0 1 0  Perspective 50 .01 1e6\n"
                 "Pass window reversed\nTranslate 0 0 -9\nSphere\nEndPass\n");
    EXPECT_EQ(glibra(folder.path(), "render scene.glib -o a.png").err, "");
    const std::string err = glibra(folder.path(), "render scene.glib -o a.png",
                                   "MESA_GL_VERSION_OVERRIDE=4.1 " + std::string(kWithout))
                                .err;
    EXPECT_NE(err.find("draw-W19"), std::string::npos) << err;
    EXPECT_NE(err.find("draw-W21"), std::string::npos) << err;
}

}  // namespace
}  // namespace glibra::test
