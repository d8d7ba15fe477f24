// glibra language: the reference, and the pages of the documentation that are generated from it.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

/// The first line in which two texts differ, as "line 7: 'a', now 'b'"; empty if they are equal.
std::string firstDifference(const std::string& a, const std::string& b) {
    if (a == b) return {};
    std::istringstream linesOfA(a), linesOfB(b);
    for (int line = 1;; ++line) {
        std::string ofA, ofB;
        const bool more = static_cast<bool>(std::getline(linesOfA, ofA));
        const bool moreOfB = static_cast<bool>(std::getline(linesOfB, ofB));
        if (ofA != ofB || more != moreOfB) return fmt::format("line {}: '{}', now '{}'", line, ofA, ofB);
        if (!more) return "the end of the last line";
    }
}

TEST(LanguageCommand, PrintsEverySectionBetweenItsMarkers) {
    const Folder folder;
    const Finished finished = glibra(folder.path(), "language --markdown");
    ASSERT_EQ(finished.status, 0) << finished.err;
    std::size_t at = 0;
    for (const char* section : {"commands", "primitives", "formats", "supplied", "diagnostics", "options"}) {
        at = finished.out.find(std::string("<!-- generated: ") + section + " -->\n", at);
        ASSERT_NE(at, std::string::npos) << section;
        at = finished.out.find("\n<!-- end -->\n", at);
        ASSERT_NE(at, std::string::npos) << section;
    }
    for (const char* row :
         {"| `Sphere` | `radius` = 1: 0 draws nothing; the sign is ignored<br>`slices` = 60: 3 to ",
          "| `Sphere` | triangles | 3,719 | ", "| `RGBA16F` | 8 |", "| `.png` |",
          "`uNormalMatrix`, `gl_NormalMatrix` | `mat3` |", "| glib-E01 | error | unknown command 'Spere'"})
        EXPECT_NE(finished.out.find(row), std::string::npos) << row;
}

TEST(LanguageCommand, RefreshesOnlyTheSectionsOfAPage) {
    const Folder folder;
    folder.write("page.md", "# Title\n<!-- generated: formats -->\nold\n<!-- end -->\nrest");
    ASSERT_EQ(glibra(folder.path(), "language --markdown --update page.md").status, 0);
    const std::string page = readFile(folder / "page.md");
    EXPECT_TRUE(page.starts_with("# Title\n<!-- generated: formats -->\nFormats of empty textures")) << page;
    EXPECT_TRUE(page.ends_with("\n<!-- end -->\nrest")) << page;
    EXPECT_EQ(page.find("old"), std::string::npos);
}

TEST(LanguageCommand, SaysWhichMarkerIsWrong) {
    const Folder folder;
    folder.write("a.md", "<!-- generated: formats -->\n");
    folder.write("b.md", "text\n<!-- generated: shapes -->\n<!-- end -->\n");
    const Finished open = glibra(folder.path(), "language --markdown --update a.md");
    EXPECT_EQ(open.status, 3);
    EXPECT_EQ(open.err, "error: a.md: the section that begins on line 1 has no '<!-- end -->'\n");
    const Finished unknown = glibra(folder.path(), "language --markdown --update b.md");
    EXPECT_EQ(unknown.status, 3);
    EXPECT_EQ(unknown.err, "error: b.md: line 2: no generated section 'shapes'\n");
}

TEST(LanguageCommand, PagesOfTheDocumentationAreCurrent) {
    const fs::path pages = fs::path(GLIBRA_SOURCE_DIR) / "docs";
    ASSERT_TRUE(fs::is_directory(pages));
    const Folder folder;
    for (const fs::directory_entry& each : fs::directory_iterator(pages)) {
        if (each.path().extension() != ".md") continue;
        const std::string before = readFile(each.path());
        folder.write("page.md", before);
        const Finished finished = glibra(folder.path(), "language --markdown --update page.md");
        EXPECT_EQ(finished.status, 0) << each.path() << ": " << finished.err;
        EXPECT_EQ(firstDifference(before, readFile(folder / "page.md")), "")
            << each.path() << ": run tools/docs";
    }
}

}  // namespace
}  // namespace glibra::test
