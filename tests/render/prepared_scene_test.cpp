// A scene that is prepared on another thread while one is drawn gives the same picture, messages and work as
// without.

#include <gtest/gtest.h>

#include <algorithm>
#include <future>
#include <vector>

#include "render/scene_renderer.h"
#include "scene_text.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

struct Seen {
    std::vector<std::byte> pixels;
    std::string messages;
    std::string counts;
    std::string skipped;
    std::vector<std::string> stages;
};

Seen seenOf(Result<render::SceneRenderer> loaded, render::Stats& stats) {
    Seen run;
    run.messages = text(loaded.diagnostics);
    if (loaded) {
        Result<image::Image> picture = loaded->draw(0, stats);
        run.messages += text(picture.diagnostics);
        if (picture) run.pixels = std::move(picture->data);
    }
    for (const render::Stats::Count& each : stats.counts)
        if (!each.name.starts_with(
                "parts of "))  // on a graphics card, as many as the time of a part asks for
            run.counts += each.name + " " + std::to_string(each.value) + "\n";
    for (const plan::Skipped& each : stats.skipped) run.skipped += each.what + ": " + each.why + "\n";
    for (const render::Stats::Stage& each : stats.stages) run.stages.push_back(each.name);
    return run;
}

Seen atOnce(const fs::path& scene, const RenderOptions& options, render::SharedParts* shared = nullptr) {
    render::Stats stats;
    return seenOf(render::SceneRenderer::load(sharedContext(), scene, options, stats, shared), stats);
}

render::PreparedScene prepareElsewhere(const fs::path& scene, const RenderOptions& options,
                                       render::Stats& stats, render::SharedParts* shared = nullptr) {
    gpu::Context& context = sharedContext();
    return std::async(std::launch::async,
                      [&] { return render::SceneRenderer::prepare(context, scene, options, stats, shared); })
        .get();
}

Seen prepared(const fs::path& scene, const RenderOptions& options, render::SharedParts* shared = nullptr) {
    render::Stats stats;
    render::PreparedScene ready = prepareElsewhere(scene, options, stats, shared);
    return seenOf(render::SceneRenderer::load(std::move(ready), stats), stats);
}

void expectTheSame(const fs::path& scene, const RenderOptions& options) {
    const Seen whole = atOnce(scene, options);
    const Seen inParts = prepared(scene, options);
    EXPECT_TRUE(whole.pixels == inParts.pixels) << scene;
    EXPECT_EQ(whole.messages, inParts.messages) << scene;
    EXPECT_EQ(whole.skipped, inParts.skipped) << scene;
}

std::vector<fs::path> shippedScenes() {
    std::vector<fs::path> scenes;
    for (const auto& each : fs::recursive_directory_iterator(fs::path(GLIBRA_SOURCE_DIR) / "glib"))
        if (each.path().extension() == ".glib" &&
            each.path().string().find("/exercises/") == std::string::npos)
            scenes.push_back(each.path());
    std::ranges::sort(scenes);
#if GLIBRA_SANITIZED
    for (std::size_t i = 0; 3 * i < scenes.size(); ++i) scenes[i] = scenes[3 * i];
    scenes.resize((scenes.size() + 2) / 3);
#endif
    return scenes;
}

const std::string kPreparedStart =
    "WindowSize 64 48\nLookAt 0 0 4  0 0 0  0 1 0\nVertex a.vert\nFragment a.frag\n";
const std::map<std::string, std::string> kPreparedFiles{
    {"a.vert",
     "#version 330 core\nout vec3 vST;\nvoid main() { vST = aTexCoord0.stp; gl_Position = "
     "uModelViewProjectionMatrix * aVertex; }\n"},
    {"a.frag",
     "#version 330 core\nin vec3 vST;\nuniform sampler2D uA;\nuniform sampler2D uB;\nuniform sampler2D uC;\n"
     "out vec4 fColor;\nvec4 unused() { return texture(uC, vST.st); }\n"
     "void main() { fColor = texture(uA, vST.st) + vec4(texture(Noise3, vST).rgb, 1.); }\n"},
    {"m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n"},
    {"n.obj", "v 0 0 0\nv 1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 2 8\n"}};

TEST(PreparedScene, OfEveryShippedScriptIsTheSamePictureWithTheSameWork) {
    RenderOptions options;
    options.width = 48;
    options.height = 36;
    for (const fs::path& scene : shippedScenes()) {
        const Seen whole = atOnce(scene, options);
        const Seen inParts = prepared(scene, options);
        ASSERT_FALSE(whole.pixels.empty()) << scene << whole.messages;
        EXPECT_TRUE(whole.pixels == inParts.pixels) << scene;
        EXPECT_EQ(whole.messages, inParts.messages) << scene;
        EXPECT_EQ(whole.skipped, inParts.skipped) << scene;
        EXPECT_EQ(whole.counts, inParts.counts) << scene << ": the samplers were guessed wrongly";
    }
}

