// A pipe in the place of a file that a scene names.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "scene/file_lookup.h"
#include "support.h"

namespace glibra::scene {
namespace {

TEST(PipeLookup, PipesAreNotFiles) {
    const tests::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder.path() / "pipe.obj").c_str(), 0600), 0);
    for (const char* name : {"pipe.obj", "PIPE.obj"}) {
        FolderListings listings;
        const FileReference file =
            findFile(name, {"a.glib", 3, 5}, searchFolders(folder.path() / "scene.glib", {}), listings);
        EXPECT_EQ(tests::idsOf(file.remarks), "file-E01") << name;
    }
}

}  // namespace
}  // namespace glibra::scene
