// Looking up the files that a scene names (language, 8.6).

#include "scene/file_lookup.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support.h"

namespace glibra::scene {
namespace {

namespace fs = std::filesystem;
using tests::idsOf;
using tests::TemporaryFolder;

FileReference find(std::string_view name, const fs::path& scene, const InterpretOptions& options = {}) {
    FolderListings listings;
    return findFile(name, {"a.glib", 3, 5}, searchFolders(scene, options), listings);
}

std::string remarkOf(const FileReference& file) {
    return file.remarks.empty() ? "" : file.remarks.front().id + " " + file.remarks.front().text;
}

class FileLookup : public testing::Test {
  protected:
    FileReference find(std::string_view name) const {
        return scene::find(name, folder.path() / "scene.glib");
    }

    TemporaryFolder folder;
};

TEST_F(FileLookup, AFileBesideTheSceneIsFoundSilently) {
    const fs::path path = folder.write("cow.obj");
    const FileReference file = find("cow.obj");
    EXPECT_EQ(file.path, path);
    EXPECT_EQ(file.name, "cow.obj");
    EXPECT_TRUE(file.remarks.empty());
}

TEST_F(FileLookup, PathsMayBeRelativeOrAbsolute) {
    const fs::path path = folder.write("sub/cow.obj");
    EXPECT_EQ(find("sub/cow.obj").path, path);
    EXPECT_EQ(find("./sub//cow.obj").path, path);
    EXPECT_EQ(fs::canonical(find("sub/../sub/cow.obj").path), fs::canonical(path));
    EXPECT_EQ(find(path.string()).path, path);
    EXPECT_TRUE(find(path.string()).remarks.empty());
}

TEST_F(FileLookup, AConfinedSceneFindsOnlyFilesOfItsFolderAndTheLibrary) {
    const fs::path own = folder.write("ana/src/a.frag");
    const fs::path beside = folder.write("ana/wood.png");
    folder.write("bob/b.frag");
    folder.write("secrets.txt");
    const fs::path library = folder.write("course/shaders/noise.glsl");
    fs::create_symlink(folder.path() / "secrets.txt", folder.path() / "ana/src/link.frag");
    fs::create_symlink(folder.path() / "bob", folder.path() / "ana/src/friend");
    const InterpretOptions options{{folder.path() / "course"}, folder.path() / "ana"};
    const auto confined = [&](std::string_view name) {
        return scene::find(name, folder.path() / "ana/src/scene.glib", options);
    };
    EXPECT_EQ(confined("a.frag").path, own);
    EXPECT_EQ(fs::canonical(confined("../wood.png").path), fs::canonical(beside));
    EXPECT_EQ(confined("noise.glsl").path, library);
    for (const char* each :
         {"../../bob/b.frag", "../../BOB/b.frag", "link.frag", "friend/b.frag", "/etc/passwd"}) {
        const FileReference file = confined(each);
        EXPECT_EQ(file.path, fs::path()) << each;
        ASSERT_EQ(idsOf(file.remarks), "file-E12") << each;
    }
    EXPECT_EQ(
        remarkOf(confined("link.frag")),
        "file-E12 'link.frag' lies outside of the scene's folder and the library, and this scene may read "
        "only files inside");
    // Names near to a missing one come from the folders that may be read.
    EXPECT_EQ(remarkOf(confined("../../secret.txt")), "file-E01 cannot find '../../secret.txt'");
    EXPECT_EQ(remarkOf(confined("friend/c.frag")), "file-E01 cannot find 'friend/c.frag'; nearest: 'a.frag'");
    EXPECT_EQ(remarkOf(confined("noize.glsl")), "file-E01 cannot find 'noize.glsl'; nearest: 'noise.glsl'");
}

TEST_F(FileLookup, BackslashesAreSlashesEvenIfDoubled) {
    const fs::path path = folder.write("sub/deep/cow.obj");
    EXPECT_EQ(find("sub\\deep\\cow.obj").path, path);
    EXPECT_EQ(find("sub\\\\deep\\\\cow.obj").path, path);
    EXPECT_TRUE(find("sub\\deep\\cow.obj").remarks.empty());
}

TEST_F(FileLookup, AnotherCaseIsFoundAndReported) {
    const fs::path path = folder.write("giraffe.obj");
    const FileReference file = find("Giraffe.OBJ");
    EXPECT_EQ(file.path, path);
    EXPECT_EQ(remarkOf(file), "file-W01 'Giraffe.OBJ' found as 'giraffe.obj'");
    EXPECT_EQ(file.remarks.at(0).place.line, 3);
    EXPECT_EQ(file.remarks.at(0).place.column, 5);
}

// What an editor has not saved, or a page that has no disk.
TEST_F(FileLookup, AFileThatIsFoundInAnotherCaseHasItsTextInMemory) {
    const fs::path path = folder.write("Lit.frag");
    const auto text = std::make_shared<const std::string>("changed");
    InterpretOptions options;
    options.inMemory = [&](const fs::path& asked) { return asked == path ? text : nullptr; };
    const FileReference file = scene::find("lit.frag", folder.path() / "scene.glib", options);
    EXPECT_EQ(file.path, path);
    EXPECT_EQ(file.content, text);
}

TEST_F(FileLookup, EveryPartMayDifferInCase) {
    const fs::path path = folder.write("Textures/Wood/a.bmp");
    const FileReference file = find("textures\\wood\\A.bmp");
    EXPECT_EQ(file.path, path);
    EXPECT_EQ(remarkOf(file), "file-W01 'textures\\wood\\A.bmp' found as 'Textures/Wood/a.bmp'");
}

TEST_F(FileLookup, TheExactCaseIsPreferredWithoutAMessage) {
    folder.write("COW.obj");
    const fs::path path = folder.write("cow.obj");
    EXPECT_EQ(find("cow.obj").path, path);
    EXPECT_TRUE(find("cow.obj").remarks.empty());
}

TEST_F(FileLookup, TheFirstOfSeveralCasesInByteOrderIsUsed) {
    folder.write("cow.obj");
    const fs::path path = folder.write("COW.obj");
    const FileReference file = find("Cow.obj");
    EXPECT_EQ(file.path, path);
    EXPECT_EQ(remarkOf(file), "file-W12 'Cow.obj' matches 'COW.obj' and 'cow.obj'; 'COW.obj' is used");
}

TEST_F(FileLookup, AFolderOfTheRightCaseWithoutTheFileIsNoDeadEnd) {
    folder.write("MODELS/horse.obj");
    const fs::path path = folder.write("Models/cow.obj");
    EXPECT_EQ(find("models/cow.obj").path, path);
    EXPECT_EQ(idsOf(find("models/cow.obj").remarks), "file-W01");
}

TEST_F(FileLookup, TheLastPartOfAForeignPathIsFoundBesideTheScene) {
    const fs::path path = folder.write("cow.obj");
    for (const char* name : {"C:\\models\\cow.obj", "C:/models/cow.obj", "C:cow.obj", "../models/cow.obj",
                             "/no/such/cow.obj", "\\\\server\\share\\cow.obj"}) {
        const FileReference file = find(name);
        EXPECT_EQ(file.path, path) << name;
        EXPECT_EQ(remarkOf(file), "file-W02 '" + std::string(name) + "' found as 'cow.obj' beside the scene");
    }
    EXPECT_EQ(idsOf(find("C:\\models\\COW.obj").remarks), "file-W02") << "case does not matter there either";
}

TEST_F(FileLookup, WithoutFoldersThereIsNoLastPart) {
    EXPECT_EQ(idsOf(find("cow.obj").remarks), "file-E01");
    EXPECT_EQ(find("cow.obj").remarks.front().subject, "cow.obj");
}

TEST_F(FileLookup, AMissingFileIsAnErrorWithTheNearestNames) {
    folder.write("cows.obj");
    folder.write("bow.obj");
    folder.write("dragon.obj");
    const FileReference file = find("cow.obj");
    EXPECT_TRUE(file.path.empty());
    EXPECT_EQ(remarkOf(file), "file-E01 cannot find 'cow.obj'; nearest: 'bow.obj', 'cows.obj'");
    EXPECT_EQ(remarkOf(find("elephant.ply")), "file-E01 cannot find 'elephant.ply'");
    EXPECT_EQ(file.remarks.at(0).severity, Severity::error);
}

TEST_F(FileLookup, AFileOfAnotherTopicIsNamedAsItCanBeWritten) {
    const fs::path scene = folder.path() / "mine" / "a.glib";
    const fs::path shader = folder.write("shaders/noise/Solid.vert");
    folder.write("shaders/noise/deep/solid.vert");
    folder.write("shaders/solit.vert");
    EXPECT_EQ(remarkOf(scene::find("solid.vert", scene)),
              "file-E01 cannot find 'solid.vert'; the library has it as 'noise/Solid.vert' and "
              "'noise/deep/solid.vert'");
    EXPECT_EQ(remarkOf(scene::find("shaders/old/solid.vert", scene)).substr(0, 62),
              "file-E01 cannot find 'shaders/old/solid.vert'; the library has");
    EXPECT_EQ(scene::find("noise/Solid.vert", scene).path, shader) << "the name works";
    EXPECT_EQ(remarkOf(scene::find("solid.frag", scene)), "file-E01 cannot find 'solid.frag'")
        << "nothing has that name";
    EXPECT_EQ(remarkOf(scene::find("sorit.vert", scene)),
              "file-E01 cannot find 'sorit.vert'; nearest: 'solit.vert'");
}

TEST_F(FileLookup, ALibraryOfManyFoldersIsNotSearchedToItsEnd) {
    fs::path deep = folder.path() / "shaders";
    for (int i = 0; i < 8; ++i) deep /= "f";
    folder.write(deep.lexically_relative(folder.path()) / "solid.vert");
    for (int i = 0; i < 300; ++i) folder.write("textures/" + std::to_string(i) + "/x");
    folder.write("textures/zzz/solid.vert");
    EXPECT_EQ(remarkOf(find("solid.vert")), "file-E01 cannot find 'solid.vert'");
}

TEST_F(FileLookup, NearNamesAreSearchedInTheFolderOfTheName) {
    folder.write("sub/cows.obj");
    EXPECT_EQ(remarkOf(find("sub/cow.obj")), "file-E01 cannot find 'sub/cow.obj'; nearest: 'cows.obj'");
    folder.write("sub2/cows.obj");
    EXPECT_EQ(
        remarkOf(find((folder.path() / "sub2/cow.obj").string())),
        "file-E01 cannot find '" + (folder.path() / "sub2/cow.obj").string() + "'; nearest: 'cows.obj'");
}

TEST_F(FileLookup, FoldersAndDevicesAreNotFiles) {
    fs::create_directories(folder.path() / "cow.obj");
    EXPECT_EQ(idsOf(find("cow.obj").remarks), "file-E01");
    EXPECT_EQ(find("cow.obj").remarks.front().subject, "cow.obj");
    EXPECT_EQ(idsOf(find("/dev/zero").remarks), "file-E01");
    EXPECT_EQ(idsOf(find("/dev/stdin").remarks), "file-E01");
}

TEST_F(FileLookup, LinksAreFollowedAndBrokenOnesCountAsMissing) {
    folder.write("cow.obj");
    fs::create_symlink("cow.obj", folder.path() / "link.obj");
    fs::create_symlink("nowhere.obj", folder.path() / "broken.obj");
    fs::create_symlink("loop.obj", folder.path() / "loop.obj");
    EXPECT_EQ(find("link.obj").path, folder.path() / "link.obj");
    EXPECT_EQ(idsOf(find("broken.obj").remarks), "file-E01");
    EXPECT_EQ(idsOf(find("loop.obj").remarks), "file-E01");
}

TEST_F(FileLookup, StrangeNamesFindNothing) {
    const std::string longName(100'000, 'x');
    std::string deep;
    for (int i = 0; i < 1000; ++i) deep += "a/";
    for (const std::string& name :
         {std::string(), std::string("."), std::string(".."), std::string("/"), std::string("\\"),
          std::string("C:"), std::string("a\0b", 3), longName, deep + "x", std::string("//")})
        EXPECT_EQ(idsOf(find(name).remarks), "file-E01") << name.substr(0, 20);
}

TEST_F(FileLookup, TheCurrentFolderIsNeverSearched) {
    const TemporaryFolder current;
    current.write("only-here.obj");
    const fs::path before = fs::current_path();
    fs::current_path(current.path());
    EXPECT_EQ(idsOf(find("only-here.obj").remarks), "file-E01");
    EXPECT_EQ(find("only-here.obj").path, "");
    EXPECT_EQ(scene::find("only-here.obj", "scene.glib").path, "only-here.obj")
        << "a scene in the current folder";
    fs::current_path(before);
}

TEST_F(FileLookup, LibraryRootsComeLastInTheOrderOfTheirFolders) {
    const fs::path scene = folder.path() / "scenes" / "noise" / "a.glib";
    const InterpretOptions options{{folder.path() / "library"}};
    const auto found = [&](std::string_view name) { return scene::find(name, scene, options).path; };
    const fs::path model = folder.write("library/scenes/models/thing");
    EXPECT_EQ(found("thing"), model);
    const fs::path texture = folder.write("library/textures/thing");
    EXPECT_EQ(found("thing"), texture);
    const fs::path shader = folder.write("library/shaders/thing");
    EXPECT_EQ(found("thing"), shader);
    const fs::path topic = folder.write("library/shaders/noise/thing");
    EXPECT_EQ(found("thing"), topic);
    EXPECT_TRUE(scene::find("thing", scene, options).remarks.empty());
    EXPECT_EQ(found("noise/thing"), topic);
    const fs::path beside = folder.write("scenes/noise/thing");
    EXPECT_EQ(found("thing"), beside);
    EXPECT_EQ(idsOf(scene::find("noise/thing", scene, options).remarks), "file-W02")
        << "its last part lies beside";
}

TEST_F(FileLookup, CaseIsForgivenInLibraryRootsToo) {
    const fs::path path = folder.write("library/textures/Wood.bmp");
    const FileReference file = scene::find("wood.BMP", folder.path() / "s" / "a.glib",
                                           InterpretOptions{{folder.path() / "library"}});
    EXPECT_EQ(file.path, path);
    EXPECT_EQ(remarkOf(file), "file-W01 'wood.BMP' found as 'Wood.bmp'");
}

TEST_F(FileLookup, TheNearestFolderAboveWithShadersOrTexturesIsALibraryRoot) {
    const fs::path scene = folder.path() / "project" / "glib" / "noise" / "a.glib";
    const fs::path shader = folder.write("project/shaders/noise/a.vert");
    folder.write("shaders/noise/a.vert");
    const fs::path texture = folder.write("project/textures/a.bmp");
    EXPECT_EQ(scene::find("a.vert", scene).path, shader);
    EXPECT_EQ(scene::find("a.bmp", scene).path, texture);
    folder.write("textures/far.bmp");
    EXPECT_EQ(idsOf(scene::find("far.bmp", scene).remarks), "file-E01") << "only the nearest one";
}

TEST_F(FileLookup, ATopicMayHaveTopicsInIt) {
    const fs::path shader = folder.write("shaders/light/phong/a.vert");
    EXPECT_EQ(scene::find("a.vert", folder.path() / "glib" / "light" / "phong" / "a.glib").path, shader);
}

TEST_F(FileLookup, GivenRootsComeBeforeTheFolderAbove) {
    const fs::path given = folder.write("given/textures/a.bmp");
    folder.write("project/textures/a.bmp");
    EXPECT_EQ(scene::find("a.bmp", folder.path() / "project" / "a.glib",
                          InterpretOptions{{folder.path() / "given"}})
                  .path,
              given);
}

TEST_F(FileLookup, IncludesAreLookedForBesideTheIncludingFileFirst) {
    const fs::path scene = folder.path() / "scene.glib";
    const fs::path including = folder.write("shaders/a.vert");
    const fs::path besideScene = folder.write("light.glsl");
    FolderListings listings;
    EXPECT_EQ(findInclude("light.glsl", including.string(), scene.string(), {}, listings).path, besideScene);
    const fs::path beside = folder.write("shaders/light.glsl");
    EXPECT_EQ(findInclude("light.glsl", including.string(), scene.string(), {}, listings).path, beside);
    const FileReference absent = findInclude("no.glsl", including.string(), scene.string(), {}, listings);
    EXPECT_EQ(idsOf(absent.remarks), "file-E01");
    EXPECT_EQ(absent.place.file, including.string());
}

TEST_F(FileLookup, AFolderAndTheWayBackAreNothing) {
    const fs::path path = folder.write("sub/cow.obj");
    for (const char* name : {"no/../sub/cow.obj", "sub/no/./..//cow.obj", "sub\\a\\b\\..\\..\\cow.obj"}) {
        EXPECT_EQ(find(name).path, path) << name;
        EXPECT_TRUE(find(name).remarks.empty()) << name;
    }
    folder.write("a/b/x");
    EXPECT_EQ(scene::find("../../sub/cow.obj", folder.path() / "a/b/scene.glib").path.lexically_normal(),
              path);
}

TEST_F(FileLookup, ANameOfManyFoldersAndWaysBackTakesNoTime) {
    folder.write("Aa/x");
    folder.write("aA/x");
    folder.write("AA/x");
    std::string name;
    for (int i = 0; i < 600; ++i) name += "aa/../";
    const SearchFolders folders = searchFolders(folder.path() / "scene.glib");
    FolderListings listings;
    for (int i = 0; i < 90; ++i)
        EXPECT_EQ(
            idsOf(findFile(name + "none" + std::to_string(i), {"a.glib", 3, 5}, folders, listings).remarks),
            "file-E01");
    EXPECT_FALSE(listings.isSpent());
}

TEST_F(FileLookup, OneBudgetForAllNamesOfASceneWithOneMessage) {
    for (int i = 0; i < 3000; ++i) folder.write(fmt::format("picture-number-{:05}.bmp", i));
    const fs::path there = folder.write("There.bmp");
    const SearchFolders folders = searchFolders(folder.path() / "scene.glib");
    FolderListings listings;
    const auto find = [&](const std::string& name) {
        return findFile(name, {"a.glib", 3, 5}, folders, listings);
    };
    EXPECT_NE(find("picture-numbr-00007.bmp").remarks.at(0).text.find("nearest"), std::string::npos);
    EXPECT_EQ(idsOf(find("there.bmp").remarks), "file-W01");
    int reported = 0;
    for (int i = 0; i < 20'000; ++i) {
        const FileReference missing = find(fmt::format("picture-numbr-{:05}.bmp", i));
        EXPECT_EQ(missing.remarks.at(0).id, "file-E01");
        EXPECT_EQ(idsOf(missing.remarks).find("file-W13") != std::string::npos, missing.remarks.size() > 1)
            << i;
        reported += static_cast<int>(missing.remarks.size()) - 1;
    }
    EXPECT_EQ(reported, 1);
    EXPECT_TRUE(listings.isSpent());
    EXPECT_EQ(remarkOf(find("picture-numbr-00007.bmp")), "file-E01 cannot find 'picture-numbr-00007.bmp'");
    EXPECT_EQ(find("There.bmp").path, there) << "names as they are written are still found";
}

TEST_F(FileLookup, OnlyTheFolderOfTheSceneAndTheLibraryMayBeShown) {
    const fs::path own = folder.write("project/glib/sub/a.frag"),
                   shared = folder.write("project/shaders/b.frag"),
                   secret = folder.write("project/secret.txt"),
                   hidden = folder.write("project/glib/.git/config");
    fs::create_symlink(secret, folder.path() / "project/glib/link.frag");
    const base::Roots roots = shownRoots(searchFolders(folder.path() / "project/glib/a.glib"));
    EXPECT_TRUE(roots.contains(own));
    EXPECT_TRUE(roots.contains(shared));
    EXPECT_FALSE(roots.contains(secret));
    EXPECT_FALSE(roots.contains(hidden));
    EXPECT_FALSE(roots.contains(folder.path() / "project/glib/link.frag"));
    EXPECT_FALSE(roots.contains(folder.path() / "project/glib/../secret.txt"));
}

TEST(FolderListing, NamesAreInByteOrderAndReadOnce) {
    const TemporaryFolder folder;
    for (const char* name : {"b", "B", "a", "_"}) folder.write(name);
    FolderListings listings;
    EXPECT_EQ(listings.names(folder.path()), (std::vector<std::string>{"B", "_", "a", "b"}));
    folder.write("c");
    EXPECT_EQ(listings.names(folder.path()).size(), 4U);
    EXPECT_TRUE(listings.names(folder.path() / "absent").empty());
    EXPECT_TRUE(listings.names(folder.path() / "a").empty()) << "a file has no names in it";
}

TEST(NearFiles, TheNearestComeFirstAndThreeAtMost) {
    const TemporaryFolder folder;
    for (const char* name : {"texture1.bmp", "texture22.bmp", "texture333.bmp", "texturexy.bmp", "other.png"})
        folder.write(name);
    fs::create_directories(folder.path() / "texture.bmp");
    FolderListings listings;
    const std::vector<fs::path> folders{folder.path()};
    EXPECT_EQ(nearestFiles("TEXTURE.bmp", folders, listings),
              (std::vector<std::string>{"texture1.bmp", "texture22.bmp", "texturexy.bmp"}))
        << "a folder is no file";
    EXPECT_TRUE(nearestFiles("", folders, listings).empty());
    EXPECT_TRUE(nearestFiles(std::string(300, 't'), folders, listings).empty());
}

}  // namespace
}  // namespace glibra::scene
