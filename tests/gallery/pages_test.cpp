// The pages of a gallery as text, and what is found out about scenes without drawing them.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <string>

#include "../support/new_folder.h"
#include "gallery/gallery.h"
#include "gallery/gallery_page.h"
#include "source/code_html.h"

namespace glibra::gallery::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHostile = "<img src=x onerror=alert(1)>\"'&{{content}}";

GalleryScene sceneAt(const std::string& path) {
    GalleryScene scene;
    scene.path = path;
    scene.verdict = suite::Verdict::passed;
    return scene;
}

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(GalleryNames, AreUniqueAndPlain) {
    Gallery gallery;
    for (const char* each :
         {"a/b.glib", "a-b.glib", "A/B.glib", "x y/\xc3\xbc<>.glib", "../../etc.glib", ".glib"})
        gallery.scenes.push_back(sceneAt(each));
    gallery.scenes.push_back(sceneAt(std::string(300, 'n') + ".glib"));
    connect(gallery);
    std::set<std::string> names;
    for (const GalleryScene& each : gallery.scenes) {
        EXPECT_TRUE(names.insert(each.name).second) << each.name;
        EXPECT_EQ(
            each.name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_."),
            std::string::npos)
            << each.name;
        EXPECT_FALSE(each.name.starts_with('.')) << each.name;
        EXPECT_LT(each.name.size(), 130U);
        EXPECT_NE(each.name, "");
    }
    EXPECT_EQ(gallery.scenes[0].name, "a-b");
}

TEST(GalleryPages, EverythingOfAStrangerIsText) {
    Gallery gallery;
    gallery.title = kHostile;
    GalleryScene scene = sceneAt(std::string("d/") + "<img src=x>.glib");
    scene.chapters = {kHostile};
    scene.reason = kHostile;
    scene.verdict = suite::Verdict::failed;
    scene.diagnostics = {{Severity::error, "glsl-E01", kHostile, {kHostile, 1, 1}}};
    scene.description.head = {{kHostile}, kHostile, {kHostile}};
    scene.description.controls = {{kHostile, kHostile, Control::Kind::range, {0, .5, 1}, {}},
                                  {"", kHostile, Control::Kind::choice, {7}, {kHostile}}};
    scene.description.sources = {{kHostile, kHostile, kHostile}, {"b", "vertex shader", kHostile}};
    scene.description.keys = {kHostile};
    gallery.scenes.push_back(scene);
    connect(gallery);
    for (const std::string& page : {indexPage(gallery), chaptersPage(gallery), scenePage(gallery, 0)}) {
        EXPECT_EQ(page.find("<img src=x"), std::string::npos) << page;
        EXPECT_EQ(page.find("onerror=alert(1)>"), std::string::npos) << page;
        EXPECT_NE(page.find("&lt;img src=x"), std::string::npos);
        EXPECT_EQ(page.find("http"), page.find("http-equiv")) << "nothing leads out of the site";
    }
}

TEST(GalleryPages, AChapterHasItsScenesInOrder) {
    Gallery gallery;
    for (const char* each : {"b.glib", "a.glib", "c.glib"}) gallery.scenes.push_back(sceneAt(each));
    connect(gallery);
    EXPECT_EQ(chaptersPage(gallery), "");
    EXPECT_EQ(indexPage(gallery).find("chapters.html"), std::string::npos);
    gallery.scenes[0].chapters = {"Book, chapter 10", "Book, chapter 9"};
    gallery.scenes[2].chapters = {"Book, chapter 9"};
    const std::string page = chaptersPage(gallery);
    EXPECT_EQ(countOf(page, "<section"), 2U);
    EXPECT_LT(page.find("chapter 9"), page.find("chapter 10"));
    EXPECT_EQ(countOf(page, "class=\"tile\""), 3U);
    EXPECT_NE(indexPage(gallery).find("href=\"chapters.html\""), std::string::npos);
}

TEST(GalleryPages, ExercisesAndSolutionsNameEachOther) {
    Gallery gallery;
    for (const char* each : {"e/task.glib", "s.glib", "other.glib"}) gallery.scenes.push_back(sceneAt(each));
    gallery.scenes[0].description.solution = "s.glib";
    gallery.scenes[2].description.solution = "missing.glib";
    connect(gallery);
    EXPECT_NE(scenePage(gallery, 0).find("Solution: <a href=\"s.html\">"), std::string::npos);
    EXPECT_NE(scenePage(gallery, 1).find("Exercise: <a href=\"e-task.html\">"), std::string::npos);
    EXPECT_EQ(scenePage(gallery, 2).find("Solution"), std::string::npos);
}

TEST(CodeHtml, HasTheColoursOfBothLanguages) {
    EXPECT_EQ(
        source::codeHtml("uniform vec3 a; // <b>\n#define X 2\n", source::CodeLanguage::glsl),
        "<ol><li data-line=\"1\"><span class=\"keyword\">uniform</span> <span class=\"type\">vec3</span> a; "
        "<span class=\"comment\">// &lt;b&gt;</span></li><li data-line=\"2\"><span "
        "class=\"directive\">#define "
        "X 2</span></li></ol>");
    const std::string scene = source::codeHtml("Fragment inline\nvoid main() {}\nEndFragment\nSphere 1\n",
                                               source::CodeLanguage::glib);
    EXPECT_NE(scene.find("<span class=\"type\">void</span>"), std::string::npos);
    EXPECT_NE(scene.find("<span class=\"keyword\">Sphere</span> <span class=\"number\">1</span>"),
              std::string::npos);
}

