// A window shows what lasts from frame to frame as a rendered file does.

#include "image/image.h"
#include "render/scene_renderer.h"
#include "scene_folder.h"

namespace glibra::test {
namespace {

const std::filesystem::path kLife = GLIBRA_SOURCE_DIR "/glib/modern/life.glib";
constexpr int kSide = 64;

/// The picture of a file at that time.
std::vector<std::byte> rendered(double time) {
    render::Stats stats;
    RenderOptions options;
    options.width = options.height = kSide;
    auto renderer = render::SceneRenderer::load(context(), kLife, options, stats);
    if (!renderer) return {};
    auto picture = renderer->draw(time, stats);
    return picture ? std::move(picture->data) : std::vector<std::byte>();
}

std::vector<std::byte> shown(view::Session& session, double time) {
    view::Clock clock = session.clock();
    clock.setTime(time);
    session.setClock(clock);
    session.setNeedsFrame();
    session.drawIfNeeded();
    return pixelsOf(session);
}

TEST(SimulationInAWindow, ShowsTheStepsOfItsTime) {
    view::Session session(context(), {});
    ASSERT_TRUE(session.open(kLife)) << text(session.diagnostics());
    session.resize(kSide, kSide);
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

}  // namespace
}  // namespace glibra::test
