// glibra language: the reference, and the pages of the documentation that are generated from it.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/texel_format.h"
#include "glib/statement_table.h"
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

/// What stands between backquotes on a page, outside of its generated sections.
std::string quotedOn(std::string page) {
    for (std::size_t from; (from = page.find("<!-- generated: ")) != std::string::npos;)
        page.erase(from, page.find("<!-- end -->", from) - from);
    std::string quoted;
    bool isQuoted = false;
    for (const char c : page) {
        if (c == '`') isQuoted = !isQuoted;
        if (c == '\n') isQuoted = false;
        quoted += isQuoted ? c : ' ';
    }
    return quoted;
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
          "| `Sphere` | triangles | 3,719 | ", "| `RGBA16F` | 8 |", "| `.png`, `.apng` |",
          "`uNormalMatrix`, `gl_NormalMatrix` | `mat3` |",
          "| glib-E01 | error | The first word of a statement is no word of the language. | unknown command "
          "'Spere'"})
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
            << each.path() << " is not current: run tools/docs";
    }
}

TEST(LanguageCommand, ThePageDescribesEveryCommandAndStatement) {
    const std::string quoted = quotedOn(readFile(fs::path(GLIBRA_SOURCE_DIR) / "docs" / "language.md"));
    const auto describes = [&](std::string_view word) {
        return std::regex_search(quoted, std::regex(fmt::format("\\b{}\\b", word)));
    };
    EXPECT_FALSE(describes("Spher"));
    std::vector<std::string_view> words;
    for (const glib::StatementRow& row : glib::commandTable()) words.push_back(row.name);
    for (const glib::StatementRow& row : glib::statementTable()) words.push_back(row.name);
    for (const std::string_view each : words)
        EXPECT_TRUE(describes(each)) << each << ": describe it in docs/language.md, outside of the generated "
                                     << "tables (commands: 3, shapes: 4, modern statements: 12)";
}

TEST(LanguageCommand, ThePageDescribesNothingThatIsNotThere) {
    const std::string page = readFile(fs::path(GLIBRA_SOURCE_DIR) / "docs" / "language.md");
    const auto section = [&](const std::string& title) {
        const std::size_t from = page.find("\n## " + title);
        return page.substr(from, page.find("\n## ", from + 1) - from);
    };
    const std::string tables = section("3. Commands") + section("4. Geometry") + section("12. Modern scenes");
    std::set<std::string, std::less<>> words;
    for (const glib::StatementRow& row : glib::commandTable())
        for (const std::string_view name : row.names()) words.emplace(name);
    std::string syntax(glib::syntaxFragment("lens"));  // also has the words inside of statements
    for (const glib::StatementRow& row : glib::statementTable())
        syntax += fmt::format("{} {} ", row.name, row.syntax);
    const std::regex kWord("[A-Z]\\w*"), kFirst("\n\\| `([A-Z][a-z]\\w*)");
    for (std::sregex_iterator each(syntax.begin(), syntax.end(), kWord), end; each != end; ++each)
        words.insert(each->str());
    for (std::sregex_iterator each(tables.begin(), tables.end(), kFirst), end; each != end; ++each)
        EXPECT_TRUE(words.contains((*each)[1].str())) << (*each)[1] << ": docs/language.md describes it";

    const std::size_t from = page.find("\n| Format | Names |");
    const std::string formats = page.substr(from, page.find("\n\n", from) - from);
    const std::regex kFormat("`([a-z]\\w+)`");
    for (std::sregex_iterator each(formats.begin(), formats.end(), kFormat), end; each != end; ++each)
        EXPECT_TRUE(base::texelFormatNamed((*each)[1].str()))
            << (*each)[1] << ": docs/language.md has this format";
}

