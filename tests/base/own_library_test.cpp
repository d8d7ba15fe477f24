// Where a library of scenes is looked for.

#include "base/own_library.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "../support/new_folder.h"
#include "system/places.h"

namespace glibra::base {
namespace {

namespace fs = std::filesystem;

class OwnLibrary : public testing::Test {
  protected:
    OwnLibrary() { folder_ = fs::canonical(test::newFolder("library")); }
    ~OwnLibrary() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    /// Makes the folder a library.
    fs::path library(const fs::path& name) const {
        for (const char* each : {"glib", "shaders"}) fs::create_directories(folder_ / name / each);
        return folder_ / name;
    }
    fs::path folder_;
};

TEST_F(OwnLibrary, HasBothScenesAndShaders) {
    fs::create_directories(folder_ / "half/glib");
    EXPECT_FALSE(isLibrary(folder_ / "half"));
    EXPECT_FALSE(isLibrary(folder_ / "missing"));
    EXPECT_TRUE(isLibrary(library("whole")));
}

TEST_F(OwnLibrary, IsTheNearestOne) {
    const fs::path outer = library("outer"), inner = library("outer/a/inner");
    fs::create_directories(inner / "b/c");
    EXPECT_EQ(libraryAbove(inner / "b/c"), inner);
    EXPECT_EQ(libraryAbove(inner), inner);
    EXPECT_EQ(libraryAbove(inner / "b/../.."), outer);
    EXPECT_EQ(libraryAbove(folder_ / "elsewhere"), fs::path());
}

TEST_F(OwnLibrary, OfAnInstallationIsBesideItsPrograms) {
    const fs::path installed = library("prefix/share/glibra");
    EXPECT_EQ(libraryAbove(folder_ / "prefix/bin"), installed);
    EXPECT_EQ(libraryAbove(folder_ / "prefix/lib/glibra"), installed);
}

TEST(ProgramFile, IsTheFileThatRuns) {
    EXPECT_EQ(system::programFile().stem(), "glibra_base_tests");
    EXPECT_TRUE(fs::is_regular_file(system::programFile()));
}

}  // namespace
}  // namespace glibra::base
