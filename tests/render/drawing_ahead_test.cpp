// A picture is read while the next one is drawn: it is the same as one that is read at once.

#include <gtest/gtest.h>

#include "modern_text.h"
#include "render/scene_renderer.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

struct Drawn {
    std::vector<std::byte> pixels;
    std::string messages;
    friend bool operator==(const Drawn&, const Drawn&) = default;
};

Drawn drawnOf(const Result<image::Image>& picture) {
    return {picture ? picture->data : std::vector<std::byte>(), text(picture.diagnostics)};
}

/// All pictures, each read at once or while the next one is drawn.
std::vector<Drawn> frames(const SceneFolder& folder, const RenderOptions& options, bool isAhead, int count) {
    render::Stats stats;
    Result<render::SceneRenderer> scene =
        render::SceneRenderer::load(sharedContext(), folder / "scene.glib", options, stats);
    EXPECT_TRUE(scene) << text(scene.diagnostics);
    std::vector<Drawn> all;
    if (!scene) return all;
    const auto timeOf = [](int frame) { return frame * frame * .25; };
    for (int i = 0; i < count; ++i) {
        if (!isAhead) {
            all.push_back(drawnOf(scene->draw(timeOf(i), stats)));
            continue;
        }
        scene->drawAhead(timeOf(i), stats);
        if (i > 0) all.push_back(drawnOf(scene->takeDrawn(stats)));
    }
    if (isAhead) all.push_back(drawnOf(scene->takeDrawn(stats)));
    return all;
}

const std::map<std::string, std::string> kFiles{
    {"a.vert", "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"},
    {"timer.frag",
     "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(Timer, gl_FragCoord.xy / 16., .5); }\n"},
    {"old.frag",
     "#version 330 core\nuniform sampler2D uOld;\nout vec4 f;\nvoid main() {\n"
     "  f = texture(uOld, gl_FragCoord.xy / 16.) * .5 + vec4(.125, gl_FragCoord.x / 64., 0., .1);\n}\n"},
    {"nan.frag",
     "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(Timer > .4 ? 0. / (Timer - Timer) : "
     "Timer); }\n"},
    {"count.comp",
     "#version 430 core\nlayout(local_size_x = 4) in;\nlayout(std430) buffer Sums { float sums[]; };\n"
     "void main() { sums[gl_GlobalInvocationID.x] += .1; }\n"},
    {"sum.frag",
     "#version 430 core\nlayout(std430) readonly buffer Sums { float sums[]; };\nout vec4 f;\n"
     "void main() { f = vec4(sums[0]); }\n"},
    {"sized.frag",
     "#version 330 core\nuniform float uSize;\nout vec4 f;\nvoid main() { f = vec4(uSize); }\n"}};

struct Case {
    const char* name;
    const char* scene;
    RenderOptions options{};
};

std::vector<Case> cases() {
    const char* timer =
        "WindowSize 15 9\nTimer 2\nVertex a.vert\nFragment timer.frag\nProgram P\nQuadXY 0 1\n";
    const char* variable =
        "WindowSize 160 90\nLet size (fract(time))\nFragment sized.frag\n"
        "Program P  uSize size\nFill window with P\n";
    std::vector<Case> all{{"Timer", timer}, {"Variable", variable}};
    RenderOptions options;
    options.alpha = true;
    all.push_back({"Alpha", timer, options});
    options.alpha = false;
    options.floatPixels = true;
    all.push_back({"Floats", timer, options});
    options.floatPixels = false;
    options.samples = 4;
    all.push_back({"Samples", timer, options});
    options.samples = 1;
    options.labels = LabelCorner::topLeft;
    all.push_back({"Labels", variable, options});
    all.push_back({"History",
                   "WindowSize 16 16\nTexture2D old 16 16 rgba8 history\nFragment old.frag\n"
                   "Program P  uOld old.prev\nStep 8\n    Fill old with P\nEndStep\n"
                   "Fragment old.frag\nProgram Q  uOld old\nFill window with Q\n"});
    all.push_back({"Steps",
                   "WindowSize 8 8\nCompute count.comp\nProgram Count\nBuffer Sums float 8\n"
                   "Fragment sum.frag\nProgram Show\nStep 8\n    Dispatch Count 2\n"
                   "EndStep\nFill window with Show\n"});
    return all;
}

TEST(DrawingAhead, GivesThePicturesOfDrawingAndReading) {
    for (const Case& each : cases()) {
        SCOPED_TRACE(each.name);
        const SceneFolder folder(each.scene, kFiles);
        const std::vector<Drawn> now = frames(folder, each.options, false, 6);
        ASSERT_EQ(now.size(), 6U);
        for (const Drawn& one : now) EXPECT_FALSE(one.pixels.empty()) << one.messages;
        EXPECT_NE(now[0].pixels, now[1].pixels) << "frames differ";
        EXPECT_TRUE(frames(folder, each.options, true, 6) == now);
    }
}

TEST(DrawingAhead, ReportsTheErrorsOfEachFrameWithThatFrame) {
    // The third frame needs six steps more.
    const SceneFolder folder(cases().back().scene, kFiles);
    RenderOptions options;
    options.steps = 3;
    const std::vector<Drawn> now = frames(folder, options, false, 4),
                             ahead = frames(folder, options, true, 4);
    EXPECT_EQ(now[0].messages, "");
    EXPECT_NE(now[2].messages.find("memory-E08"), std::string::npos) << now[2].messages;
    EXPECT_TRUE(now[2].pixels.empty());
    EXPECT_TRUE(ahead == now);
}

TEST(DrawingAhead, PaysWhereAnotherDeviceDraws) {
    const SceneFolder folder(cases().front().scene, kFiles);
    render::Stats stats;
    RenderOptions options;
    auto scene = render::SceneRenderer::load(sharedContext(), folder / "scene.glib", options, stats);
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->gainsFromDrawingAhead(), !sharedContext().capabilities().isSoftware);
    options.tileSize = 4;
    scene = render::SceneRenderer::load(sharedContext(), folder / "scene.glib", options, stats);
    ASSERT_TRUE(scene);
    EXPECT_FALSE(scene->gainsFromDrawingAhead()) << "tiles are put together";
}

}  // namespace
}  // namespace glibra::test
