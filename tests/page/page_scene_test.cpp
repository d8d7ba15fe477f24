// What a page of a scene is made of, and the page as text.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../support/new_folder.h"
#include "base/files.h"
#include "base/hash.h"
#include "image/read.h"
#include "image/write.h"
#include "page/page.h"
#include "suite/report/report_pictures.h"

namespace glibra::page::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHostile = "</script><img src=x onerror=alert(1)>\"'&{{content}}<!--";

class PageFiles : public testing::Test {
  protected:
    PageFiles() {
        write("course/shaders/q.vert", "#version 330\nvoid main() { gl_Position = vec4(0.); }\n");
        write("course/week/a.frag",
              "#version 330\n#include \"tint.glsl\"\nout vec4 c;\nvoid main() { c = tint(); }\n");
        write("course/week/tint.glsl", "vec4 tint() { return vec4(1.); }\n");
        scene("Vertex q.vert\nFragment a.frag\nProgram P\nSphere 1\n");
    }
    ~PageFiles() override { fs::remove_all(folder_); }
    void write(const std::string& name, std::string_view text) const {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    void scene(const std::string& text) const { write("course/week/a.glib", "# A scene.\n" + text); }
    [[nodiscard]] PageTask task() const {
        PageTask task{folder_ / "course/week/a.glib", {}};
        task.options.within = folder_ / "course/week";
        task.options.libraryRoots = {folder_ / "course"};
        return task;
    }
    std::vector<PageFile> files() {
        problems.clear();
        read.clear();
        return filesOf(task(), read, problems);
    }
    [[nodiscard]] static std::string names(const std::vector<PageFile>& files) {
        std::string text;
        for (const PageFile& each : files) text += each.name + " ";
        return text;
    }
    fs::path folder_ = glibra::test::newFolder("page");
    Diagnostics problems;
    std::vector<fs::path> read;
};

TEST_F(PageFiles, KeepTheirPlacesToEachOther) {
    EXPECT_EQ(names(files()), "shaders/q.vert week/a.frag week/a.glib week/tint.glsl ");
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(read.size(), 4U);
}

TEST_F(PageFiles, OfAnotherLibraryStandWhereThePageLooksForThem) {
    write("library/shaders/r.vert", "#version 330\nvoid main() {}\n");
    fs::remove_all(folder_ / "course/shaders");
    scene("Vertex r.vert\nFragment a.frag\nProgram P\nSphere 1\n");
    PageTask other = task();
    other.options.libraryRoots = {folder_ / "library"};
    EXPECT_EQ(names(filesOf(other, read, problems)),
              "shaders/r.vert week/a.frag week/a.glib week/tint.glsl ");
}

TEST_F(PageFiles, AreNoneFromOutside) {
    write("secret.frag", "theSecret");
    write("course/other/secret.frag", "theSecret");
    fs::create_symlink(folder_ / "secret.frag", folder_ / "course/week/link.frag");
    write("course/week/.hidden/b.frag", "theSecret");
    for (const char* each : {"../../secret.frag", "../other/secret.frag", "link.frag", ".hidden/b.frag"}) {
        scene("Vertex q.vert\nFragment " + std::string(each) + "\nProgram P\nSphere 1\n");
        for (const PageFile& file : files())
            EXPECT_EQ(file.content.find("theSecret"), std::string::npos) << each << ": " << file.name;
    }
}

TEST_F(PageFiles, AreBytesAsTheyAreButForPicturesThatOnlyTheImageModuleReads) {
    image::Image small{3, 2, 3, image::Component::u8, {}};
    for (int i = 0; i < 18; ++i) small.data.push_back(static_cast<std::byte>(13 * i));
    const fs::path week = folder_ / "course/week";
    for (const char* each : {"a.png", "a.jpg", "a.exr"}) {
        const Diagnostics problem = image::writeImage(small, week / each);
        if (hasError(problem)) GTEST_SKIP() << toString(problem.front());
    }
    scene(
        "Texture2D 5 a.png\nTexture2D 6 a.jpg\nTexture2D 7 a.exr\nVertex q.vert\nFragment a.frag\nProgram "
        "P\nSphere 1\n");
    for (const PageFile& each : files()) {
        const fs::path file = folder_ / "course" / each.name;
        std::vector<std::byte> bytes(fs::file_size(file));
        std::ifstream(file, std::ios::binary)
            .read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        const bool isForeign = file.extension() == ".jpg" || file.extension() == ".exr";
        EXPECT_EQ(each.isConverted, isForeign) << each.name;
        if (!isForeign) {
            EXPECT_EQ(each.content, base::asText(bytes)) << each.name;
            continue;
        }
        EXPECT_TRUE(each.content.starts_with(file.extension() == ".jpg" ? "\x89PNG" : "PF\n")) << each.name;
        const auto before = image::decodeImage(bytes, file);
        const auto after = image::decodeImage(std::as_bytes(std::span(each.content)), "x");
        ASSERT_TRUE(before && after) << each.name;
        EXPECT_EQ(before->data, after->data) << each.name;
    }
}

TEST_F(PageFiles, OfFaultyScenesAreThoseThatAreKnown) {
    scene("Vertex q.vert\nFragment none.frag\nSpere\nProgram P\n");
    EXPECT_EQ(names(files()), "shaders/q.vert week/a.glib ");
    fs::remove(folder_ / "course/week/a.glib");
    EXPECT_EQ(names(files()), "");
    EXPECT_TRUE(problems.empty());
}

PageScene hostile() {
    PageScene scene;
    scene.name = std::string(kHostile) + ".glib";
    scene.files = {{scene.name, kHostile, false},
                   {std::string("nul\0\xff.frag", 10), std::string("\0\xff\xfe", 3), true}};
    scene.head.text = {kHostile, "", "1. \xff\x01"};
    scene.head.summary = scene.head.rows.emplace_back(kHostile);
    scene.picture = "\x89PNG no picture";
    scene.width = 4;
    scene.height = 3;
    scene.isLive = true;
    return scene;
}

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin) + begin.size();
    return text.substr(from, text.find(end, from) - from);
}

