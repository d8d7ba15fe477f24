// Frames allocate nothing on the heap. The driver's malloc calls are not counted.

#include "../support/counted_allocations.h"
#include "scene_folder.h"

namespace glibra::test {
namespace {

using view::Session;

const std::string kMovingScene =
    "WindowSize 64 64\nPerspective 60 .1 100\nLookAt 0 0 4 0 0 0 0 1 0\nTexture2D 6 32 32 RGBA8\n"
    "RenderToTexture 6\nVertex a.vert\nFragment a.frag\nProgram Into uScale <0 1 2>\nSphere 1 12 12\n"
    "RenderToTexture\nFragment show.frag\nProgram Show uT 6 uScale <0 1 2>\nSphere 1 12 12\nTranslate 1 0 0\n"
    "Rotate 30 0 1 0\nTorus .2 .5 12 12\n";
const std::map<std::string, std::string> kMovingFiles{
    {"a.vert",
     "#version 330\nout vec4 vST; out vec3 vN; uniform float uScale;\nvoid main() { vST = aTexCoord0; vN = "
     "uNormalMatrix * aNormal;\ngl_Position = uModelViewProjectionMatrix * vec4(aVertex.xyz * uScale * (1. + "
     ".1 * "
     "sin(6.28 * Timer)), 1.); }\n"},
    {"a.frag",
     "#version 330\nin vec4 vST; in vec3 vN; out vec4 c;\nvoid main() { c = vec4(abs(vN), 1.) * Timer; }\n"},
    {"show.frag",
     "#version 330\nuniform sampler2D uT; in vec4 vST; in vec3 vN; out vec4 c;\nvoid main() { c = "
     "texture(uT, vST.st) "
     "+ vec4(abs(vN), 1.) * Timer; }\n"}};

std::uint64_t allocationsOfFrames(Session& session, int frames) {
    const std::uint64_t before = allocations;
    for (int i = 0; i < frames; ++i) {
        session.advance(1 / 60.);
        session.drawIfNeeded();
    }
    return allocations - before;
}

TEST(Allocations, OfAMovingScenesFramesAreNone) {
    if (!GLIBRA_COUNTS_ALLOCATIONS) GTEST_SKIP() << "the sanitizer has its own operator new";
    const SceneFolder folder(kMovingScene, kMovingFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.look().resize(320, 200);
    session.look().setAxes(true);
    EXPECT_GT(allocationsOfFrames(session, 1), 0U) << "the first frame allocates";
    ASSERT_TRUE(session.isMoving());
    allocationsOfFrames(session, 4);
    const std::uint64_t framesBefore = session.framesDrawn();
    EXPECT_EQ(allocationsOfFrames(session, 100), 0U);
    EXPECT_EQ(session.framesDrawn(), framesBefore + 100);

    session.pickAt(160, 100);
    ASSERT_TRUE(session.look().picked());
    session.look().drag(view::TransformMode::object, {view::Gesture::rotate, {10, 5}, {320, 200}});
    ASSERT_FALSE(session.look().view().objects.empty());
    allocationsOfFrames(session, 4);
    EXPECT_EQ(allocationsOfFrames(session, 100), 0U) << "with a transformed object";
}

}  // namespace
}  // namespace glibra::test