TEST(PreparedScene, SaysTheSameOfItsModelsInTheSameOrder) {
    const std::string scene = kPreparedStart +
                              "Texture2D 6 a.bmp\nProgram P uA 6 uB 7\nObj m.obj\nTranslate 0 9 0\nObj "
                              "n.obj\nTranslate 0 -9 0\nObj m.obj\n";
    const SceneFolder folder(scene, kPreparedFiles);
    expectTheSame(folder / "scene.glib", {});
    RenderOptions glman;
    glman.view = ViewPolicy::glman;
    expectTheSame(folder / "scene.glib", glman);
    RenderOptions whole;
    whole.skip = false;
    expectTheSame(folder / "scene.glib", whole);
    EXPECT_NE(atOnce(folder / "scene.glib", {}).messages.find("m.obj"), std::string::npos);
}

TEST(PreparedScene, FailsWithTheSameWords) {
    RenderOptions strict;
    strict.strict = true;
    RenderOptions large;
    large.width = large.height = 60000;
    const SceneFolder folder(kPreparedStart + "Program P uA 6 uQ 1\nTeapot\n", kPreparedFiles);
    expectTheSame(folder / "scene.glib", strict);
    expectTheSame(folder / "scene.glib", large);
    expectTheSame(folder / "nothing.glib", {});
    folder.write("scene.glib",
                 kPreparedStart + "Texture2D 6 nothing.png\nFragment missing.frag\nProgram P uA 6\nTeapot\n");
    expectTheSame(folder / "scene.glib", {});
    folder.write("scene.glib", kPreparedStart + "Sphree 1\nProgram P\nTeapot\n");
    expectTheSame(folder / "scene.glib", {});
    RenderOptions nonsense;
    nonsense.set = {"="};
    expectTheSame(folder / "scene.glib", nonsense);
}

/// A 1 x 1 BMP of 24 bits.
std::string onePixelBmp() {
    std::string file("BM\x3a\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x01\0\0\0\x01\0\0\0\x01\0\x18\0", 30);
    file += std::string("\0\0\0\0\x04\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 24);
    return file + std::string("\x20\x80\xff\0", 4);
}

TEST(PreparedScene, ReadsTheTexturesThatItsShadersSpeakOf) {
    auto files = kPreparedFiles;
    files["a.bmp"] = files["b.bmp"] = files["c.bmp"] = onePixelBmp();
    const SceneFolder folder(
        kPreparedStart +
            "Texture2D 6 a.bmp\nTexture2D 7 b.bmp\nTexture2D 8 c.bmp\nProgram P uA 6 uB 7 uC "
            "8\nTeapot\n",
        files);
    render::Stats stats;
    render::PreparedScene ready = prepareElsewhere(folder / "scene.glib", {}, stats);
    const auto filesRead = [&] {
        return std::ranges::find_if(
                   stats.counts, [](const render::Stats::Count& each) { return each.name == "files read"; })
            ->value;
    };
    EXPECT_EQ(filesRead(), 5U) << "the scene, two shaders, a.bmp and c.bmp";
    const Seen seen = seenOf(render::SceneRenderer::load(std::move(ready), stats), stats);
    EXPECT_EQ(filesRead(), 5U);
    EXPECT_NE(seen.counts.find("\ntextures 2\n"), std::string::npos) << seen.counts;
    EXPECT_TRUE(seen.pixels == atOnce(folder / "scene.glib", {}).pixels);
}

TEST(PreparedScene, MakesNothingThatAnEarlierSceneHas) {
    const SceneFolder folder(kPreparedStart + "Program P\nTeapot\nSphere 1 20 20\n", kPreparedFiles);
    render::SharedParts shared;
    const Seen first = prepared(folder / "scene.glib", {}, &shared);
    const Seen second = prepared(folder / "scene.glib", {}, &shared);
    const auto has = [](const Seen& run, const char* stage) {
        return std::ranges::find(run.stages, stage) != run.stages.end();
    };
    for (const char* each : {"geometry", "noise", "compile"}) {
        EXPECT_TRUE(has(first, each)) << each;
        EXPECT_FALSE(has(second, each)) << each;
    }
    EXPECT_NE(second.counts.find("translations kept 1\n"), std::string::npos) << second.counts;
    EXPECT_TRUE(first.pixels == second.pixels);
}

TEST(PreparedScene, CanBeMadeWhileAnotherIsDrawnWithTheSameParts) {
    RenderOptions options;
    options.width = 40;
    options.height = 30;
    gpu::Context& context = sharedContext();
    render::SharedParts shared;
    const std::vector<fs::path> scenes = shippedScenes();
    std::optional<render::PreparedScene> ready;
    std::vector<render::Stats> stats(scenes.size());
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        std::future<render::PreparedScene> next;
        if (i + 1 < scenes.size())
            next = std::async(std::launch::async, [&, i] {
                return render::SceneRenderer::prepare(context, scenes[i + 1], options, stats[i + 1], &shared);
            });
        Seen run;
        if (ready)
            run = seenOf(render::SceneRenderer::load(std::move(*ready), stats[i]), stats[i]);
        else
            run =
                seenOf(render::SceneRenderer::load(context, scenes[i], options, stats[i], &shared), stats[i]);
        if (next.valid()) ready = next.get();
        const Seen alone = atOnce(scenes[i], options);
        EXPECT_TRUE(run.pixels == alone.pixels) << scenes[i];
        EXPECT_EQ(run.messages, alone.messages) << scenes[i];
    }
}

}  // namespace
}  // namespace glibra::test
