// What counts as a submission, and which of its scenes is drawn.

#include "classroom/submissions.h"

#include <gtest/gtest.h>

#include "../suite/folder.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

class SubmissionsTest : public testing::Test {
  protected:
    void SetUp() override { folder = made.path(); }

    void write(const fs::path& name) const { suite::writeText(folder / name, "Sphere\n"); }
    [[nodiscard]] std::vector<Submission> found(const SubmissionOptions& options = {}) const {
        Result<Submissions> read = findSubmissions(folder, options);
        return read ? read->all : std::vector<Submission>{};
    }
    [[nodiscard]] std::string sceneOf(const SubmissionOptions& options = {}) const {
        const std::vector<Submission> all = found(options);
        if (all.size() != 1) return "expected one submission";
        return all[0].scene.empty() ? all[0].problem : all[0].scene.lexically_relative(folder).string();
    }

    suite::Folder made;
    fs::path folder;
};

TEST_F(SubmissionsTest, FoldersAndSceneFilesInTheOrderOfTheirNames) {
    write("dora/x.glib");
    write("Ana.glib");
    write("bob/deep/er/y.GLIB");
    write("notes.txt");
    write(".git/z.glib");
    write("textures/t.glib");
    const Result<Submissions> read = findSubmissions(folder, {});
    ASSERT_TRUE(read);
    ASSERT_EQ(read->all.size(), 3U);
    EXPECT_EQ(read->all[0].name, "Ana");
    EXPECT_EQ(read->all[0].folder, folder);
    EXPECT_EQ(read->all[1].name, "bob");
    EXPECT_EQ(read->all[1].scene, folder / "bob/deep/er/y.GLIB");
    EXPECT_EQ(read->all[1].folder, folder / "bob");
    EXPECT_EQ(read->all[2].name, "dora");
    EXPECT_EQ(read->leftOut, std::vector<std::string>{"notes.txt"});
}

TEST_F(SubmissionsTest, TheNameOfTheReferenceDecidesThenTheStudentsNameThenTheDepth) {
    write("ana/b/ana.glib");
    write("ana/c/sub.glib");
    write("ana/solution.glib");
    EXPECT_EQ(sceneOf({.scenes = {}, .reference = "x/solution.glib", .others = {}}), "ana/solution.glib");
    EXPECT_EQ(sceneOf({.scenes = {}, .reference = "x/other.glib", .others = {}}), "ana/b/ana.glib");
    fs::remove(folder / "ana/b/ana.glib");
    EXPECT_EQ(sceneOf({.scenes = {}, .reference = "x/other.glib", .others = {}}), "ana/solution.glib");
}

TEST_F(SubmissionsTest, ScenesBetweenWhichNothingDecidesAreNamed) {
    write("ana/a.glib");
    write("ana/b.glib");
    EXPECT_EQ(sceneOf({.scenes = {}, .reference = "solution.glib", .others = {}}),
              "the folder has 2 scenes: 'a.glib', 'b.glib'; expected one, or one named 'solution.glib' or "
              "'ana.glib'; --scene chooses");
}

TEST_F(SubmissionsTest, APatternChooses) {
    write("ana/a.glib");
    write("ana/src/b.glib");
    EXPECT_EQ(sceneOf({.scenes = {"b.*"}, .reference = {}, .others = {}}), "ana/src/b.glib");
    EXPECT_EQ(sceneOf({.scenes = {"src/*.glib"}, .reference = {}, .others = {}}), "ana/src/b.glib");
    EXPECT_EQ(sceneOf({.scenes = {"final.glib", "b.*", "a.*"}, .reference = {}, .others = {}}),
              "ana/src/b.glib");
}

TEST_F(SubmissionsTest, APatternThatFitsNothingLeavesTheOtherRules) {
    write("ana/a.glib");
    EXPECT_EQ(sceneOf({.scenes = {"project2.glib"}, .reference = {}, .others = {}}), "ana/a.glib");
    write("ana/deep/b.glib");
    EXPECT_EQ(sceneOf({.scenes = {"project2.glib"}, .reference = {}, .others = {}}), "ana/a.glib");
    write("ana/c.glib");
    EXPECT_NE(sceneOf({.scenes = {"project2.glib"}, .reference = {}, .others = {}}).find("has 3 scenes"),
              std::string::npos);
}

TEST_F(SubmissionsTest, AStudentMayHaveAPatternOfTheirOwn) {
    write("ana/a.glib");
    write("ana/b.glib");
    SubmissionOptions options{.scenes = {"a.glib"}, .reference = {}, .others = {}};
    options.sceneOf = {{"ana", "b.*"}};
    EXPECT_EQ(sceneOf(options), "ana/b.glib");
    options.sceneOf = {{"ana", "c.*"}};
    EXPECT_EQ(sceneOf(options), "no scene fits --scene-of 'ana=c.*'; found 'a.glib', 'b.glib'");
}

