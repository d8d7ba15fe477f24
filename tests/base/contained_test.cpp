#include "base/contained.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>

namespace glibra::base {
namespace {

namespace fs = std::filesystem;

class Contained : public testing::Test {
  protected:
    Contained() {
        std::string pattern = (fs::temp_directory_path() / "glibra-base-XXXXXX").string();
        outside = ::mkdtemp(pattern.data());
        root = outside / "root";
        fs::create_directories(root / "a");
        write(outside / "secret", "secret");
        write(root / "a/file", "inside");
        fs::create_symlink(outside / "secret", root / "a/link");
        fs::create_directory_symlink(outside, root / "up");
        ::mkfifo((root / "a/pipe").c_str(), 0600);
    }
    ~Contained() override { fs::remove_all(outside); }
    static void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }
    static std::string read(const fs::path& path) {
        std::ostringstream text;
        text << std::ifstream(path).rdbuf();
        return text.str();
    }
    int whyNot(const fs::path& path) const {
        const system::File file = openBeneath(root, path);
        return file ? 0 : errno;
    }
    int put(const fs::path& path, const std::string& text) const {
        return writeBeneath(root, path, std::as_bytes(std::span(text)));
    }

    fs::path outside, root;
};

TEST_F(Contained, AFileThatReplacesAnotherKeepsItsPermissions) {
    const fs::path file = root / "a/file";
    for (const mode_t mode : {0600U, 0444U, 0666U}) {
        ASSERT_EQ(::chmod(file.c_str(), mode), 0);
        EXPECT_EQ(put("a/file", "new"), 0);
        struct stat status{};
        ASSERT_EQ(::stat(file.c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777U, mode);
    }
    if (::geteuid() != 0) return;
    // What belongs to somebody else says nothing about this user's files.
    ASSERT_EQ(::chown(file.c_str(), 4321, 4321), 0);
    EXPECT_EQ(put("a/file", "new"), 0);
    struct stat status{};
    ASSERT_EQ(::stat(file.c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, 0U);
    EXPECT_EQ(status.st_mode & 0022U, 0U);
}

TEST_F(Contained, OpensOrdinaryFilesOnly) {
    std::vector<std::byte> bytes;
    EXPECT_EQ(readAll(openBeneath(root, "a/./file"), 6, bytes), 0);
    EXPECT_EQ(bytes.size(), 6U);
    EXPECT_EQ(readAll(openBeneath(root, "a/file"), 5, bytes), EFBIG);
    EXPECT_EQ(whyNot("a/none"), ENOENT);
    EXPECT_EQ(whyNot("a"), ENOTSUP);
    EXPECT_EQ(whyNot("a/pipe"), ENOTSUP) << "and it does not block";
}

TEST_F(Contained, NeverLeavesTheRoot) {
    for (const char* path : {"../secret", "a/../../secret", "a/..", "..", ""})
        EXPECT_EQ(whyNot(path), EINVAL) << path;
    EXPECT_EQ(whyNot(outside / "secret"), EINVAL);
    EXPECT_EQ(whyNot("a/link"), ELOOP);
    EXPECT_EQ(whyNot("up/secret"), ELOOP);
    EXPECT_EQ(whyNot("up/root/a/file"), ELOOP) << "not even a link that comes back";
}

TEST_F(Contained, WritesReplaceALinkAndFollowNone) {
    EXPECT_EQ(put("new/deep/file", "new"), 0);
    EXPECT_EQ(read(root / "new/deep/file"), "new");
    EXPECT_EQ(put("a/link", "mine"), 0);
    EXPECT_FALSE(fs::is_symlink(root / "a/link"));
    EXPECT_EQ(read(root / "a/link"), "mine");
    EXPECT_EQ(put("up/secret", "x"), ELOOP);
    EXPECT_EQ(put("../secret", "x"), EINVAL);
    EXPECT_NE(put("a", "x"), 0) << "a folder is not replaced";
    EXPECT_EQ(read(outside / "secret"), "secret");
    for (const auto& each : fs::recursive_directory_iterator(root))
        EXPECT_FALSE(each.path().filename().string().starts_with(".glibra-")) << each.path();
}

TEST_F(Contained, FoldersAreMadeThroughNoLink) {
    fs::create_directory(root / "other");
    fs::create_directory_symlink(root / "other", root / "link");
    EXPECT_EQ(makeFoldersBeneath(root, "link/new"), ELOOP);
    EXPECT_FALSE(fs::exists(root / "other/new"));
    EXPECT_EQ(makeFoldersBeneath(root, "link"), ELOOP);
    EXPECT_EQ(makeFoldersBeneath(root / "link", "new/deep"), 0) << "the root may be a link";
    EXPECT_TRUE(fs::is_directory(root / "other/new/deep"));
    EXPECT_EQ(makeFoldersBeneath(root / "made", "."), 0);
    EXPECT_TRUE(fs::is_directory(root / "made"));
    EXPECT_EQ(makeFoldersBeneath(root, "../up"), EINVAL);
}

TEST_F(Contained, PreparingRemovesWhatAWriteWouldFollow) {
    EXPECT_EQ(prepareBeneath(root, "a/link"), 0);
    EXPECT_FALSE(fs::is_symlink(root / "a/link"));
    EXPECT_EQ(prepareBeneath(root, "a/pipe"), 0);
    EXPECT_FALSE(fs::exists(root / "a/pipe"));
    EXPECT_EQ(prepareBeneath(root, "a/file"), 0);
    EXPECT_EQ(read(root / "a/file"), "inside");
    EXPECT_EQ(prepareBeneath(root, "up/x"), ELOOP);
    EXPECT_EQ(prepareBeneath(root, "b/c/x"), 0);
    EXPECT_TRUE(fs::is_directory(root / "b/c"));
}

TEST_F(Contained, RemovesTheLinkAndNotItsTarget) {
    EXPECT_EQ(removeBeneath(root, "a/link"), 0);
    EXPECT_EQ(removeBeneath(root, "up/secret"), ELOOP);
    EXPECT_EQ(read(outside / "secret"), "secret");
}

TEST_F(Contained, RootsShowWhatLiesBelowThemAndIsNotHidden) {
    Roots roots;
    EXPECT_FALSE(roots.contains(root / "a/file")) << "no roots, no files";
    roots.add(root);
    roots.add(outside / "none");
    fs::create_directories(root / ".git");
    write(root / ".git/config", "token");
    EXPECT_TRUE(roots.contains(root / "a/file"));
    EXPECT_TRUE(roots.open(root / "a/../a/file"));
    for (const char* path :
         {"root/a/link", "root/up/secret", "root/../secret", "secret", "root/.git/config", "rootless"}) {
        EXPECT_FALSE(roots.contains(outside / path)) << path;
        EXPECT_FALSE(roots.open(outside / path)) << path;
    }
    EXPECT_FALSE(roots.open(outside / "secret"));
    EXPECT_EQ(errno, EACCES);
}

TEST_F(Contained, ARootMayBeReachedThroughALink) {
    fs::create_directory_symlink(root, outside / "linked");
    Roots roots;
    roots.add(outside / "linked/");
    EXPECT_TRUE(roots.contains(outside / "linked/a/file"));
    EXPECT_TRUE(roots.open(outside / "linked/a/file"));
    EXPECT_TRUE(roots.open(root / "a/file"));
    EXPECT_FALSE(roots.open(outside / "linked/a/link"));
}

}  // namespace
}  // namespace glibra::base
