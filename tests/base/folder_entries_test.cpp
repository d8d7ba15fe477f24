// The entries of folders that are there, missing or forbidden.

#include "base/files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "../support/new_folder.h"

namespace glibra::base {
namespace {

namespace fs = std::filesystem;

class FolderEntries : public testing::Test {
  protected:
    FolderEntries() {
        root = test::newFolder("entries");
        for (const char* each : {"a", ".b", "c d"}) std::ofstream(root / each) << each;
        fs::create_directories(root / "folder/below");
    }
    ~FolderEntries() override {
        std::error_code ignored;
        fs::remove_all(root, ignored);
    }

    fs::path root;
};

TEST_F(FolderEntries, AreThoseOfTheFolderItself) {
    std::error_code failure = std::make_error_code(std::errc::io_error);
    std::set<std::string> names;
    for (const fs::directory_entry& each : entriesOf(root, failure))
        names.insert(each.path().lexically_relative(root).string());
    EXPECT_FALSE(failure);
    EXPECT_EQ(names, (std::set<std::string>{"a", ".b", "c d", "folder"}));
    EXPECT_TRUE(entriesOf(root / "folder/below").empty());
}

TEST_F(FolderEntries, AreNoneOfWhatIsNoFolder) {
    for (const char* each : {"missing", "a"}) {
        std::error_code failure;
        EXPECT_TRUE(entriesOf(root / each, failure).empty()) << each;
        EXPECT_TRUE(failure) << each;
        EXPECT_TRUE(entriesOf(root / each).empty()) << each;
    }
}

TEST_F(FolderEntries, AreNoneOfAFolderThatIsForbidden) {
    fs::permissions(root / "folder", fs::perms::none);
    std::error_code failure, refused;
    const bool isEmpty = entriesOf(root / "folder", failure).empty();
    const fs::directory_iterator opened(root / "folder", refused);
    // The superuser may read every folder, and so may all where folders have no such mode.
    EXPECT_TRUE((isEmpty && failure == std::errc::permission_denied) || !refused);
    fs::permissions(root / "folder", fs::perms::owner_all);
}

}  // namespace
}  // namespace glibra::base
