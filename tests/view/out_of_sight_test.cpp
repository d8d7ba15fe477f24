// Objects that reach no pixel are not drawn, and the picture is the same bit for bit.

#include <algorithm>
#include <random>
#include <set>

#include "render/stats.h"
#include "scene_folder.h"
#include "view/session/session.h"

namespace glibra::test {
namespace {

using view::Session;

std::uint64_t countOf(const Session& session, std::string_view name) {
    for (const render::Stats::Count& each : session.live().drawStats().counts)
        if (each.name == name) return each.value;
    return 0;
}

struct FrameNumbers {
    std::vector<std::byte> pixels;
    std::uint64_t draws = 0, leftOut = 0;
};

/// Draws the current frame again.
FrameNumbers frameOf(Session& session, bool everything) {
    session.live().drawOutOfSight(everything);
    session.setNeedsFrame();
    const std::uint64_t draws = countOf(session, "draws");
    const std::uint64_t leftOut = countOf(session, "draws out of their tile");
    session.drawIfNeeded();
    FrameNumbers frame{pixelsOf(session), countOf(session, "draws") - draws,
                       countOf(session, "draws out of their tile") - leftOut};
    session.live().drawOutOfSight(false);
    return frame;
}

constexpr const char* kRow =
    "WindowSize 64 64\nPerspective 60 .1 100\nLookAt 0 0 4 0 0 0 0 1 0\nSphere 1 12 12\nTranslate 20 0 0\n"
    "Sphere 1 12 12\nTranslate -40 0 0\nTorus .2 .5 12 12\nTranslate 20 0 30\nTeapot 4\n";

TEST(OutOfSight, IsNotDrawn) {
    const SceneFolder folder(kRow);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    const FrameNumbers all = frameOf(session, true);
    const FrameNumbers seen = frameOf(session, false);
    EXPECT_EQ(all.draws, 4U);
    EXPECT_EQ(all.leftOut, 0U);
    EXPECT_EQ(seen.draws, 1U) << "two are beside the picture and one behind the eye";
    EXPECT_EQ(seen.leftOut, 3U);
    EXPECT_TRUE(seen.pixels == all.pixels);
}

TEST(OutOfSight, ComesBackWhenTheViewTurnsToIt) {
    const SceneFolder folder(kRow);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.look().resize(96, 64);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> distance(-30, 30);
    std::set<std::uint64_t> counts;
    for (int i = 0; i < 60; ++i) {
        session.look().drag(view::TransformMode::eye,
                            {view::Gesture::rotate, {distance(random), distance(random)}, {96, 64}});
        session.look().drag(view::TransformMode::scene,
                            {view::Gesture::pan, {distance(random), distance(random)}, {96, 64}});
        session.look().setWireframe(i % 3 == 0);
        const FrameNumbers all = frameOf(session, true);
        const FrameNumbers seen = frameOf(session, false);
        EXPECT_TRUE(seen.pixels == all.pixels) << i;
        EXPECT_EQ(seen.draws + seen.leftOut, all.draws);
        counts.insert(seen.draws);
    }
    EXPECT_GE(counts.size(), 3U) << "objects come into sight and leave it";
}

TEST(OutOfSight, IsWhatVerticesGetNotWhatTheModelSays) {
    // The shader moves an object back into the picture that is far to its right.
    const SceneFolder folder(
        "WindowSize 32 32\nOrtho -1 1 -1 1\nVertex back.vert\nFragment a.frag\nProgram P\nTranslate 50 0 0\n"
        "QuadXY 0 1\n",
        {{"back.vert",
          "#version 330\nvoid main() { gl_Position = uModelViewProjectionMatrix * (aVertex - "
          "vec4(50., 0., 0., 0.)); }\n"},
         {"a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(0., 1., 0., 1.); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 16, 16), (std::array<int, 3>{0, 255, 0})) << text(session.diagnostics());
}

TEST(OutOfSight, InATextureIsNotDrawnEither) {
    const SceneFolder folder(
        "WindowSize 32 32\nTexture2D 6 16 16 RGBA8\nOrtho -1 1 -1 1\nRenderToTexture 6\nVertex a.vert\n"
        "Fragment a.frag\nProgram P\nQuadXY 0 1\nTranslate 9 0 0\nQuadXY 0 1\nTranslate -9 0 0\n"
        "RenderToTexture\nFragment show.frag\nProgram S uT 6\nQuadXY 0 1\n",
        {{"a.vert", kPlainVertex},
         {"a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(0., 1., 0., 1.); }\n"},
         {"show.frag",
          "#version 330\nuniform sampler2D uT; in vec4 vST; out vec4 c;\nvoid main() { c = "
          "texture(uT, vST.st); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    const FrameNumbers all = frameOf(session, true);
    Session other(context(), {});  // in a second frame of the same the texture would stand still
    ASSERT_TRUE(other.open(folder.scene())) << text(other.diagnostics());
    const FrameNumbers seen = frameOf(other, false);
    EXPECT_EQ(all.draws, 3U) << text(session.diagnostics());
    EXPECT_EQ(seen.draws, 2U);
    EXPECT_EQ(seen.leftOut, 1U);
    EXPECT_TRUE(seen.pixels == all.pixels);
    EXPECT_EQ(pixelOf(other, 16, 16), (std::array<int, 3>{0, 255, 0}));
    EXPECT_EQ(frameOf(other, false).draws, 1U) << "the texture stands still";
}

TEST(OutOfSight, NormalsThatReachIntoThePictureAreShown) {
    const SceneFolder folder("WindowSize 64 64\nOrtho -1 1 -1 1 -10 10\nRotate 90 0 1 0\nQuadXY -1.01 1\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.look().setDebugView(view::DebugView::normals);
    session.look().setNormalLength(1);
    session.drawIfNeeded();
    const std::vector<std::byte> shown = pixelsOf(session);
    EXPECT_TRUE(
        std::any_of(shown.begin(), shown.end(), [&](std::byte each) { return each != shown.front(); }));
}

TEST(OutOfSight, APickedObjectIsTheSameWhateverIsLeftOutBeforeIt) {
    const SceneFolder folder(
        "WindowSize 64 64\nPerspective 60 .1 100\nLookAt 0 0 4 0 0 0 0 1 0\nTranslate 20 0 0\n"
        "Sphere 1 12 12\nTranslate -20 0 0\nSphere 1 12 12\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.pickAt(32, 32);
    ASSERT_TRUE(session.look().picked());
    EXPECT_EQ(session.look().picked()->draw.line, 7);
    EXPECT_EQ(session.look().picked()->ordinal, 1);
    ASSERT_TRUE(session.reload());
    ASSERT_TRUE(session.look().picked());
    EXPECT_EQ(session.look().picked()->draw.line, 7);
}

}  // namespace
}  // namespace glibra::test
