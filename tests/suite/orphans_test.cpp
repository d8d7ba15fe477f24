#include "suite/golden/orphans.h"

#include <gtest/gtest.h>

#include "folder.h"
#include "pictures.h"
#include "suite/golden/hash_list.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

class GoldensOfNoShot : public testing::Test {
  protected:
    GoldensOfNoShot() {
        suite.name = "s";
        suite.goldens = folder / "golden";
        for (const char* each : {"a", "deep/b", "c@t=0.5"}) suite.shots.push_back(shotNamed(each));
        for (const char* each : {"a.png", "a.llvmpipe.png", "deep/b.exr", "c@t=0.5.png", "s.hashes"})
            put(each);
    }
    void put(const std::string& name) const { writeText(folder / "golden" / name, ""); }
    std::string found() const {
        std::string names;
        for (const fs::path& each : orphanGoldens(suite))
            names += each.lexically_relative(folder / "golden").string() + " ";
        return names;
    }

    Folder folder;
    Suite suite;
};

TEST_F(GoldensOfNoShot, GoldensOfShotsAndTheirVariantsAreNone) {
    EXPECT_EQ(found(), "");
}

TEST_F(GoldensOfNoShot, PicturesOfNoShotAreListedSorted) {
    for (const char* each : {"z.png", "deep/a.png", "c@t=1.png", "b.exr", ".hidden.png", "README.md"})
        put(each);
    EXPECT_EQ(found(), "b.exr c@t=1.png deep/a.png z.png ");
}

TEST_F(GoldensOfNoShot, AFolderOfTwoSuitesIsLeftAlone) {
    put("z.png");
    put("other.hashes");
    EXPECT_EQ(found(), "");
}

TEST_F(GoldensOfNoShot, AmongOtherFilesOnlyListedPicturesCount) {
    put("texture.png");
    put("z.png");
    put("scene.glib");
    EXPECT_EQ(found(), "") << "they may be textures";
    HashList list;
    list.accept(std::vector<AcceptedHash>{{"z", "", {}, {}, "driver"}});
    writeText(folder / "golden/s.hashes", list.toText());
    EXPECT_EQ(found(), "z.png ");
}

TEST_F(GoldensOfNoShot, GoldensOfAnotherSuiteInTheFolderAreNone) {
    put("z.png");
    put("other/y.llvmpipe.png");
    put("x.png");
    Suite other;
    other.name = "other";
    other.goldens = folder / "golden";
    other.shots = {shotNamed("z"), shotNamed("other/y")};
    EXPECT_EQ(orphanGoldens(suite, {}, {&other, 1}), std::vector<fs::path>{folder / "golden/x.png"});
    Suite below = other;
    below.goldens = folder / "golden/other";
    below.shots = {shotNamed("y")};
    EXPECT_EQ(orphanGoldens(suite, {}, {&below, 1}),
              (std::vector<fs::path>{folder / "golden/x.png", folder / "golden/z.png"}));
}

/// Only the suite itself is on the command line.
TEST_F(GoldensOfNoShot, SuitesBesideTheSuiteCount) {
    put("z.png");
    put("x.png");
    writeText(folder / "a.glib", "Sphere 1\n");
    suite.file = folder / "s.toml";
    writeText(suite.file, "");
    writeText(folder / "other.toml", "goldens = \"golden\"\n[[shot]]\nname = \"z\"\nscript = \"a.glib\"\n");
    EXPECT_EQ(found(), "x.png ");
    writeText(folder / "unknown.toml", "[tool]\nname = 1\n");
    EXPECT_EQ(found(), "") << "what that file says of goldens is unknown";
    HashList list;
    list.accept(std::vector<AcceptedHash>{{"x", "", {}, {}, "driver"}, {"z", "", {}, {}, "driver"}});
    writeText(folder / "golden/s.hashes", list.toText());
    EXPECT_EQ(found(), "x.png ");
}

TEST_F(GoldensOfNoShot, LinksAreNotFollowed) {
    fs::create_directories(folder / "elsewhere");
    writeText(folder / "elsewhere/mine.png", "mine");
    fs::create_directory_symlink(folder / "elsewhere", folder / "golden/link");
    fs::create_symlink(folder / "elsewhere/mine.png", folder / "golden/z.png");
    EXPECT_EQ(found(), "");
}

TEST_F(GoldensOfNoShot, AValueOfASweepIsNoVariant) {
    suite.shots.push_back(shotNamed("c@t=0"));
    put("c@t=0.1.png");
    put("c@t=0.llvmpipe.png");
    put("a.also1.png");
    EXPECT_EQ(found(), "c@t=0.1.png ");
}

TEST_F(GoldensOfNoShot, RemovingThemLeavesTheOthers) {
    put("z.png");
    put("gone/x.png");
    EXPECT_TRUE(removeOrphans(orphanGoldens(suite)).empty());
    EXPECT_EQ(found(), "");
    EXPECT_FALSE(fs::exists(folder / "golden/gone"));
    EXPECT_TRUE(fs::exists(folder / "golden/a.llvmpipe.png"));
    EXPECT_TRUE(fs::exists(folder / "golden/deep/b.exr"));
}

}  // namespace
}  // namespace glibra::suite
