#include "suite/golden/golden_store.h"

#include <gtest/gtest.h>

#include "folder.h"
#include "image/compare/compare.h"
#include "pictures.h"

namespace glibra::suite {
namespace {

class Goldens : public testing::Test {
  protected:
    Goldens() {
        suite.name = "s";
        suite.goldens = folder / "goldens";
    }
    GoldenStore store() const { return *GoldenStore::open(suite); }
    /// Writes a golden under its file name, as a person would.
    void put(const std::string& name, const image::Image& image) const {
        ASSERT_TRUE(store().replace(shotNamed(name), "", image));
    }

    Folder folder;
    Suite suite;
};

TEST_F(Goldens, TheNearestVariantIsTaken) {
    const Shot shot = shotNamed("a");
    EXPECT_FALSE(store().find(shot, "llvmpipe"));
    put("a", gradient());
    EXPECT_EQ(store().find(shot, "llvmpipe")->variant, "");
    put("a.nvidia", gradient(1));
    EXPECT_EQ(store().find(shot, "llvmpipe")->variant, "");
    EXPECT_EQ(store().find(shot, "nvidia")->variant, "nvidia");
    put("a.llvmpipe", gradient(2));
    EXPECT_EQ(store().find(shot, "llvmpipe")->variant, "llvmpipe");
    EXPECT_EQ(store().find(shot, "osmesa-llvmpipe")->variant, "llvmpipe");
    EXPECT_EQ(store().find(shot, "softpipe")->variant, "");
    EXPECT_EQ(store().find(shot, "llvmpipe")->file, folder / "goldens/a.llvmpipe.png");
}

TEST_F(Goldens, AGoldenThatIsALinkIsNotWrittenThrough) {
    put("a", gradient());
    writeText(folder / "mine.png", "mine");
    std::filesystem::create_symlink(folder / "mine.png", folder / "goldens/b.png");
    const Result<Golden> refused = store().replace(shotNamed("b"), "", gradient(1));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.diagnostics.front().id, "file-E10");
    EXPECT_NE(refused.diagnostics.front().text.find("goldens/b.png': it is a symbolic link"),
              std::string::npos)
        << refused.diagnostics.front().text;
    EXPECT_EQ(textOf(folder / "mine.png"), "mine");
    std::filesystem::create_directories(folder / "elsewhere");
    std::filesystem::create_directory_symlink(folder / "elsewhere", folder / "goldens/deep");
    EXPECT_FALSE(store().replace(shotNamed("deep/c"), "", gradient()));
    EXPECT_TRUE(std::filesystem::is_empty(folder / "elsewhere"));
    EXPECT_TRUE(GoldenStore::open(suite, {}, true)->replace(shotNamed("deep/c"), "", gradient()));
    const AcceptedHash line{"a", "", {}, {}, "llvmpipe"};
    std::filesystem::create_symlink(folder / "mine.png", folder / "goldens/s.hashes");
    EXPECT_TRUE(hasError(acceptHashes(folder / "goldens/s.hashes", std::span(&line, 1))));
    EXPECT_EQ(textOf(folder / "mine.png"), "mine");
}

TEST_F(Goldens, ALinkIsFollowedOnlyWithinTheGoldenFolderAndThatOfTheSuite) {
    put("a", gradient());
    suite.file = folder / "suite/s.toml";
    std::filesystem::create_directories(folder / "suite");
    std::filesystem::copy(folder / "goldens/a.png", folder / "suite/own.png");
    std::filesystem::copy(folder / "goldens/a.png", folder / "secret.png");
    std::filesystem::create_symlink("a.png", folder / "goldens/b.png");
    std::filesystem::create_symlink(folder / "suite/own.png", folder / "goldens/c.png");
    std::filesystem::create_symlink(folder / "secret.png", folder / "goldens/d.png");
    EXPECT_TRUE(store().find(shotNamed("b"), ""));
    EXPECT_TRUE(store().find(shotNamed("c"), ""));
    const Result<Golden> outside = store().find(shotNamed("d"), "");
    ASSERT_FALSE(outside);
    ASSERT_EQ(outside.diagnostics.size(), 1U);
    EXPECT_EQ(outside.diagnostics[0].id, "file-E14");
    EXPECT_TRUE(GoldenStore::open(suite, {}, true)->find(shotNamed("d"), ""));
    // As git-annex leaves what it has not fetched.
    std::filesystem::create_symlink("../gone/e.png", folder / "goldens/e.png");
    const Result<Golden> gone = store().find(shotNamed("e"), "");
    ASSERT_EQ(gone.diagnostics.size(), 1U);
    EXPECT_EQ(gone.diagnostics[0].id, "file-E01");
    EXPECT_NE(gone.diagnostics[0].text.find("git annex get"), std::string::npos) << gone.diagnostics[0].text;
}

TEST_F(Goldens, UpdateStaysBelowTheFolderOfTheSuite) {
    suite.file = folder / "tests/s.toml";
    std::filesystem::create_directories(folder / "tests");
    for (const auto& [goldens, good] : {std::pair<const char*, bool>{"tests/golden", true},
                                        {"tests/a/../golden", true},
                                        {"goldens", false},
                                        {"tests/../goldens", false},
                                        {"tests2", false}}) {
        suite.goldens = folder / goldens;
        EXPECT_EQ(checkGoldenFolder(suite).empty(), good) << goldens;
    }
    std::filesystem::create_directory_symlink(folder / "goldens", folder / "tests/link");
    std::filesystem::create_directories(folder / "goldens");
    suite.goldens = folder / "tests/link";
    ASSERT_EQ(checkGoldenFolder(suite).size(), 1U);
    EXPECT_EQ(checkGoldenFolder(suite)[0].id, "suite-E20");
}

TEST_F(Goldens, WhatWasWrittenComesBack) {
    put("deep/er/a", gradient());
    const Result<Golden> golden = store().find(shotNamed("deep/er/a"), "llvmpipe");
    ASSERT_TRUE(golden);
    const Result<image::Image> back = decode(*golden);
    ASSERT_TRUE(back);
    EXPECT_TRUE(image::compare(*back, gradient()).identical);
}

TEST_F(Goldens, FloatShotsAreExr) {
    Shot shot = shotNamed("a");
    shot.options.floatPixels = true;
    EXPECT_EQ(store().file(shot, "nvidia"), folder / "goldens/a.nvidia.exr");
}

TEST_F(Goldens, AnotherFolderHoldsAFolderASuite) {
    const Result<GoldenStore> elsewhere = GoldenStore::open(suite, folder / "other");
    EXPECT_EQ(elsewhere->file(shotNamed("a"), ""), folder / "other/s/a.png");
}

TEST_F(Goldens, ATruncatedGoldenSaysWhatToDo) {
    put("a", gradient());
    const std::string whole = textOf(folder / "goldens/a.png");
    writeText(folder / "goldens/a.png", whole.substr(0, whole.size() / 2));
    const Result<Golden> golden = store().find(shotNamed("a"), "llvmpipe");
    ASSERT_TRUE(golden);
    const Result<image::Image> picture = decode(*golden);
    ASSERT_FALSE(picture);
    EXPECT_EQ(picture.diagnostics.front().id, "file-E04");
    EXPECT_NE(picture.diagnostics.front().text.find("--update --replace-unreadable"), std::string::npos);
}

TEST_F(Goldens, AcceptedPixelsHoldForOneGoldenAndOneTolerance) {
    Shot shot = shotNamed("a");
    put("a", gradient());
    const Golden golden = *store().find(shot, "llvmpipe");
    const std::vector<AcceptedHash> accepted{{"a", "", golden.identity, hashOf(gradient(1)), "key"}};
    ASSERT_TRUE(acceptHashes(store().hashFile(), accepted).empty());
    EXPECT_NE(store().acceptedPixels(shot, *store().find(shot, "llvmpipe"), "key"), nullptr);
    EXPECT_EQ(store().acceptedPixels(shot, *store().find(shot, "llvmpipe"), "other"), nullptr);

    shot.tolerance.largest = 0;
    EXPECT_EQ(store().acceptedPixels(shot, *store().find(shot, "llvmpipe"), "key"), nullptr);
    shot.tolerance = {};
    put("a", gradient(9));
    EXPECT_EQ(store().acceptedPixels(shot, *store().find(shot, "llvmpipe"), "key"), nullptr);
}

TEST_F(Goldens, AFolderThatCannotBeWrittenLeavesEverythingAsItWas) {
    writeText(folder / "goldens", "a file where the folder should be");
    const Result<Golden> golden = store().replace(shotNamed("a"), "", gradient());
    ASSERT_FALSE(golden);
    EXPECT_EQ(golden.diagnostics.front().id, "file-E10");
    EXPECT_EQ(textOf(folder / "goldens"), "a file where the folder should be");
}

}  // namespace
}  // namespace glibra::suite
