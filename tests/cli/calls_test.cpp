// The OpenGL calls of a picture, as --trace lists them: what draws and passes share is made once.

#include <gtest/gtest.h>

#include <string>

#include "program.h"

namespace glibra::test {
namespace {

int count(const std::string& text, const std::string& word) {
    int found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
    return found;
}

std::string traced(const std::string& scene) {
    const Folder folder;
    folder.write("a.glib", scene);
    const Finished run = glibra(folder.path(), "render a.glib -o a.png --trace");
    EXPECT_EQ(run.status, 0) << run.err;
    return run.out;
}

TEST(Calls, DrawsThatDifferInUniformsShareAVertexArray) {
    const std::string calls = traced(
        "WindowSize 32 32\nVertex inline\n#version 330\nin vec3 position; uniform float uShift;\n"
        "void main() { gl_Position = vec4(position * .1 + vec3(uShift, 0., 0.), 1.); }\nEndVertex\n"
        "Fragment inline\n#version 330\nuniform float uTone; out vec4 c;\nvoid main() { c = vec4(uTone); }\n"
        "EndFragment\nProgram P\nRepeat 20 as k\nSet uShift (k * .05 - .5)\nSet uTone (k / 20)\nBox "
        "1 1 1\nEndRepeat\n"
        "Camera eye LookAt 0 0 5 0 0 0 0 1 0 Perspective 50 1 10\n");
    EXPECT_EQ(count(calls, "glDrawElements("), 20) << calls;
    EXPECT_LE(count(calls, "glGenVertexArrays("), 1) << calls;
}

TEST(Calls, FilledLayersNeedNoDepthBuffer) {
    const std::string calls = traced(
        "WindowSize 16 16\nTexture3D t 16 16 16 r8 nearest\nFragment inline\n#version 330 core\n"
        "out vec4 fColor;\nvoid main() { fColor = vec4(.5); }\nEndFragment\nProgram P\nOnce\nRepeat 16 as k\n"
        "Fill t.layer(k) with P\nEndRepeat\nEndOnce\nFragment inline\n#version 330 core\n"
        "uniform sampler3D t; out vec4 fColor;\nvoid main() { fColor = texture(t, vec3(.5)); }\nEndFragment\n"
        "Program W\nFill window with W\n");
    EXPECT_EQ(count(calls, "glDrawArrays("), 17) << calls;
    EXPECT_EQ(count(calls, "glRenderbufferStorage"), 0) << calls;
    EXPECT_EQ(count(calls, "glTexStorage"), 0) << calls;
    EXPECT_LE(count(calls, "glGetInternalformativ("), 16) << calls;
}

TEST(Translated, HasEachProgramOnceAndAFolderForEachOfSeveralScenes) {
    const Folder folder;
    const std::string scene =
        "WindowSize 16 16\nTexture2D t 8 8 rgba8\nFragment inline\n#version 330\nuniform float uTone; out "
        "vec4 c;\n"
        "void main() { c = vec4(uTone); }\nEndFragment\nProgram Made\nOnce\nFill t with Made\nEndOnce\n"
        "Fragment inline\n#version 330\nuniform float uTone; uniform sampler2D t; out vec4 c;\n"
        "void main() { c = vec4(uTone) + texture(t, vec2(.5)); }\nEndFragment\nProgram Shown\nRepeat 3 as k\n"
        "Set uTone (k * .1)\nFill window with Shown\nEndRepeat\n";
    folder.write("a.glib", scene);
    folder.write("deeper/a.glib", scene);
    ASSERT_EQ(glibra(folder.path(), "check a.glib --translated one").status, 0);
    int made = 0, shown = 0;
    for (const auto& each : std::filesystem::directory_iterator(folder / "one")) {
        made += each.path().filename().string().find("-Made.frag") != std::string::npos ? 1 : 0;
        shown += each.path().filename().string().find("-Shown.frag") != std::string::npos ? 1 : 0;
    }
    EXPECT_EQ(made, 1);
    EXPECT_EQ(shown, 1);
    ASSERT_EQ(glibra(folder.path(), "check . --translated all").status, 0);
    EXPECT_TRUE(std::filesystem::is_directory(folder / "all/a"));
    EXPECT_TRUE(std::filesystem::is_directory(folder / "all/deeper/a"));
}

}  // namespace
}  // namespace glibra::test
