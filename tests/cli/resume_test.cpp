// `glibra test --resume` takes over a verdict only if nothing that it depends on has changed.

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "program.h"

namespace glibra::test {
namespace {

class Resume : public testing::Test {
  protected:
    void SetUp() override {
        folder.write("a.vert",
                     "#version 330 core\nout vec2 vST;\nvoid main() { vST = aTexCoord0.st; gl_Position = "
                     "uModelViewProjectionMatrix * aVertex; }\n");
        folder.write("a.frag",
                     "#version 330 core\n#include \"light.txt\"\nin vec2 vST;\nuniform sampler2D "
                     "uImage;\nuniform float uKd;\nout vec4 f;\nvoid main() { f = uKd*light()*texture("
                     "uImage, vST); }\n");
        folder.write("light.txt", "float light() { return 1.; }\n");
        folder.write("plain.glib", "WindowSize 16 16\nOrtho -1 1 -1 1\nSphere .5\n");
        ASSERT_EQ(glibra(folder.path(), "render plain.glib -o wood.png").status, 0);
        folder.write("b.glib",
                     "WindowSize 16 16\nOrtho -1 1 -1 1\nTexture2D 5 wood.png\nVertex a.vert\n"
                     "Fragment a.frag\nProgram P uImage 5 uKd 1\nQuadXY 0 1\n");
        suite("uKd = 1");
        ASSERT_EQ(run("--update --force").status, 0);
        ASSERT_TRUE(contains(run("").out, "3 passed"));
    }
    void suite(const std::string& set, const std::string& more = {}) {
        folder.write("s.toml",
                     "goldens = \"golden\"\n[[shot]]\nscript = \"plain.glib\"\n[[shot]]\nscript = "
                     "\"b.glib\"\nset = { " +
                         set + " }\n" + more +
                         "[[shot]]\nname = \"same\"\nscript = \"b.glib\"\nmatch = \"b\"\n");
    }
    Finished run(const std::string& arguments) { return glibra(folder.path(), "test s.toml " + arguments); }

    Folder folder;
};

TEST_F(Resume, NothingIsDrawnAgainWhileNothingHasChanged) {
    const Finished rest = run("--resume");
    EXPECT_EQ(rest.status, 0) << rest.err;
    EXPECT_FALSE(contains(rest.err, "drawn again")) << rest.err;
    EXPECT_TRUE(contains(rest.out, "3 passed")) << rest.out;
}

/// The shot "same" depends on the shot "b", which it is compared with, and plain.glib on none of the files.
TEST_F(Resume, WhatAChangedFileMattersToIsDrawnAgain) {
    const struct {
        const char* what;
        std::function<void()> change;
        const char* count;
    } changes[] = {
        {"an included file", [&] { folder.write("light.txt", "float light() { return .5; }\n"); }, "2 shots"},
        {"a shader", [&] { folder.write("a.frag", readFile(folder / "a.frag") + "// a comment\n"); },
         "2 shots"},
        {"a texture", [&] { folder.write("wood.png", readFile(folder / "golden/b.png") + " "); }, "2 shots"},
        {"a scene", [&] { folder.write("plain.glib", "WindowSize 16 16\nOrtho -1 1 -1 1\nSphere .9\n"); },
         "1 shot of the earlier run is"},
        {"a golden", [&] { folder.write("golden/b.png", readFile(folder / "golden/b.png") + " "); },
         "1 shot"},
        {"a setting", [&] { suite("uKd = 0.5"); }, "2 shots"},
        {"a tolerance", [&] { suite("uKd = 0.5", "tolerance = { max = 9 }\n"); }, "2 shots"},
        {"an option of the command", [] {}, "3 shots"},
    };
    for (const auto& each : changes) {
        each.change();
        const bool isOption = std::string_view(each.what) == "an option of the command";
        const Finished rest = run(isOption ? "--resume --no-skip" : "--resume");
        EXPECT_TRUE(contains(rest.err, std::string(each.count))) << each.what << rest.err;
        EXPECT_TRUE(contains(rest.err, "drawn again: what the picture depends on has changed")) << each.what;
        const Finished again = run(isOption ? "--resume --no-skip" : "--resume");
        EXPECT_FALSE(contains(again.err, "drawn again")) << each.what << again.err;
        EXPECT_EQ(again.status, rest.status) << each.what;
    }
}

TEST_F(Resume, AChangeIsSeenInTheVerdict) {
    folder.write("light.txt", "float light() { return .5; }\n");
    EXPECT_EQ(run("--resume").status, 1);
    folder.write("light.txt", "float light() { return 1.; }\n");
    EXPECT_EQ(run("--resume").status, 0);
}

/// Results of an earlier glibra have no fingerprints.
TEST_F(Resume, ResultsWithoutFingerprintsAreDrawnAgain) {
    std::string results = readFile(folder / "glibra-results/results.jsonl");
    for (std::size_t at = 0; (at = results.find("\"fingerprint\"")) != std::string::npos;)
        results.replace(at, 13, "\"former\"");
    folder.write("glibra-results/results.jsonl", results);
    EXPECT_TRUE(contains(run("--resume").err, "3 shots of the earlier run are drawn again"));
}

/// Files that only another time, size or variable reads belong to the shots that have it.
class ResumeMoments : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* each : {"late", "wide", "picked", "stepped", "asked", "plain", "included"})
            folder.write(std::string(each) + ".obj", kModel);
        folder.write("more.glib", "When (time > 4)\n  Obj included.obj\nEndWhen\n");
        folder.write("m.glib",
                     "WindowSize 16 16\nOrtho -2 2 -2 2\nLet choice <0 0 1>\n"
                     "When (time > 1 && time < 2)\n  Obj late.obj\nEndWhen\n"
                     "When (window.x > 20)\n  Obj wide.obj\nEndWhen\n"
                     "When (choice > 0.5)\n  Obj picked.obj\nEndWhen\n"
                     "When (time > 6)\n  Obj asked.obj\nEndWhen\n"
                     "Include more.glib\nObj plain.obj\nExpect finite window at 7\n");
        folder.write("n.glib",
                     "WindowSize 16 16\nOrtho -2 2 -2 2\nTexture2D kept 4 4 rgba8\n"
                     "Step 10\n  Pass kept\n    When (tick == 13)\n      Obj stepped.obj\n    EndWhen\n"
                     "  EndPass\nEndStep\nObj plain.obj\n");
        folder.write("m.toml",
                     "goldens = \"golden\"\n[[shot]]\nscript = \"m.glib\"\nname = \"now\"\n"
                     "[[shot]]\nscript = \"m.glib\"\nname = \"later\"\ntime = 1.45\n"
                     "[[shot]]\nscript = \"m.glib\"\nname = \"wider\"\nsize = [32, 16]\n"
                     "[[shot]]\nscript = \"m.glib\"\nname = \"chosen\"\nset = { choice = 1 }\n"
                     "[[shot]]\nscript = \"m.glib\"\nname = \"last\"\ntime = 5\n"
                     "[[shot]]\nscript = \"n.glib\"\ntime = [1, 1.45]\n");
    }
    Finished run(const std::string& arguments, const std::string& environment = {}) {
        return glibra(folder.path(), "test m.toml " + arguments, environment);
    }

    static constexpr const char* kModel = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    Folder folder;
};

