// `glibra render --trace` and Print: what a picture was made of, without a window.

#include <gtest/gtest.h>

#include <string>

#include "program.h"

namespace glibra::test {
namespace {

constexpr const char* kTracedScene =
    "WindowSize 16 16\nTexture2D t 8 4 rgba8\nFragment inline\n#version 330\nout vec4 c;\n"
    "void main() { c = vec4(1.); }\nEndFragment\nProgram P\nFill t with P\nSphere 1\n";

TEST(Trace, ListsTheCallsOfThePictureByStatement) {
    const Folder folder;
    folder.write("a.glib", kTracedScene);
    const Finished run = glibra(folder.path(), "render a.glib -o a.png --trace --no-skip");
    ASSERT_EQ(run.status, 0) << run.err;
    const std::size_t fill = run.out.find("a.glib:9\n"), sphere = run.out.find("a.glib:10\n");
    ASSERT_NE(fill, std::string::npos) << run.out;
    ASSERT_NE(sphere, std::string::npos) << run.out;
    EXPECT_TRUE(contains(run.out.substr(fill, sphere - fill), "  glViewport(0, 0, 8, 4)\n")) << run.out;
    EXPECT_TRUE(contains(run.out.substr(fill, sphere - fill), "  glDrawArrays(GL_TRIANGLES, 0, 3)\n"))
        << run.out;
    EXPECT_TRUE(contains(run.out.substr(sphere), "  glDrawElements(GL_TRIANGLES, ")) << run.out;
    EXPECT_FALSE(contains(run.out, "glCompileShader")) << "loading is not of the picture";
    const Finished without = glibra(folder.path(), "render a.glib -o b.png --no-skip");
    EXPECT_EQ(without.out, "");
    EXPECT_EQ(readFile(folder / "a.png"), readFile(folder / "b.png"));
}

TEST(Trace, IsThatOfTheLastFrame) {
    const Folder folder;
    folder.write("a.glib", "WindowSize 16 16\nTranslate (time) 0 0\nSphere 1\n");
    const Finished run = glibra(folder.path(), "render a.glib -o a.png --frames 3 --trace");
    ASSERT_EQ(run.status, 0) << run.err;
    const std::size_t first = run.out.find("glDrawElements");
    ASSERT_NE(first, std::string::npos) << run.out;
    EXPECT_EQ(run.out.find("glDrawElements", first + 1), std::string::npos) << run.out;
}

TEST(Print, ReportsElementsOfBuffers) {
    const Folder folder;
    folder.write(
        "a.glib",
        "WindowSize 16 16\nBuffer p vec2 4 (vec2(i, .5*i))\nPrint p\nPrint p 1\nPrint p 2 9\nPrint p 7\n"
        "Sphere 1\n");
    for (const char* command : {"render a.glib -o a.png", "check --run a.glib"}) {
        const Finished run = glibra(folder.path(), command);
        EXPECT_EQ(run.status, 0) << run.err;
        for (const char* each : {"3:1: note: p[0]: 0 0", "3:1: note: p[1]: 1 0.5", "3:1: note: p[2]: 2 1",
                                 "3:1: note: p[3]: 3 1.5", "4:1: note: p[1]: 1 0.5", "5:1: note: p[2]: 2 1",
                                 "5:1: note: p[3]: 3 1.5", "6:1: note: Print p: it has 4 elements"})
            EXPECT_TRUE(contains(run.err, std::string("a.glib:") + each + " [check-N02]")) << each << run.err;
    }
    folder.write("b.glib", "WindowSize 16 16\nPrint p\nSphere 1\n");
    EXPECT_TRUE(contains(glibra(folder.path(), "check b.glib").err, "no texture or buffer 'p'"));
}

TEST(Check, SearchesForNaN) {
    const Folder folder;
    folder.write(
        "a.glib",
        "WindowSize 16 16\nFragment inline\n#version 330\nuniform float uZero;\nout vec4 c;\n"
        "void main() { c = vec4(uZero/uZero); }\nEndFragment\nProgram P uZero 0\nFill window with P\n");
    EXPECT_EQ(glibra(folder.path(), "check --run a.glib").err.find("draw-W06"), std::string::npos);
    const Finished run = glibra(folder.path(), "check --run --check-nan a.glib");
    EXPECT_TRUE(contains(run.err, "a.glib:9:1")) << run.err;
    EXPECT_TRUE(contains(run.err, "[draw-W06]")) << run.err;
}

}  // namespace
}  // namespace glibra::test
