// The list of examples with their pictures, and the list in the file dialog.

#include <algorithm>
#include <chrono>
#include <fstream>

#include "image/read.h"
#include "render/scene_renderer.h"
#include "scene_folder.h"
#include "view/browse/example_scenes.h"
#include "view/edit/edited_file.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;
using view::Thumbnail;

TEST(ExampleScenes, AreAllThatShipWithTheirTopicsAndSummaries) {
    const auto scenes = view::exampleScenes(GLIBRA_SOURCE_DIR);
    ASSERT_GT(scenes.size(), 60U);
    EXPECT_EQ(scenes.front().topic, "start") << "the first topic";
    const auto found = std::find_if(scenes.begin(), scenes.end(),
                                    [](const view::ExampleScene& each) { return each.name == "ovalnoise"; });
    ASSERT_NE(found, scenes.end());
    EXPECT_EQ(found->topic, "patterns");
    EXPECT_EQ(found->summary,
              "OvalNoise: a teapot with elliptical spots whose outlines are shaken by noise.");
    for (const view::ExampleScene& each : scenes) EXPECT_NE(each.summary, "") << each.file;
}

TEST(ExampleScenes, AreFoundFromTheProgramTheSceneOrTheRootsGiven) {
    const SceneFolder folder("");
    for (const char* each : {"mine/glib/a", "mine/shaders", "prefix/share/glibra/glib",
                             "prefix/share/glibra/shaders", "prefix/lib/glibra"})
        fs::create_directories(folder / each);
    const fs::path mine = folder / "mine";
    const fs::path scene = mine / "glib/a/x.glib";
    const fs::path program = folder / "prefix/lib/glibra/glibra-view";
    EXPECT_EQ(view::exampleRoot({mine}, {}, program), mine);
    EXPECT_EQ(view::exampleRoot({mine / "glib"}, scene, program), folder / "prefix/share/glibra");
    EXPECT_EQ(view::exampleRoot({}, scene, "/nowhere/program"), mine);
    EXPECT_EQ(view::exampleRoot({}, {}, "/nowhere/program"), fs::path());
}

constexpr const char* kExampleScene =
    "WindowSize 64 64\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0 .5\n";
std::string includingFragment(const char* color) {
    return std::string("#version 330\n#include \"color.glsl\"\nout vec4 c;\nvoid main() { c = vec4(") +
           color + ", 1.); }\n";
}

TEST(Thumbnails, ShowTheSceneAndAreKept) {
    const SceneFolder folder(kExampleScene, {{"a.vert", kPlainVertex},
                                             {"a.frag", includingFragment("color()")},
                                             {"color.glsl", "vec3 color() { return vec3(1., .5, 0.); }\n"}});
    const fs::path cache = folder / "cache";
    EXPECT_EQ(view::findThumbnail(cache, folder.scene()).state, Thumbnail::State::missing);
    const Thumbnail made = view::makeThumbnail(context(), cache, folder.scene(), {});
    ASSERT_EQ(made.state, Thumbnail::State::ready) << made.problem;
    const auto picture = image::readImage(made.picture);
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width, view::kThumbnailWidth);
    EXPECT_EQ(picture->height, view::kThumbnailHeight);
    const std::byte* middle = picture->row(picture->height / 2).data() + 4 * (picture->width / 2);
    EXPECT_EQ(std::to_integer<int>(middle[0]), 255);
    EXPECT_EQ(std::to_integer<int>(middle[1]), 128);

    EXPECT_EQ(view::findThumbnail(cache, folder.scene()).state, Thumbnail::State::ready);
    fs::last_write_time(folder / "a.vert", fs::file_time_type::clock::now() + std::chrono::hours(1));
    EXPECT_EQ(view::findThumbnail(cache, folder.scene()).state, Thumbnail::State::ready)
        << "only the content matters, not the time";
    folder.write("color.glsl", "vec3 color() { return vec3(0., .5, 0.); }\n");
    fs::last_write_time(folder / "color.glsl", fs::file_time_type::clock::now() + std::chrono::hours(1));
    EXPECT_EQ(view::findThumbnail(cache, folder.scene()).state, Thumbnail::State::missing)
        << "an included file has changed";
}