TEST_F(ResumeMoments, AFileIsAnInputOfTheShotsThatReadIt) {
    const Finished made = run("--update --force");
    ASSERT_EQ(made.status, 0) << made.out << made.err;
    const Finished first = run("");
    ASSERT_EQ(first.status, 0) << first.out << first.err;
    EXPECT_FALSE(contains(run("--resume").err, "drawn again"));
    const struct {
        const char* file;
        const char* count;
    } changes[] = {
        {"late", "1 shot of"},    {"wide", "1 shot of"}, {"picked", "1 shot of"},
        {"stepped", "1 shot of"}, {"asked", "5 shots"},  // 'Expect ... at 7' reads it for all of them
        {"included", "5 shots"},  {"plain", "7 shots"}};
    for (const auto& each : changes) {
        folder.write(std::string(each.file) + ".obj", std::string(kModel) + "# changed\n");
        const Finished rest = run("--resume");
        EXPECT_TRUE(contains(rest.err, each.count)) << each.file << rest.err;
        EXPECT_FALSE(contains(run("--resume").err, "drawn again")) << each.file;
    }
}

TEST_F(ResumeMoments, AnotherDriverDrawsEverythingAgain) {
    ASSERT_EQ(run("--update --force").status, 0);
    ASSERT_EQ(run("").status, 0);
    // The key of a software driver has the switches that change its code.
    const Finished other = run("--resume", "LP_NATIVE_VECTOR_WIDTH=128");
    EXPECT_TRUE(contains(other.err, "7 shots of the earlier run are drawn again")) << other.err;
    EXPECT_FALSE(contains(run("--resume", "LP_NATIVE_VECTOR_WIDTH=128").err, "drawn again"));
    EXPECT_TRUE(contains(run("--resume").err, "7 shots of the earlier run are drawn again"));
}

TEST_F(ResumeMoments, AnUpdateWhoseGoldenIsGoneIsRepeated) {
    ASSERT_EQ(run("--update --force").status, 0);
    ASSERT_EQ(shell(folder.path(), "rm golden/now.png").status, 0);
    EXPECT_EQ(run("--update --force --resume").status, 0);
    EXPECT_FALSE(readFile(folder / "golden/now.png").empty());
}

TEST_F(ResumeMoments, ALineOfTheListAndALimitAreSettings) {
    ASSERT_EQ(run("--update --force").status, 0);
    ASSERT_EQ(run("").status, 0);
    folder.write("golden/m.hashes", "");
    EXPECT_TRUE(contains(run("--resume").err, "7 shots"));
    EXPECT_TRUE(contains(run("--resume --timeout 100").err, "7 shots"));
}

}  // namespace
}  // namespace glibra::test
