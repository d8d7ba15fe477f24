// A graphics device that is reset in the middle of a command: a lost picture is never written, compared,
// accepted or believed, and scenes that are innocent are drawn all the same.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "program.h"

#ifdef GLIBRA_LOSE_DEVICE

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

/// Scenes of 40 x 40 pixels. The program of `hangs.glib` has the function that makes the device hang.
class LostDeviceCommand : public testing::TestWithParam<const char*> {
  protected:
    static constexpr const char* kHangs = "gpu-E06";

    void SetUp() override {
        folder.write("a.vert",
                     "#version 330 core\nvoid main() { gl_Position = vec4(aVertex.xy, 0., 1.); }\n");
        folder.write("a.frag",
                     "#version 330 core\nuniform float uBlue;\nout vec4 f;\n"
                     "void main() { f = vec4(gl_FragCoord.xy / 40., uBlue, 1.); }\n");
        folder.write("hangs.frag",
                     "#version 330 core\nout vec4 f;\n"
                     "float hang(float x) { while (x > 0.) x += 1.; return x; }\n"
                     "void main() { f = vec4(hang(gl_FragCoord.x)); }\n");
        for (const char* name : {"a", "b", "c", "d"})
            folder.write(std::string(name) + ".glib",
                         sceneOf(std::string("uBlue .") + std::to_string(name[0] - 'a')));
        folder.write("hangs.glib", sceneOf("uBlue .9") + kSecond);
    }
    static std::string sceneOf(const std::string& values) {
        return "WindowSize 40 40\nLookAt 0 0 5  0 0 0  0 1 0\nVertex a.vert\nFragment a.frag\nProgram P " +
               values + "\nQuadXY 0 1 1 1\n";
    }
    static constexpr const char* kSecond = "Fragment hangs.frag\nProgram H\nQuadXY .5 .5 1 1\n";

    Finished run(const std::string& arguments) { return runAs(arguments, GetParam()); }
    Finished runAs(const std::string& arguments, const std::string& resetAs, const std::string& more = {}) {
        fs::remove(folder / "device");
        return glibra(folder.path(), arguments,
                      preload(GLIBRA_LOSE_DEVICE) + " GLIBRA_DEVICE='" + (folder / "device").string() +
                          "' GLIBRA_RESET_AS=" + resetAs + " " + more);
    }
    [[nodiscard]] bool exists(std::string_view name) const { return fs::exists(folder / name); }
    void expectPlain(const std::string& arguments, std::string_view file) {
        const std::string got = readFile(folder / file);
        fs::remove(folder / file);
        ASSERT_EQ(glibra(folder.path(), arguments).status, 0);
        EXPECT_TRUE(got == readFile(folder / file)) << file << " is not the picture of a device that works";
    }

    Folder folder;
};

INSTANTIATE_TEST_SUITE_P(Driver, LostDeviceCommand, testing::Values("known", "unknown", "error"),
                         [](const auto& each) { return std::string(each.param); });

TEST_P(LostDeviceCommand, RenderWritesNoPictureOfALostDevice) {
    const Finished end = run("render hangs.glib");
    EXPECT_EQ(end.status, 3) << end.err;
    EXPECT_FALSE(exists("hangs.png"));
    EXPECT_TRUE(contains(end.err, "hangs.glib:") && contains(end.err, kHangs)) << end.err;
    EXPECT_TRUE(contains(end.err, "while lines 6 to 9 were drawn")) << end.err;
}

TEST_P(LostDeviceCommand, ASceneThatDrawsOnceIsNamedByItsDraw) {
    folder.write("one.glib", std::string("WindowSize 40 40\nVertex a.vert\n") + kSecond);
    const Finished end = run("render one.glib");
    EXPECT_TRUE(
        contains(end.err, "one.glib:5:1: error: the graphics driver reset the device while line 5 was drawn"))
        << end.err;
}

TEST_P(LostDeviceCommand, InnocentScenesOfTheSameProcessAreDrawn) {
    for (const std::string jobs : {"1", "2", "4"}) {
        for (const char* each : {"a", "b", "c", "d"}) fs::remove(folder / (std::string(each) + ".png"));
        const Finished end = run("render a.glib b.glib hangs.glib c.glib d.glib --jobs " + jobs);
        EXPECT_EQ(end.status, 3) << end.err;
        EXPECT_TRUE(contains(end.err, "4 of 5 scenes rendered, failed: hangs.glib")) << end.err;
        EXPECT_FALSE(exists("hangs.png"));
        for (const std::string each : {"a", "b", "c", "d"})
            expectPlain("render " + each + ".glib", each + ".png");
    }
}

