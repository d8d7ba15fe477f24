// Where the modules are looked for.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "image/module_loader.h"

namespace glibra::image {
namespace {

bool isLookedFor(const char* folder, const char* program, const char* library) {
    const std::vector<std::filesystem::path> all = moduleFoldersOf(program, library);
    return std::find(all.begin(), all.end(), folder) != all.end();
}

TEST(ModuleFolders, AreThoseOfTheInstallationOfAProgramLibraryOrPackage) {
    EXPECT_TRUE(isLookedFor("/opt/g/lib/glibra", "/opt/g/bin/glibra", "/opt/g/bin/glibra"));
    EXPECT_TRUE(isLookedFor("/opt/g/lib/x86_64-linux-gnu/glibra", "/usr/bin/viewer",
                            "/opt/g/lib/x86_64-linux-gnu/libglibra.so.1"));
    const char* const python = "/usr/bin/python3.11";
    for (const char* each : {"/opt/g/lib/python3.11/site-packages/glibra/_core.so",
                             "/opt/g/lib/python3/dist-packages/glibra/_core.so"})
        EXPECT_TRUE(isLookedFor("/opt/g/lib/glibra", python, each)) << each;
    EXPECT_TRUE(
        isLookedFor("/opt/g/lib64/glibra", python, "/opt/g/lib64/python3.13/site-packages/glibra/_core.so"));
}

TEST(ModuleFolders, AreNotAnyFolderAboveALibrary) {
    EXPECT_FALSE(isLookedFor("/tmp/glibra", "/usr/bin/viewer", "/tmp/a/b/c/libplugin.so"));
    EXPECT_FALSE(isLookedFor("/tmp/glibra", "/usr/bin/viewer", "/tmp/a/site-packages/glibra/_core.so"));
    for (const std::filesystem::path& each :
         moduleFoldersOf("/usr/bin/viewer", "lib/python3.11/site-packages/glibra/_core.so"))
        EXPECT_TRUE(each.is_absolute()) << each;
}

}  // namespace
}  // namespace glibra::image
