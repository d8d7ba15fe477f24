// A window shows what lasts from frame to frame as a rendered file does.

#include "image/image.h"
#include "render/scene_renderer.h"
#include "scene_folder.h"

namespace glibra::test {
namespace {

const std::filesystem::path kLife = GLIBRA_SOURCE_DIR "/glib/modern/life.glib";
constexpr int kSide = 64;

/// The picture of a file at that time.
std::vector<std::byte> rendered(double time, const std::filesystem::path& scene = kLife, int height = kSide,
                                const std::vector<std::string>& set = {}) {
    render::Stats stats;
    RenderOptions options;
    options.width = kSide;
    options.height = height;
    options.set = set;
    auto renderer = render::SceneRenderer::load(context(), scene, options, stats);
    if (!renderer) return {};
    auto picture = renderer->draw(time, stats);
    return picture ? std::move(picture->data) : std::vector<std::byte>();
}

std::vector<std::byte> shown(view::Session& session, double time) {
    session.clock().setTime(time);
    session.setNeedsFrame();
    session.drawIfNeeded();
    return pixelsOf(session);
}

TEST(SimulationInAWindow, ShowsTheStepsOfItsTime) {
    view::Session session(context(), {});
    ASSERT_TRUE(session.open(kLife)) << text(session.diagnostics());
    session.look().resize(kSide, kSide);
    EXPECT_TRUE(session.live().isAnimated());
    const auto start = shown(session, 0);
    const auto later = shown(session, 1.25);
    EXPECT_FALSE(start == later);
    EXPECT_TRUE(shown(session, 0) == start) << "time goes back";
    ASSERT_TRUE(session.reload());
    EXPECT_TRUE(shown(session, 1.25) == later) << "the scene is read again";
    EXPECT_TRUE(start == rendered(0));
    EXPECT_TRUE(later == rendered(1.25));
}

TEST(SimulationInAWindow, WhatLastsFollowsTheSizeOfTheWindow) {
    // Every step adds to what is there, so a texture that is made again needs all steps again.
    const SceneFolder folder(
        "WindowSize 100 90\nTexture2D trail (window.x) (window.y) rgba8 nearest clamp history\n"
        "Fragment add.frag\nProgram Add uBefore trail.prev\nFragment show.frag\nProgram Show uTrail "
        "trail\n"
        "Step 4\n    Fill trail with Add\nEndStep\nFill window with Show\n",
        {{"add.frag",
          "#version 330\nuniform sampler2D uBefore; out vec4 c;\nvoid main() { ivec2 at = "
          "ivec2(gl_FragCoord.xy);\n"
          "c = texelFetch(uBefore, at, 0) + vec4(.1, .004 * vec2(at), 0.); }\n"},
         {"show.frag",
          "#version 330\nuniform sampler2D uTrail; out vec4 c;\n"
          "void main() { c = vec4(texelFetch(uTrail, ivec2(gl_FragCoord.xy), 0).rgb, 1.); }\n"}});
    view::Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    shown(session, 1);
    for (const int height : {kSide, 120, 48}) {
        session.look().resize(kSide, height);
        const auto now = shown(session, 1.25);
        EXPECT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
        EXPECT_TRUE(now == rendered(1.25, folder.scene(), height)) << height;
    }
}

TEST(SimulationInAWindow, ASliderForTheSizeOfWhatLastsBeginsAnew) {
    view::Session session(context(), {});
    ASSERT_TRUE(session.open(kLife)) << text(session.diagnostics());
    session.look().resize(kSide, kSide);
    shown(session, 1);
    for (const double side : {400., 40.}) {
        session.values().set(knobIndex(session, "side"), {side});
        const auto now = shown(session, 1.25);
        EXPECT_TRUE(now == rendered(1.25, kLife, kSide, {"side=" + std::to_string(static_cast<int>(side))}))
            << side;
    }
}

}  // namespace
}  // namespace glibra::test
