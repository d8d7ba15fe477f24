#include <cmath>
#include <limits>

#include "scene_folder.h"
#include "view/debug_view/texels.h"
#include "view/session/frame_cost.h"

namespace glibra::test {
namespace {

using view::Session;

const std::string kTwoPasses =
    "WindowSize 20 10\nOrtho -1 1 -1 1\nTexture2D 6 8 4 RGBA32F\nRenderToTexture 6\nVertex a.vert\nFragment "
    "float.frag\n"
    "Program Floats\nQuadXY 0 4\nRenderToTexture\nFragment show.frag\nProgram Show uT 6\nQuadXY .5 1\n";
const std::map<std::string, std::string> kFiles{
    {"a.vert", kPlainVertex},
    {"float.frag",
     "#version 330\nout vec4 c;\nvoid main() { c = vec4(gl_FragCoord.xy, -2.5, 1.);\n"
     "if (gl_FragCoord.x < 1.) c.x = sqrt(-gl_FragCoord.x); if (gl_FragCoord.y < 1.) c.y = 1. / "
     "(gl_FragCoord.y - .5); }\n"},
    {"show.frag",
     "#version 330\nuniform sampler2D uT; in vec4 vST; out vec4 c;\nvoid main() { c = vec4(texture(uT, "
     "vST.st).rg / "
     "8., 0., 1.); }\n"}};

TEST(Texels, OfAFloatTargetAreItsNumbers) {
    const SceneFolder folder(kTwoPasses, kFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.drawIfNeeded();
    scene::TextureIndex target;
    for (const scene::TextureIndex each : session.live().scene().textures.indices())
        if (session.live().scene().textures[each].unit == 6) target = each;
    const gpu::Texture* texture = session.live().texture(target);
    ASSERT_TRUE(texture);
    const view::TexelImage image = view::texelsOf(*texture, 0);
    ASSERT_EQ(image.width, 8);
    ASSERT_EQ(image.height, 4);
    const float* texel = image.rgba.data() + 4 * (2 * 8 + 5);
    EXPECT_EQ(texel[0], 5.5F);
    EXPECT_EQ(texel[1], 2.5F);
    EXPECT_EQ(texel[2], -2.5F);
    EXPECT_EQ(view::textureTitle(session.live().scene(), target), "unit 6 / 2D: target, line 3");
    const view::NonFiniteTexels bad = view::countNonFinite(image);
    EXPECT_EQ(bad.nan, 4);
    EXPECT_EQ(bad.infinite, 7);
}

TEST(Texels, OfThePictureAreWhatIsOnTheScreen) {
    const SceneFolder folder("WindowSize 20 10\nOrtho -1 1 -1 1 -1 1\nColor .2 .4 .6\nQuadXY .5 .5\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    const view::TexelImage color = view::colorTexels(*session.picture());
    const float* centre = color.rgba.data() + 4 * (5 * 20 + 10);
    EXPECT_NEAR(centre[0], .2F, .002F);
    EXPECT_NEAR(centre[2], .6F, .002F);
    const view::TexelImage depth = view::depthTexels(*session.picture());
    EXPECT_NEAR(depth.rgba[4 * (5 * 20 + 10)], .25F, 1e-6F);
    EXPECT_EQ(depth.rgba[0], 1.F);
}

TEST(Texels, OfNoiseHaveItsSlices) {
    const SceneFolder folder(
        "WindowSize 16 16\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0 1\n",
        {{"a.vert", kPlainVertex},
         {"a.frag",
          "#version 330\nin vec4 vST; out vec4 c;\nvoid main() { c = texture(Noise3, vST.stp); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    const gpu::Texture* noise = session.live().texture(scene::TextureIndex(1));
    ASSERT_TRUE(noise);
    EXPECT_EQ(view::sliceCount(*noise), 64);
    const view::TexelImage first = view::texelsOf(*noise, 0);
    const view::TexelImage other = view::texelsOf(*noise, 7);
    EXPECT_NE(first.rgba, other.rgba);
    EXPECT_NEAR(first.rgba[0], 127 / 255., 1e-6) << "the noise is 127/255 at lattice points";
    EXPECT_EQ(view::texelsOf(*noise, 9999).rgba, view::texelsOf(*noise, 63).rgba);
}

TEST(Texels, AreShownWithGainAndMarksForWhatIsNoNumber) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    const view::TexelImage image{2, 2, {.25F, .5F, 2, 1, nan, 0, 0, 1, 0, infinite, 0, 1, -1, 0, 0, .5F}};
    const std::vector<std::uint8_t> plain = view::screenBytes(image, {});
    EXPECT_EQ(std::vector(plain.begin(), plain.begin() + 4), (std::vector<std::uint8_t>{64, 128, 255, 255}));
    EXPECT_EQ(plain[4], plain[6]);
    EXPECT_EQ(plain[5], 0) << "magenta";
    EXPECT_EQ(plain[8], 0) << "cyan";
    EXPECT_EQ(plain[9], plain[10]);
    const std::vector<std::uint8_t> green = view::screenBytes(image, {view::Channels::green, .5F});
    EXPECT_EQ(std::vector(green.begin(), green.begin() + 4), (std::vector<std::uint8_t>{64, 64, 64, 255}));
    const std::vector<std::uint8_t> alpha = view::screenBytes(image, {view::Channels::alpha, 1});
    EXPECT_EQ(alpha[12], 128);
}

TEST(FrameCost, CountsFramesDrawsAndVertices) {
    const SceneFolder folder(kTwoPasses, kFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    const std::vector<std::byte> before = pixelsOf(session);
    const view::FrameCost cost = view::measureFrames(session, context().capabilities(), 12, 0);
    EXPECT_EQ(cost.frames, 12);
    EXPECT_GT(cost.millisecondsPerFrame, 0);
    ASSERT_EQ(cost.draws.size(), 2U);
    EXPECT_EQ(cost.draws[0].line, 8);
    ASSERT_EQ(cost.passes.size(), 2U);
    EXPECT_EQ(cost.passes[0].target, "unit 6");
    EXPECT_EQ(cost.passes[0].line, 4);
    EXPECT_EQ(cost.passes[1].target, "window");
    EXPECT_EQ(cost.draws[0].pass, 0);
    EXPECT_EQ(cost.draws[1].pass, 1);
    EXPECT_EQ(cost.passes[0].milliseconds, cost.draws[0].milliseconds);
    EXPECT_GT(cost.passes[0].milliseconds + cost.passes[1].milliseconds, 0);
    EXPECT_EQ(cost.draws[1].line, 12);
    if (cost.counts) {
        EXPECT_EQ(cost.counts->primitives, 2U * 2 * 4 * 4) << "two quads of 4 x 4 cells";
        EXPECT_GE(cost.counts->fragments, 20U * 10 + 8 * 4);
        EXPECT_GE(cost.counts->vertices, 2U * 25);
    }
    session.drawIfNeeded();
    EXPECT_TRUE(pixelsOf(session) == before);
}

}  // namespace
}  // namespace glibra::test
