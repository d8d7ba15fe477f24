#include "view/edit/source_files.h"

#include <gtest/gtest.h>

namespace glibra::view::test {
namespace {

using Paths = std::vector<std::filesystem::path>;
using Names = std::vector<std::string>;

TEST(NamesApart, HaveAsMuchOfTheFoldersAsNeeded) {
    EXPECT_EQ(namesApart(Paths{"/home/a.glib", "/home/b.glib"}), (Names{"a.glib", "b.glib"}));
    EXPECT_EQ(namesApart(Paths{"/w/one/a.glib", "/w/two/a.glib", "/w/b.glib"}),
              (Names{"one/a.glib", "two/a.glib", "b.glib"}));
    EXPECT_EQ(namesApart(Paths{"/w/one/x/a.glib", "/w/two/x/a.glib", "/w/two/y/a.glib"}),
              (Names{"one/x/a.glib", "two/x/a.glib", "y/a.glib"}));
    EXPECT_EQ(namesApart(Paths{"/a.glib", "/w/a.glib", "/w/a.glib"}),
              (Names{"/a.glib", "w/a.glib", "w/a.glib"}));
    EXPECT_TRUE(namesApart({}).empty());
}

}  // namespace
}  // namespace glibra::view::test