TEST(Page, WhateverASceneContainsIsData) {
    const std::string page = wholePage(hostile(), {.set = {"uKd=.5"}}, kHostile, "cnVudGltZQ==");
    EXPECT_EQ(countOf(page, "<script"), 3U);
    EXPECT_EQ(countOf(page, "</script"), 3U);
    EXPECT_EQ(countOf(page, "<img"), 1U);
    EXPECT_EQ(countOf(page, "<!--"), 0U);
    EXPECT_EQ(page.find('\0'), std::string::npos);
    const auto data = nlohmann::json::parse(between(page, "id=\"glibra-scene\">", "</script>"));
    EXPECT_EQ(data["scene"], std::string(kHostile) + ".glib");
    EXPECT_EQ(data["files"][1]["bytes"], 3);
    EXPECT_EQ(data["set"][0]["values"][0], .5);
}

TEST(Page, NamesTheHashesOfItsOwnScriptAndStyleAndAllowsNothingElse) {
    const std::string page = wholePage(hostile(), {}, "a", "cnVudGltZQ==");
    const auto hash = [](const std::string& text) {
        return "'sha256-" + suite::base64(base::sha256(std::as_bytes(std::span(text)))) + "'";
    };
    EXPECT_EQ(between(page, "Content-Security-Policy\" content=\"", "\""),
              "default-src 'none'; img-src data: blob:; style-src " +
                  hash(between(page, "<style>", "</style>")) + "; script-src " +
                  hash(between(page, "<script>", "</script>")) +
                  " 'wasm-unsafe-eval'; base-uri 'none'; form-action 'none'");
}

TEST(Page, OfEqualScenesIsEqual) {
    EXPECT_EQ(wholePage(hostile(), {}, "a", "x"), wholePage(hostile(), {}, "a", "x"));
    EXPECT_EQ(sceneScript(hostile(), {}), sceneScript(hostile(), {}));
}

TEST(Page, OfASceneThatIsNotLiveIsAPictureAndSaysWhy) {
    PageScene scene = hostile();
    scene.isLive = false;
    scene.diagnostics.push_back(
        diagnose("web-E01", std::string("no geometry ") + kHostile, {"a.glib", 3, 1}));
    const std::string page = wholePage(scene, {}, "a", "x");
    EXPECT_EQ(countOf(page, "<script"), 0U);
    EXPECT_EQ(countOf(page, "script-src"), 0U);
    EXPECT_NE(page.find("a.glib:3:1: error: no geometry &lt;/script"), std::string::npos);
    EXPECT_NE(page.find("data:image/png;base64,"), std::string::npos);
}

