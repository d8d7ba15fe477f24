// Scenes from standard input and from folders, pictures to standard output, and the folders that are made.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "'" GLIBRA_PROGRAM "' ";

Finished piped(const Folder& folder, const std::string& scene, const std::string& arguments) {
    folder.write("in.txt", scene);
    return shell(folder.path(), "{ cat in.txt | " + std::string(kProgram) + arguments + "; }");
}

TEST(SceneArguments, ASceneFromStandardInputIsDrawnToStandardOutput) {
    const Folder folder;
    folder.write("a.glib", "Sphere\n");
    ASSERT_EQ(glibra(folder.path(), "render a.glib --size 16x12").status, 0);
    const Finished run = piped(folder, "Sphere\n", "render - --size 16x12");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out, readFile(folder / "a.png"));
    EXPECT_EQ(piped(folder, "Sphere\n", "render - --size 16x12 -o b.png").status, 0);
    EXPECT_EQ(readFile(folder / "b.png"), readFile(folder / "a.png"));
    EXPECT_EQ(folder.listing(), "a.glib\na.png\nb.png\nin.txt\n");
}

TEST(SceneArguments, FilesOfStandardInputAreInTheCurrentFolder) {
    const Folder folder;
    folder.write("v.vert", "void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    folder.write("f.frag", "void main() { gl_FragColor = vec4(1., 0., 0., 1.); }\n");
    const std::string scene = "Vertex v.vert\nFragment f.frag\nProgram P\nSphere\n";
    const Finished good = piped(folder, scene, "check -");
    EXPECT_EQ(good.status, 0) << good.err;
    const Finished wrong = piped(folder, "Sphere\nSpere\n", "check -");
    EXPECT_EQ(wrong.status, 3);
    EXPECT_NE(wrong.err.find("<stdin>:2:1: error: unknown command 'Spere'"), std::string::npos) << wrong.err;
    const Finished twice = piped(folder, scene, "check - -");
    EXPECT_EQ(twice.status, 3) << twice.err;
}

TEST(SceneArguments, AnEndlessStandardInputIsRefused) {
    const Folder folder;
    const Finished run = shell(folder.path(), "{ yes Sphere | " + std::string(kProgram) + "check -; }");
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("[glib-E15]"), std::string::npos) << run.err;
}

TEST(SceneArguments, AnAnimationOnStandardOutputIsItsPicturesInARow) {
    const Folder folder;
    folder.write("v.vert", "void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    folder.write("f.frag", "void main() { gl_FragColor = vec4(Timer, 0., 0., 1.); }\n");
    folder.write("a.glib", "Timer 1\nVertex v.vert\nFragment f.frag\nProgram P\nSphere 3\n");
    const std::string options = " --eye glman --size 16x12 --frames 5 --fps 4";
    ASSERT_EQ(glibra(folder.path(), "render a.glib -o f.png" + options).status, 0);
    const Finished run = glibra(folder.path(), "render a.glib -o -" + options);
    EXPECT_EQ(run.status, 0) << run.err;
    // Files are packed in another way, with equal pixels.
    constexpr std::string_view kEnd = "IEND";
    std::size_t begin = 0;
    for (const char* each : {"f_0000.png", "f_0001.png", "f_0002.png", "f_0003.png", "f_0004.png"}) {
        const std::size_t end = run.out.find(kEnd, begin);
        ASSERT_NE(end, std::string::npos) << each;
        const std::size_t next = end + kEnd.size() + 4;  // the checksum
        folder.write("one.png", run.out.substr(begin, next - begin));
        EXPECT_EQ(glibra(folder.path(), "compare one.png " + std::string(each) + " --exact").status, 0)
            << each;
        begin = next;
    }
    EXPECT_EQ(begin, run.out.size());
}

TEST(SceneArguments, APictureIsNotWrittenToATerminal) {
    const Folder folder;
    folder.write("a.glib", "Sphere\n");
    if (shell(folder.path(), "command -v script").status != 0) GTEST_SKIP() << "needs script(1)";
    shell(folder.path(), "script -qec '\"" GLIBRA_PROGRAM "\" render a.glib -o -' typed");
    const std::string typed = readFile(folder / "typed");
    EXPECT_NE(typed.find("a picture cannot be shown on a terminal"), std::string::npos) << typed;
    EXPECT_EQ(typed.find("PNG\r"), std::string::npos);
}

TEST(SceneArguments, AFolderStandsForTheScenesInIt) {
    const Folder folder;
    folder.write("all/a.glib", "Sphere\n");
    folder.write("all/deep/b.GLIB", "Cube\n");
    folder.write("all/notes.txt", "no scene\n");
    EXPECT_EQ(glibra(folder.path(), "check all").status, 0);
    const Finished run = glibra(folder.path(), "render all -o out --size 8x8");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(fs::exists(folder / "out/a.png"));
    EXPECT_TRUE(fs::exists(folder / "out/b.png"));
    EXPECT_NE(run.err.find("2 of 2 scenes rendered"), std::string::npos) << run.err;

    folder.write("one/a.glib", "Sphere\n");
    EXPECT_EQ(glibra(folder.path(), "render one -o two --size 8x8").status, 0);
    EXPECT_TRUE(fs::exists(folder / "two/a.png"));

    fs::create_directory(folder / "empty");
    const Finished none = glibra(folder.path(), "check empty");
    EXPECT_EQ(none.status, 3);
    EXPECT_NE(none.err.find("there is no scene (.glib) in this folder"), std::string::npos) << none.err;
}

TEST(SceneArguments, PicturesWhoseNamesDifferInCaseAloneKeepTheirFolders) {
    const Folder folder;
    folder.write("x/scene.glib", "Sphere\n");
    folder.write("y/Scene.GLIB", "Cube\n");
    EXPECT_EQ(glibra(folder.path(), "render x/scene.glib y/Scene.GLIB -o out --size 8x8").status, 0);
    EXPECT_TRUE(fs::exists(folder / "out/x/scene.png"));
    EXPECT_TRUE(fs::exists(folder / "out/y/Scene.png"));
}

TEST(SceneArguments, ScenesOfOneNameThatFailLeaveNoEmptyFolders) {
    const Folder folder;
    for (const char* each : {"a", "b", "c"})
        folder.write(std::string(each) + "/scene.glib", *each == 'b' ? "Sphere\n" : "Spere\n");
    const Finished run = glibra(folder.path(), "render a b c -o out --size 8x8");
    EXPECT_EQ(run.status, 3);
    EXPECT_TRUE(fs::exists(folder / "out/b/scene.png")) << run.err;
    EXPECT_FALSE(fs::exists(folder / "out/a"));
    EXPECT_FALSE(fs::exists(folder / "out/c"));
    EXPECT_EQ(glibra(folder.path(), "render a c -o none --size 8x8").status, 3);
    EXPECT_FALSE(fs::exists(folder / "none"));
    fs::create_directories(folder / "kept/a");  // what was there before stays
    EXPECT_EQ(glibra(folder.path(), "render a c -o kept --size 8x8").status, 3);
    EXPECT_TRUE(fs::exists(folder / "kept/a"));
    EXPECT_FALSE(fs::exists(folder / "kept/c"));
}

}  // namespace
}  // namespace glibra::test
