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

}  // namespace
}  // namespace glibra::test