PageScene hostileFilm() {
    PageScene scene = hostile();
    scene.isLive = false;
    scene.diagnostics.push_back(
        diagnose("web-E01", std::string("no stage ") + kHostile, {"/home/me/week/" + scene.name, 3, 1}));
    scene.film.pictures = {"\x89PNG one", std::string(kHostile)};
    scene.film.state =
        nlohmann::json{{"knobs", {{{"name", kHostile}}}},
                       {"files", {{{"name", scene.name}, {"language", "glib"}}, {{"name", 7}}, 3}}}
            .dump();
    return scene;
}

TEST(Page, OfAFilmHasItsPicturesAndNoRuntime) {
    const PageScene scene = hostileFilm();
    ASSERT_TRUE(isFilm(scene));
    const std::string page = wholePage(scene, {}, "a", "");
    EXPECT_EQ(countOf(page, "<script"), 2U);
    EXPECT_EQ(countOf(page, "</script"), 2U);
    EXPECT_EQ(countOf(page, "<img"), 1U);
    EXPECT_EQ(countOf(page, "glibra-runtime\">"), 0U);
    EXPECT_EQ(countOf(between(page, "Content-Security-Policy\" content=\"", "\""), "wasm"), 0U);
    EXPECT_NE(page.find("This is a film, because browsers cannot draw the scene: &lt;/script"),
              std::string::npos);
    EXPECT_EQ(page.find("/home/me"), std::string::npos);  // where the file is on this machine
    const auto data = nlohmann::json::parse(between(page, "id=\"glibra-scene\">", "</script>"));
    EXPECT_EQ(data["film"]["knobs"][0]["name"], kHostile);
    EXPECT_EQ(data["film"]["pictures"].size(), 2U);
    EXPECT_NE(data["film"]["sources"], "");
    EXPECT_EQ(sceneScript(scene, {}).find("</"), std::string::npos);
}

TEST(Page, OfAFilmOutlivesWhatAWorkerSends) {
    PageScene scene = hostileFilm();
    for (const std::string& each :
         {std::string(), std::string("{"), std::string("[]"), std::string("{\"files\":{}}"),
          std::string(1'000'000, '['), "{\"files\":[],\"knobs\":" + std::string(1'000'000, '[')}) {
        scene.film.state = each;
        EXPECT_EQ(countOf(wholePage(scene, {}, "a", ""), "<script"), 2U);
    }
}

TEST(Page, TheScriptHasNothingThatEndsItsElement) {
    const std::string script = runtimeFiles("x")[1].content;
    EXPECT_EQ(script.find("</script"), std::string::npos);
    EXPECT_EQ(script.find("<!--"), std::string::npos);
    EXPECT_EQ(script.find("\nimport "), std::string::npos);
    EXPECT_EQ(script.find("\nexport "), std::string::npos);
}

TEST(PageScene, GoesThroughAPipe) {
    PageScene scene = hostile();
    scene.read = {"/a/b.glib"};
    scene.diagnostics.push_back(diagnose("web-E01", "x", {"a.glib", 3, 7}));
    scene.film = {{"one", std::string("\0\xff", 2)}, "{}", {}, scene.width, scene.height};
    const std::string text = toText(scene);
    const std::optional<PageScene> same = parsePageScene(text);
    ASSERT_TRUE(same);
    EXPECT_EQ(toText(*same), text);
    EXPECT_EQ(same->files[1].content, scene.files[1].content);
    EXPECT_EQ(same->film.pictures, scene.film.pictures);
    EXPECT_EQ(same->film.state, scene.film.state);
    EXPECT_EQ(same->diagnostics[0].place, scene.diagnostics[0].place);
    for (std::size_t length = 0; length < text.size(); ++length)
        EXPECT_FALSE(parsePageScene(text.substr(0, length))) << length;
    EXPECT_FALSE(parsePageScene("none"));
}

TEST(PageRuntime, IsReportedIfItIsMissingAndFoundBesideTheModules) {
    const fs::path folder = glibra::test::newFolder("runtime");
    const auto none = packedRuntime({folder});
    if (none) GTEST_SKIP() << "this build tree has one";
    EXPECT_EQ(none.diagnostics.at(0).id, "page-E01");
    std::ofstream(folder / "glibra.wasm") << "wasm";
    const auto found = packedRuntime({folder});
    fs::remove_all(folder);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->starts_with("H4sI"));  // gzip, in base64
}

}  // namespace
}  // namespace glibra::page::test