class Described : public testing::Test {
  protected:
    Described() { folder = glibra::test::newFolder("gallery"); }
    ~Described() override {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }
    void write(const fs::path& name, const std::string& text) const {
        fs::create_directories((folder / name).parent_path());
        std::ofstream(folder / name) << text;
    }
    [[nodiscard]] Description of(const fs::path& scene) const {
        RenderOptions options;
        options.within = folder / "in";
        const Description found = describe({folder / "in", folder / "in" / scene, options});
        const std::optional<Description> read = parseDescription(toText(found));
        EXPECT_TRUE(read);
        EXPECT_EQ(toText(read.value_or(Description())), toText(found));
        return found;
    }
    fs::path folder;
};

TEST_F(Described, HasControlsSourcesAndSize) {
    write("in/a.glib",
          "# SH001 A ball.\nWindowSize 300 200\nVertex a.vert\nFragment a.frag\n"
          "Program P uKa <0. .5 2.> uOn <true> uTint {1 .5 0} uOne <3.> uNot 7\nSphere\n");
    write("in/a.vert", "#include \"b.glsl\"\nvoid main() {}\n");
    write("in/b.glsl", "float b() { return 1.; }\n");
    write("in/a.frag", "void main() {}\n");
    const Description found = of("a.glib");
    EXPECT_EQ(found.width, 300);
    EXPECT_EQ(found.height, 200);
    ASSERT_EQ(found.controls.size(), 4U);
    EXPECT_EQ(found.controls[0].owner, "P");
    EXPECT_EQ(found.controls[0].numbers, (std::vector<double>{0, .5, 2}));
    EXPECT_EQ(found.controls[1].kind, Control::Kind::truth);
    EXPECT_EQ(found.controls[2].kind, Control::Kind::color);
    EXPECT_EQ(found.controls[3].numbers, (std::vector<double>{0, 3, 3}));
    std::string names;
    for (const SourceText& each : found.sources) names += each.role + ":" + each.name + " ";
    EXPECT_EQ(names, "scene:a.glib vertex shader:a.vert included:b.glsl fragment shader:a.frag ");
    EXPECT_FALSE(found.mayMove);
}

TEST_F(Described, AModernSceneHasVariablesChoicesAndKeys) {
    write("in/m.glib",
          "Let size <0. .5 1.>\nLet show <one two>\nKey k size .7\nTranslate (time) 0 0\nSphere (size)\n");
    const Description found = of("m.glib");
    ASSERT_EQ(found.controls.size(), 2U);
    EXPECT_EQ(found.controls[1].kind, Control::Kind::choice);
    EXPECT_EQ(found.controls[1].words, (std::vector<std::string>{"one", "two"}));
    EXPECT_EQ(found.keys, std::vector<std::string>{"k"});
    EXPECT_TRUE(found.mayMove);
}

TEST_F(Described, NothingOutsideOfTheFolderIsRead) {
    write("secret.frag", "void main() { secret(); }\n");
    write("secret.toml", "solution = \"../in/a.glib\"\n");
    write("in/a.vert", "void main() {}\n");
    fs::create_symlink(folder / "secret.frag", folder / "in/link.frag");
    fs::create_symlink(folder / "secret.toml", folder / "in/c.toml");
    write("in/a.glib", "Vertex a.vert\nFragment ../secret.frag\nProgram P\nSphere\n");
    write("in/b.glib", "Vertex a.vert\nFragment link.frag\nProgram P\nSphere\n");
    write("in/c.glib", "Vertex a.vert\nFragment a.frag\nProgram P\nSphere\n");
    write("in/a.frag", "#include \"../secret.frag\"\n#include \"link.frag\"\nvoid main() {}\n");
    for (const char* each : {"a.glib", "b.glib", "c.glib"})
        EXPECT_EQ(toText(of(each)).find("secret()"), std::string::npos) << each;
    EXPECT_EQ(of("c.glib").solution, "");
    write("in/d.glib", "Sphere\n");
    write("in/d.toml", "solution = \"../../secret.frag\"\n");
    EXPECT_EQ(of("d.glib").solution, "");
    write("in/d.toml", "solution = \"x/../a.glib\"\n");
    EXPECT_EQ(of("d.glib").solution, "a.glib");
}

TEST_F(Described, BrokenAndForeignTextsAreDescribed) {
    write("in/broken.glib", "# A broken scene.\nSphere oops oops\nVertex\n\\\n");
    EXPECT_EQ(of("broken.glib").head.summary, "A broken scene.");
    write("in/bytes.glib", std::string("# \xff\xfe\0x\n", 7));
    EXPECT_LE(of("bytes.glib").sources.size(), 1U);
    for (const char* each : {"", "{", "[]", "{\"rows\": 3}", "null"}) EXPECT_FALSE(parseDescription(each));
}

}  // namespace
}  // namespace glibra::gallery::test