/// The first three components of every pixel.
std::vector<std::byte> colorsOf(const std::vector<std::byte>& pixels, int components) {
    std::vector<std::byte> colors;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (i % static_cast<std::size_t>(components) < 3) colors.push_back(pixels[i]);
    return colors;
}

TEST(Thumbnails, OfTexturesInTheWindowsSizeAreWhatRenderDraws) {
    const SceneFolder folder("");
    for (const char* name : {"start/pass", "modern/ambient_occlusion", "modern/ink", "modern/glass_lists"}) {
        const fs::path scene = fs::path(GLIBRA_SOURCE_DIR) / "glib" / (std::string(name) + ".glib");
        const Thumbnail made = view::makeThumbnail(context(), folder / "cache", scene, {});
        ASSERT_EQ(made.state, Thumbnail::State::ready) << made.problem;
        const auto thumbnail = image::readImage(made.picture);
        ASSERT_TRUE(thumbnail) << name;
        RenderOptions options;
        options.width = view::kThumbnailWidth;
        options.height = view::kThumbnailHeight;
        render::Stats stats;
        auto renderer = render::SceneRenderer::load(context(), scene, options, stats);
        ASSERT_TRUE(renderer) << text(renderer.diagnostics);
        const auto picture = renderer->draw(0, stats);
        ASSERT_TRUE(picture) << text(picture.diagnostics);
        EXPECT_TRUE(colorsOf(thumbnail->data, thumbnail->components) ==
                    colorsOf(picture->data, picture->components))
            << name;
    }
}

TEST(Thumbnails, OfAWrongSceneAreNotTriedAgainUntilItChanges) {
    const SceneFolder folder(kExampleScene, {{"a.vert", kPlainVertex}, {"a.frag", "void main() { oops }\n"}});
    const fs::path cache = folder / "cache";
    EXPECT_EQ(view::makeThumbnail(context(), cache, folder.scene(), {}).state, Thumbnail::State::failed);
    const Thumbnail known = view::findThumbnail(cache, folder.scene());
    EXPECT_EQ(known.state, Thumbnail::State::failed);
    EXPECT_NE(known.problem.find("a.frag"), std::string::npos) << known.problem;
    folder.write("a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); }\n");
    EXPECT_EQ(view::findThumbnail(cache, folder.scene()).state, Thumbnail::State::missing);
    EXPECT_EQ(view::makeThumbnail(context(), cache, folder.scene(), {}).state, Thumbnail::State::ready);
}

TEST(Thumbnails, ADamagedCacheIsMadeAnew) {
    const SceneFolder folder(
        kExampleScene,
        {{"a.vert", kPlainVertex}, {"a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); }\n"}});
    const fs::path cache = folder / "cache";
    ASSERT_EQ(view::makeThumbnail(context(), cache, folder.scene(), {}).state, Thumbnail::State::ready);
    for (const char* text :
         {"", "{", "[1]", R"({"version": 1, "files": 3})", R"({"version": 1, "files": [{"file": 5}]})"}) {
        for (const auto& each : fs::directory_iterator(cache))
            if (each.path().extension() == ".json") std::ofstream(each.path()) << text;
        EXPECT_EQ(view::findThumbnail(cache, folder.scene()).state, Thumbnail::State::missing) << text;
    }
}

TEST(FolderList, HasFoldersFirstAndOnlyScenes) {
    const SceneFolder folder("");
    for (const char* each : {"b.glib", "A.GLIB", "c.frag", ".hidden.glib"}) folder.write(each, "x");
    for (const char* each : {"Zoo", "apple", ".git"}) fs::create_directory(folder / each);
    const view::FolderList list = view::listFolder(folder / "apple" / "..", ".glib");
    EXPECT_EQ(list.problem, "");
    std::string names;
    for (const view::FolderEntry& each : list.entries) names += each.name + (each.isFolder ? "/ " : " ");
    EXPECT_EQ(names, "apple/ Zoo/ A.GLIB b.glib scene.glib ");
    EXPECT_EQ(list.folder, (folder / "x").parent_path());
    EXPECT_NE(view::listFolder(folder / "none", ".glib").problem, "");
}

}  // namespace
}  // namespace glibra::test
