// Patterns, compared with fnmatch() of the C library.

#include "suite/file/selection.h"

#include <fnmatch.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>

#include "suite_text.h"

namespace glibra::suite::test {
namespace {

TEST(Glob, FitsAsAShellWould) {
    EXPECT_TRUE(fits("*", ""));
    EXPECT_TRUE(fits("oval*@uTol=?.1", "oval/noise@uTol=0.1"));
    EXPECT_TRUE(fits("[a-c]x[!0-9]", "bxy"));
    EXPECT_FALSE(fits("[a-c]x[!0-9]", "bx7"));
    EXPECT_FALSE(fits("[a-c]x", "dx"));
    EXPECT_TRUE(fits("[]a]", "]"));
    EXPECT_TRUE(fits("a[b", "a[b"));
    EXPECT_FALSE(fits("teapot", "teapots"));
    EXPECT_FALSE(fits("", "a"));
}

TEST(Glob, AgreesWithTheCLibraryOnRandomPatterns) {
    std::mt19937 random(7);
    const std::string alphabet = "ab*?[]!-/.";
    const auto text = [&](std::size_t letters) {
        std::string made;
        for (auto left = random() % 9; left > 0; --left) made += alphabet[random() % letters];
        return made;
    };
    int fitting = 0;
    for (int i = 0; i < 200'000; ++i) {
        const std::string pattern = text(alphabet.size());
        const std::string name = text(2);
        // POSIX does not define reversed ranges, slashes in a set, and sets without an end.
        if (pattern.find('-') != std::string::npos || pattern.find('/') != std::string::npos) continue;
        if (pattern.find('[') != std::string::npos &&
            (pattern.find('[', pattern.find('[') + 1) != std::string::npos ||
             pattern.find(']', pattern.find('[') + 2) == std::string::npos))
            continue;
        const bool expected = ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
        ASSERT_EQ(fits(pattern, name), expected) << pattern << " for " << name;
        fitting += expected ? 1 : 0;
    }
    EXPECT_GT(fitting, 1000);
}

TEST(Glob, TakesNoLongTimeForManyStars) {
    std::string pattern;
    for (int i = 0; i < 200; ++i) pattern += "*a";
    EXPECT_FALSE(fits(pattern + "b", std::string(2000, 'a')));
}

std::string found(const SceneFolder& folder, std::string_view pattern) {
    const auto files = filesThatFit(folder.path(), pattern);
    std::string names;
    for (const auto& each : *files) names += each.lexically_relative(folder.path()).string() + " ";
    return names;
}

TEST(Glob, FindsFilesPartByPart) {
    const SceneFolder folder{"a/x.glib",       "a/y.glib", "a/deep/er/z.glib", "b/x.glib",
                             "b/.hidden.glib", "top.glib", "a/x.txt"};
    EXPECT_EQ(found(folder, "a/*.glib"), "a/x.glib a/y.glib ");
    EXPECT_EQ(found(folder, "*/x.glib"), "a/x.glib b/x.glib ");
    EXPECT_EQ(found(folder, "**/*.glib"), "a/deep/er/z.glib a/x.glib a/y.glib b/x.glib top.glib ");
    EXPECT_EQ(found(folder, "a/**"), "a/deep/er/z.glib a/x.glib a/x.txt a/y.glib ");
    EXPECT_EQ(found(folder, "b/.h*"), "b/.hidden.glib ");
    EXPECT_EQ(found(folder, "a/**/**/z.glib"), "a/deep/er/z.glib ");
    EXPECT_EQ(found(folder, "*.toml"), "");
    EXPECT_EQ(found(folder, "a"), "");  // a folder is not a file
    EXPECT_EQ(found(folder, ""), "");
}

TEST(Glob, DoesNotFollowLinksToFoldersRoundAndRound) {
    const SceneFolder folder{"a/x.glib"};
    std::filesystem::create_directory_symlink(folder.path(), folder.path() / "a/back");
    EXPECT_EQ(found(folder, "**/*.glib"), "a/x.glib ");
}

TEST(Glob, ASearchOfAWholeDiskStopsAtItsLimits) {
    const SceneFolder folder{"x.glib"};
    std::filesystem::path deep = folder.path();
    for (int i = 0; i <= kDeepestSearch; ++i) deep /= "d";
    std::filesystem::create_directories(deep);
    EXPECT_FALSE(filesThatFit(folder.path(), "**/*.glib"));
    std::filesystem::remove(deep);
    EXPECT_EQ(found(folder, "**/*.glib"), "x.glib ");
}

TEST(Glob, KnowsTheFixedPartOfAPattern) {
    EXPECT_EQ(fixedFolder("../glib/*/a*.glib"), "../glib");
    EXPECT_EQ(fixedFolder("*.glib"), "");
    EXPECT_EQ(fixedFolder("a/b/c.glib"), "a/b");
    EXPECT_EQ(fixedFolder("/*.glib"), "/");
}

TEST(Glob, WhatCannotBeLookedAtIsAnError) {
    const SceneFolder folder{"a/x.glib", "b/y.glib"};
    std::filesystem::create_symlink("round", folder.path() / "round");  // a link to itself cannot be listed
    std::filesystem::create_symlink("nowhere.glib", folder.path() / "a/lost.glib");
    std::filesystem::create_symlink("nowhere.txt", folder.path() / "b/lost.txt");
    for (const char* pattern : {"round/*.glib", "round/**/*.glib", "*/*.glib", "a/*.glib", "**/*.glib"}) {
        const auto files = filesThatFit(folder.path(), pattern);
        EXPECT_FALSE(files) << pattern;
        ASSERT_EQ(files.diagnostics.size(), std::string(pattern) == "*/*.glib" ? 2U : 1U) << pattern;
        EXPECT_EQ(files.diagnostics.front().id, "suite-E22") << pattern;
    }
    EXPECT_EQ(found(folder, "b/*"), "b/y.glib ") << "a link that is no scene";
    EXPECT_EQ(found(folder, "missing/**/*.glib"), "") << "a folder that does not exist";
    EXPECT_EQ(found(folder, "b/y.glib/*.glib"), "") << "a file is no folder";
}

}  // namespace
}  // namespace glibra::suite::test
