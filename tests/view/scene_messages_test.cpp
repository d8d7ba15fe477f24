// The window and `glibra check` report the same about a scene.

#include <set>
#include <tuple>

#include "render/check/scene_check.h"
#include "render/live/live_scene.h"
#include "scene_folder.h"
#include "view/browse/example_scenes.h"

namespace glibra::test {
namespace {

/// Warnings and errors with their places; notes are about single pictures.
std::set<std::string> problemsIn(const Diagnostics& diagnostics) {
    std::set<std::string> problems;
    for (const Diagnostic& each : diagnostics)
        if (each.severity != Severity::note) problems.insert(toString(each));
    return problems;
}

std::set<std::string> shownByWindow(const std::filesystem::path& scene) {
    return problemsIn(render::LiveScene::load(context(), scene, {}, nullptr).diagnostics);
}

std::set<std::string> foundByCheck(const std::filesystem::path& scene) {
    return problemsIn(render::checkScene(context(), scene, {}).diagnostics);
}

/// The window leaves out what it does not need, so it may say less.
void expectNothingElse(const std::filesystem::path& scene) {
    const std::set<std::string> found = foundByCheck(scene);
    for (const std::string& each : shownByWindow(scene)) EXPECT_TRUE(found.contains(each)) << each;
}

TEST(MessagesInAWindow, AreThoseOfCheckForEveryShippedScene) {
    int checked = 0;
    for (const view::ExampleScene& each : view::exampleScenes(GLIBRA_SOURCE_DIR)) {
        // What check finds takes longer than loading, and most scenes have nothing to report.
        if (shownByWindow(each.file).empty()) continue;
        expectNothingElse(each.file);
        ++checked;
    }
    RecordProperty("scenes with messages", checked);
}

TEST(MessagesInAWindow, WhatOnceWritesIsNotReportedAsUnwritten) {
    const std::string textures = "WindowSize 16 16\nTexture2D map 8 8 rgba8\n";
    const std::string programs =
        "Compute fill.comp\nProgram Fill uMap map\nFragment show.frag\nProgram Show uMap map\n";
    const std::map<std::string, std::string> files{
        {"fill.comp",
         "#version 430\nlayout(local_size_x = 1) in;\nlayout(rgba8) writeonly uniform image2D uMap;\n"
         "void main() { imageStore(uMap, ivec2(gl_GlobalInvocationID.xy), vec4(1)); }\n"},
        {"show.frag",
         "#version 430\nuniform sampler2D uMap; out vec4 c;\nvoid main() { c = texture(uMap, vec2(.5)); "
         "}\n"}};
    for (const std::string block : {"Once", "Step 10"}) {
        const SceneFolder written(textures + programs + block + "\nDispatch Fill over map\nEnd" +
                                      block.substr(0, 4) + "\nFill window with Show\n",
                                  files);
        EXPECT_TRUE(shownByWindow(written.scene()).empty()) << *shownByWindow(written.scene()).begin();
        expectNothingElse(written.scene());
    }
    // A texture that nothing writes is still reported, as check does, beside a block that writes another one.
    const SceneFolder unwritten(textures + "Texture2D other 8 8 rgba8\n" +
                                    "Compute fill.comp\nProgram Fill uMap other\nFragment show.frag\n"
                                    "Program Show uMap map\nOnce\nDispatch Fill over other\nEndOnce\n"
                                    "Fill window with Show\n",
                                files);
    EXPECT_EQ(shownByWindow(unwritten.scene()).size(), 1U);
    EXPECT_EQ(shownByWindow(unwritten.scene()), foundByCheck(unwritten.scene()));
}

}  // namespace
}  // namespace glibra::test