TEST_F(SubmissionsTest, AFolderWithoutASceneNamesWhatMayHaveBeenMeant) {
    write("ana/x.glib.txt");
    EXPECT_EQ(sceneOf(),
              "the folder has no scene: expected a file whose name ends with '.glib'; found 'x.glib.txt', "
              "which has another ending");
    write("ana/one.zip");
    write("ana/two.ZIP");
    EXPECT_NE(sceneOf().find("found 'one.zip', 'two.ZIP', which are not unpacked"), std::string::npos)
        << sceneOf();
    fs::remove_all(folder / "ana");
    write("bob.glib.txt");
    EXPECT_EQ(sceneOf(), "'bob.glib.txt' is no scene: expected a name that ends with '.glib'");
    EXPECT_EQ(found()[0].name, "bob");
}

TEST_F(SubmissionsTest, AnEmptyFolderIsASubmissionWithoutAScene) {
    fs::create_directories(folder / "ana");
    EXPECT_EQ(sceneOf(), "the folder has no scene: expected a file whose name ends with '.glib'");
}

TEST_F(SubmissionsTest, LinksAreNotFollowed) {
    write("ana/a.glib");
    fs::create_symlink(folder / "ana/a.glib", folder / "bob.glib");
    fs::create_directory_symlink(folder / "ana", folder / "cem");
    fs::create_directories(folder / "dora");
    fs::create_symlink("/etc/passwd", folder / "dora/d.glib");
    const std::vector<Submission> all = found();
    ASSERT_EQ(all.size(), 4U);
    EXPECT_FALSE(all[0].scene.empty());
    for (std::size_t i = 1; i < all.size(); ++i) {
        EXPECT_TRUE(all[i].scene.empty()) << all[i].name;
        EXPECT_NE(all[i].problem.find("is a link"), std::string::npos) << all[i].problem;
    }
}

TEST_F(SubmissionsTest, TheReferenceAndWhatIsNamedAreNoSubmissions) {
    write("solution/solution.glib");
    write("ana/a.glib");
    write("site/index.glib");
    const std::vector<Submission> all = found({.scenes = {},
                                               .reference = folder / "solution/solution.glib",
                                               .others = {folder / "site", folder / "solution"}});
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].name, "ana");
}

TEST_F(SubmissionsTest, ALinkToTheReferenceIsNamedUnlessTheTeacherNamesIt) {
    write("solution/solution.glib");
    write("ana/a.glib");
    fs::create_directory_symlink(folder / "solution", folder / "eve");
    fs::create_symlink(folder / "solution/solution.glib", folder / "eve.glib");
    fs::create_directory_symlink(folder / "solution", folder / "mine");
    const std::vector<Submission> all = found({.scenes = {},
                                               .reference = folder / "solution/solution.glib",
                                               .others = {folder / "solution", folder / "mine"}});
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0].name, "ana");
    for (const std::size_t i : {1U, 2U})
        EXPECT_NE(all[i].problem.find("the submission is a link"), std::string::npos) << all[i].name;
}

TEST_F(SubmissionsTest, AnOwnOneIsNotThePageOfAnEarlierRun) {
    write("me/a.zip");
    write("me/page/unpacked/me/old.glib");
    write("me/other/unpacked/me/old.glib");
    write("me/other/unpacked/.made-by-glibra");
    write("me/solution/solution.glib");
    const Result<Submissions> own = ownSubmission(
        folder / "me",
        {.scenes = {}, .reference = folder / "me/solution/solution.glib", .others = {folder / "me/page"}});
    ASSERT_TRUE(own);
    EXPECT_EQ(own->all[0].scene, fs::path());
    ASSERT_EQ(own->all[0].parts.size(), 1U) << own->all[0].problem;
    EXPECT_EQ(own->all[0].parts[0].file, folder / "me/a.zip");
}

TEST_F(SubmissionsTest, AreFoundHoweverDeepAZipFileMayPutThem) {
    fs::path deep = "ana";
    for (int i = 0; i < 30; ++i) deep /= std::to_string(i);
    write(deep / "a.glib");
    EXPECT_EQ(sceneOf(), deep / "a.glib");
}

TEST_F(SubmissionsTest, AFolderAndAFileOfOneNameKeepDifferentNames) {
    write("ana/a.glib");
    write("ana.glib");
    const std::vector<Submission> all = found();
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].name, "ana");
    EXPECT_EQ(all[1].name, "ana.glib");
}

TEST_F(SubmissionsTest, AFolderWithoutSubmissionsIsAMistake) {
    const Result<Submissions> none = findSubmissions(folder, {});
    EXPECT_FALSE(none);
    EXPECT_FALSE(findSubmissions(folder / "missing", {}));
}

}  // namespace
}  // namespace glibra::classroom