TEST_P(LostDeviceCommand, NothingElseThatRenderWritesIsOfALostDevice) {
    folder.write(
        "m.glib",
        "WindowSize 40 40\nTexture2D shown 40 40 rgba8\nFragment hangs.frag\nProgram H\nFill shown with H\n"
        "Fragment inline\n#version 330 core\nuniform sampler2D uShown;\nin vec2 vST;\nout vec4 f;\n"
        "void main() { f = texture(uShown, vST); }\nEndFragment\nProgram S uShown shown\nFill window with "
        "S\n");
    for (const char* arguments :
         {"render hangs.glib -o -", "render hangs.glib -o out.exr", "render hangs.glib -o out/",
          "render hangs.glib --frames 3 -o frame.png", "render hangs.glib --frames 20 --jobs 2 -o frame.png",
          "render hangs.glib --check-nan -o out.png", "render hangs.glib --max-error .5 -o out.png",
          "render hangs.glib --tile 16 -o out.png", "render hangs.glib --stats stats.json -o out.png",
          "render hangs.glib --incomplete -o out.png", "render m.glib -o out.png --save shown=saved.png"}) {
        const Finished end = run(arguments);
        EXPECT_EQ(end.status, 3) << arguments << end.err;
        EXPECT_TRUE(contains(end.err, kHangs)) << arguments << end.err;
        EXPECT_EQ(end.out, "") << arguments;
        const std::string listing = folder.listing();
        for (const char* kind : {".png", ".exr", ".gif", ".tmp"})
            EXPECT_FALSE(contains(listing, kind)) << arguments << "\n" << listing;
    }
}

TEST_P(LostDeviceCommand, AnInnocentAnimationOnStandardOutputHasEachFrameOnce) {
    folder.write("moves.glib",
                 "WindowSize 40 40\nVertex a.vert\nFragment moves.frag\nProgram P\nQuadXY 0 1 1 1\n");
    folder.write(
        "moves.frag",
        "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(gl_FragCoord.xy / 40., Timer, 1.); }\n");
    const Finished plain = glibra(folder.path(), "render moves.glib --frames 6 -o -");
    ASSERT_EQ(plain.status, 0) << plain.err;
    if (std::string(GetParam()) != "known") return;  // nobody else is there to be blamed
    const Finished end = runAs("render moves.glib --frames 6 -o -", "other", "GLIBRA_HANGS_IN_DRAW=4");
    EXPECT_EQ(end.status, 0) << end.err;
    EXPECT_TRUE(end.out == plain.out);
}

TEST_P(LostDeviceCommand, CheckDoesNotBelieveAnExpectOfALostDevice) {
    folder.write("e.glib",
                 "WindowSize 40 40\nVertex a.vert\nFragment hangs.frag\nProgram H\nQuadXY 0 1 1 1\n"
                 "Expect pixel 20 20 [0 0 0]\n");
    folder.write("black.glib",
                 "WindowSize 40 40\nLookAt 0 0 5  0 0 0  0 1 0\nVertex a.vert\nFragment inline\n#version 330 "
                 "core\nout vec4 f;\nvoid main() { f = vec4(0., 0., 0., 1.); }\nEndFragment\nProgram "
                 "B\nQuadXY 0 1 1 1\n"
                 "Expect pixel 20 20 [0 0 0]\n");
    EXPECT_EQ(run("check e.glib").status, 0) << "nothing is drawn";
    const Finished end = run("check --run black.glib e.glib black.glib a.glib --jobs 1");
    EXPECT_EQ(end.status, 3) << end.err;
    EXPECT_TRUE(contains(end.err, "e.glib:5:1: error: the graphics driver reset the device")) << end.err;
    EXPECT_FALSE(contains(end.err, "black.glib:")) << end.err;
    EXPECT_FALSE(contains(end.err, "check-E01")) << end.err;
}