TEST(LanguageCommand, ListsTheNamesThatShadersReadWithTheirTypes) {
    const Folder folder;
    const std::string all = glibra(folder.path(), "language").out;
    for (const char* name : {"\nTimer ", "\nuModelViewMatrix ", "\naVertex ", "\nNoise3 ", "\nSphere "})
        EXPECT_NE(all.find(name), std::string::npos) << name;
    const Finished vertex = glibra(folder.path(), "language aVertex");
    EXPECT_EQ(vertex.status, 0);
    EXPECT_NE(vertex.out.find("the position of the vertex"), std::string::npos) << vertex.out;
    EXPECT_NE(vertex.out.find("vec4 vertex input"), std::string::npos) << vertex.out;
    EXPECT_NE(glibra(folder.path(), "language gl_NormalMatrix").out.find("mat3 uniform"), std::string::npos);
    const std::string color = glibra(folder.path(), "language gl_Color").out;  // two meanings
    EXPECT_NE(color.find("vec4 uniform"), std::string::npos) << color;
    EXPECT_NE(color.find("vec4 vertex input"), std::string::npos) << color;
    const Finished near = glibra(folder.path(), "language aVertx");
    EXPECT_EQ(near.status, 2);
    EXPECT_NE(near.err.find("did you mean 'aVertex'?"), std::string::npos) << near.err;
}

TEST(LanguageCommand, TheSampleOfTheReadmeIsAFile) {
    const fs::path root = GLIBRA_SOURCE_DIR;
    const std::string readme = readFile(root / "README.md"),
                      scene = readFile(root / "docs/examples/dots.glib");
    const std::size_t begin = readme.find("\nPerspective 50\n") + 1;
    ASSERT_NE(begin, std::string::npos + 1);
    const std::string sample = readme.substr(begin, readme.find("```", begin) - begin);
    EXPECT_EQ(scene.substr(scene.find("Perspective")), sample);
    const Folder folder;
    EXPECT_EQ(glibra(folder.path(), "check '" + (root / "docs/examples/dots.glib").string() + "'").status, 0);
    EXPECT_NE(readFile(root / "tools/cmake/install.cmake").find("docs/examples"), std::string::npos);
}

TEST(LanguageCommand, ExplainsWordsAfterNamesAndWellKnownNames) {
    const Folder folder;
    for (const char* word :
         {"vST", "prev", "size", "count", "layer", "level", "face", "index", "mvp", "mv_matrix",
          "norm_matrix", "viewPos", "invProj", "vertPos", "aTexCoords", "in_normal"}) {
        const Finished explained = glibra(folder.path(), std::string("language ") + word);
        EXPECT_EQ(explained.status, 0) << word;
        EXPECT_TRUE(contains(explained.out, word) || contains(explained.out, "NAME.")) << explained.out;
    }
    EXPECT_TRUE(contains(glibra(folder.path(), "language mvp").out, "mat4 uniform"));
    EXPECT_TRUE(contains(glibra(folder.path(), "language vertPos").out, "position of the vertex"));
}

TEST(LanguageCommand, ExplainsEveryKindOfWord) {
    const Folder folder;
    for (const auto& [word, part] : std::vector<std::pair<std::string, std::string>>{
             {"mix", "T mix(T a, T b, number t)"},
             {"fov", "camera.fov"},
             {"tick", "tick "},
             {"rgba16f", "texture format, 8 bytes per texel"},
             {"Reflect", "Camera "},
             {"history", "Texture2D "},
             {"camera.view", "from the world to the eye"},
             {"pi", "3.14159"},
             {"EndVertex", "up to EndVertex"},
             {"EndGlsl", "up to EndGlsl"},
             {"glib-E27",
              "error: Nothing of this kind and name is declared before this line.\n  for example: no group"},
             {"memory-W02", "warning: A number does not fit the integers of its buffer."}}) {
        const Finished finished = glibra(folder.path(), "language " + word);
        EXPECT_EQ(finished.status, 0) << word;
        EXPECT_NE(finished.out.find(part), std::string::npos) << word << ": " << finished.out;
    }
    EXPECT_EQ(glibra(folder.path(), "language nothing").status, 2);
    EXPECT_EQ(glibra(folder.path(), "language --words --diagnostics").status, 2);
}

}  // namespace
}  // namespace glibra::test