TEST_P(LostDeviceCommand, TestNeitherPassesNorAcceptsAPictureOfALostDevice) {
    folder.write("s.toml",
                 "goldens = \"golden\"\n[[shot]]\nscript = \"a.glib\"\n[[shot]]\nscript = \"hangs.glib\"\n"
                 "[[shot]]\nscript = \"b.glib\"\n[[shot]]\nscript = \"c.glib\"\n");
    for (const std::string jobs : {"1", "3"}) {
        fs::remove_all(folder / "golden");
        const Finished update = run("test s.toml --update --jobs " + jobs);
        EXPECT_EQ(update.status, 3) << update.out << update.err;
        EXPECT_TRUE(contains(update.out + update.err, kHangs)) << update.out << update.err;
        EXPECT_FALSE(exists("golden/hangs.png"));
        for (const char* each : {"a", "b", "c"})
            EXPECT_TRUE(exists(std::string("golden/") + each + ".png")) << each;
        for (const auto& each : fs::directory_iterator(folder / "golden"))
            EXPECT_FALSE(each.path().extension() == ".hashes" && contains(readFile(each.path()), "hangs"));
        const Finished again = run("test s.toml --jobs " + jobs);
        EXPECT_EQ(again.status, 3) << again.out << again.err;
        EXPECT_TRUE(contains(again.out, "1 crashed, 3 passed")) << again.out << again.err;
        const Finished resumed = glibra(folder.path(), "test s.toml --resume --only a --only b --only c");
        EXPECT_EQ(resumed.status, 0) << resumed.out << resumed.err;
    }
}

TEST_P(LostDeviceCommand, AGoldenThatIsBlackDoesNotMatchAPictureOfALostDevice) {
    folder.write("black.frag", "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(0., 0., 0., 1.); }\n");
    folder.write("h.glib", "WindowSize 40 40\nVertex a.vert\nFragment h.frag\nProgram B\nQuadXY 0 1 1 1\n");
    folder.write("h.frag", readFile(folder / "black.frag"));
    folder.write("s.toml", "goldens = \"golden\"\n[[shot]]\nscript = \"h.glib\"\n");
    ASSERT_EQ(glibra(folder.path(), "test s.toml --update --force").status, 0);
    folder.write("h.frag", readFile(folder / "hangs.frag"));
    const Finished end = run("test s.toml");
    EXPECT_EQ(end.status, 3) << end.out << end.err;
    EXPECT_TRUE(contains(end.out, "1 crashed")) << end.out << end.err;
}

TEST_P(LostDeviceCommand, AClassHasNoPictureOfALostDevice) {
    folder.write("reference.glib", readFile(folder / "a.glib"));
    for (const std::string who : {"ann", "bob", "cid"}) {
        const std::string to = "class/" + who + "/";
        for (const char* file : {"a.vert", "a.frag", "hangs.frag"})
            folder.write(to + file, readFile(folder / file));
        folder.write(to + who + ".glib", readFile(folder / (who == "bob" ? "hangs.glib" : "a.glib")));
    }
    const Finished end = run("class class --reference reference.glib -o site --jobs 2");
    const std::string table = readFile(folder / "site/grades.csv");
    EXPECT_TRUE(contains(table, "bob") && contains(table, "crashed")) << table << end.out << end.err;
    EXPECT_EQ(table.find("crashed"), table.rfind("crashed")) << table;
    EXPECT_FALSE(contains(table, "failed") || contains(table, "timed-out")) << table;
    int pictures = 0;
    for (const auto& each : fs::directory_iterator(folder / "site/pictures"))
        pictures += each.path().extension() == ".png" ? 1 : 0;
    EXPECT_EQ(pictures, 3) << "of the reference, ann and cid: " << folder.listing();
}

#ifdef GLIBRA_BENCH_TESTED
TEST_P(LostDeviceCommand, BenchReportsNothingOfALostDevice) {
    const Finished end = runAs("bench --quick lighting -o out", GetParam(), "GLIBRA_HANGS_IN_DRAW=3");
    EXPECT_EQ(end.status, 3) << end.out << end.err;
    EXPECT_TRUE(contains(end.err, kHangs)) << end.err;
    const std::string json = readFile(folder / "out/bench.json");
    EXPECT_TRUE(contains(json, "\"figures\": []")) << json;
    EXPECT_TRUE(contains(json, kHangs)) << "the page says why there is nothing: " << json;
}
#endif

}  // namespace
}  // namespace glibra::test

#endif
