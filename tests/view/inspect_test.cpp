#include <cmath>
#include <limits>
#include <optional>

#include "render/check/object_content.h"
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
const std::map<std::string, std::string> kPassFiles{
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
    const SceneFolder folder(kTwoPasses, kPassFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.drawIfNeeded();
    scene::TextureIndex target;
    for (const scene::TextureIndex each : session.live().scene().textures.indices())
        if (session.live().scene().textures[each].unit == 6) target = each;
    const gpu::Texture* texture = session.live().texture(target);
    ASSERT_TRUE(texture);
    const auto image = render::contentOf(*texture, 0, std::nullopt);
    ASSERT_TRUE(image);
    ASSERT_EQ(image->width, 8);
    ASSERT_EQ(image->height, 4);
    const auto texel = image->at(2 * 8 + 5);
    EXPECT_EQ(texel[0], 5.5);
    EXPECT_EQ(texel[1], 2.5);
    EXPECT_EQ(texel[2], -2.5);
    EXPECT_EQ(view::textureTitle(session.live().scene(), target), "unit 6 / 2D: target, line 3");
    const view::NonFiniteTexels bad = view::countNonFinite(*image);
    EXPECT_EQ(bad.nan, 4);
    EXPECT_EQ(bad.infinite, 7);
}

TEST(Texels, OfThePictureAreWhatIsOnTheScreen) {
    const SceneFolder folder("WindowSize 20 10\nOrtho -1 1 -1 1 -1 1\nColor .2 .4 .6\nQuadXY .5 .5\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    const auto color = view::contentOf(*session.picture(), false);
    const auto centre = color.at(5 * 20 + 10);
    EXPECT_NEAR(centre[0], .2, .002);
    EXPECT_NEAR(centre[2], .6, .002);
    const auto depth = view::contentOf(*session.picture(), true);
    EXPECT_NEAR(depth.at(5 * 20 + 10)[0], .25, 1e-6);
    EXPECT_EQ(depth.at(0)[0], 1);
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
    EXPECT_EQ(noise->layers(), 64);
    const auto first = render::contentOf(*noise, 0, 0);
    const auto other = render::contentOf(*noise, 0, 7);
    ASSERT_TRUE(first && other);
    EXPECT_EQ(first->size(), 64U * 64);
    EXPECT_NE(first->values, other->values);
    EXPECT_NEAR(first->values[0], 127 / 255., 1e-6) << "the noise is 127/255 at lattice points";
}

TEST(Texels, AreShownInARangeAndWithMarksForWhatIsNoNumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    render::Content image;
    image.width = image.height = 2;
    image.values = {.25, .5, 2, 1, nan, 0, 0, 1, 0, infinite, 0, 1, -1, 0, 0, .5};
    const std::vector<std::uint8_t> plain = view::screenBytes(image, {});
    EXPECT_EQ(std::vector(plain.begin(), plain.begin() + 4), (std::vector<std::uint8_t>{64, 128, 255, 255}));
    EXPECT_EQ(plain[4], plain[6]);
    EXPECT_EQ(plain[5], 0) << "magenta";
    EXPECT_EQ(plain[8], 0) << "cyan";
    EXPECT_EQ(plain[9], plain[10]);
    const std::vector<std::uint8_t> green = view::screenBytes(image, {view::Channels::green, 0, 2});
    EXPECT_EQ(std::vector(green.begin(), green.begin() + 4), (std::vector<std::uint8_t>{64, 64, 64, 255}));
    const std::vector<std::uint8_t> alpha = view::screenBytes(image, {view::Channels::alpha});
    EXPECT_EQ(alpha[12], 128);
    EXPECT_EQ(view::rangeOf(image, view::Channels::rgb), std::pair(-1.0, 2.0));
    EXPECT_EQ(view::rangeOf(image, view::Channels::green), std::pair(0.0, .5)) << "infinity does not count";

    render::Content depth;
    depth.width = 2;
    depth.components = 1;
    depth.values = {.9, .95};
    const auto [low, high] = view::rangeOf(depth, view::Channels::rgb);
    const std::vector<std::uint8_t> grey = view::screenBytes(depth, {view::Channels::rgb, low, high});
    EXPECT_EQ(grey, (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 255, 255}));
}

TEST(Texels, OfNamedTexturesAreThoseOfALevelALayerOrTheResolvedSamples) {
    const SceneFolder folder(
        "WindowSize 16 16\nTexture2D glow 8 8 rgba32f levels 4 generate\n"
        "Texture2DArray sheets 4 4 3 r32f\nTexture2D ids 4 4 r32ui\nTexture2D soft 8 8 rgba8 samples 4\n"
        "Fragment glow.frag\nProgram Glow\nFragment id.frag\nProgram Id\n"
        "Fragment show.frag\nProgram Show uGlow glow uSheets sheets uIds ids uSoft soft\n"
        "Fill glow with Glow\nFill sheets.layer(2) with Glow\nFill ids with Id\nFill soft with Glow\n"
        "Fill window with Show\n",
        {{"glow.frag",
          "#version 330\nout vec4 c;\nvoid main() { c = vec4(floor(gl_FragCoord.x), 3, 0, 1); }\n"},
         {"id.frag", "#version 330\nout uint c;\nvoid main() { c = 4294967290u + uint(gl_FragCoord.x); }\n"},
         {"show.frag",
          "#version 330\nuniform sampler2D uGlow, uSoft; uniform sampler2DArray uSheets; uniform usampler2D "
          "uIds;\n"
          "out vec4 c;\nvoid main() { c = texture(uGlow, vec2(.5)) + texture(uSheets, vec3(.5)) + "
          "texture(uSoft, vec2(.5)) + vec4(texture(uIds, vec2(.5))); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    ASSERT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
    session.drawIfNeeded();
    const auto content = [&](const std::string& name, int level, std::optional<int> layer) {
        const scene::Scene& scene = session.live().scene();
        for (const scene::TextureIndex each : scene.textures.indices())
            if (scene.textures[each].name == name)
                return render::contentOf(*session.live().completed(each, false), level, layer)
                    .value.value_or(render::Content{});
        return render::Content{};
    };
    EXPECT_EQ(content("glow", 0, {}).at(5)[0], 5);
    EXPECT_EQ(content("glow", 1, {}).width, 4);
    EXPECT_EQ(content("glow", 1, {}).at(1)[0], 2.5) << "the mean of 2 and 3";
    EXPECT_EQ(content("glow", 3, {}).at(0)[0], 3.5);
    EXPECT_EQ(content("sheets", 0, 1).at(2)[0], 0);
    EXPECT_EQ(content("sheets", 0, 2).at(2)[0], 2);
    EXPECT_EQ(content("ids", 0, {}).at(3)[0], 4294967293.0) << "integers are exact";
    EXPECT_EQ(content("soft", 0, {}).at(0)[1], 1) << "samples are resolved";
    std::vector<std::string> titles;
    for (const scene::TextureIndex each : session.live().scene().textures.indices())
        titles.push_back(view::textureTitle(session.live().scene(), each));
    EXPECT_EQ(titles[2], "glow: 2D, 8 x 8, rgba32f, line 2");
    EXPECT_EQ(titles[3], "sheets: 2D array, 4 x 4 x 3, r32f, line 3");
    EXPECT_EQ(titles[5], "soft: 2D, 8 x 8, rgba8, 4 samples, line 5");
}

TEST(Texels, OfArraysOf1DTexturesRectanglesAndArraysOfSamples) {
    const SceneFolder folder(
        "WindowSize 16 16\nTexture1DArray rows 8 3 r32f\nTextureRect rect 8 4 r32f\n"
        "Texture2DArray soft 8 4 2 r32f samples 4\n"
        "Fragment x.frag\nProgram X\nFragment show.frag\nProgram Show\n"
        "Fill rows.layer(1) with X\nFill rect with X\nFill soft.layer(1) with X\nFill window with Show\n",
        {{"x.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(floor(gl_FragCoord.x)); }\n"},
         {"show.frag",
          "#version 330\nuniform sampler1DArray rows; uniform sampler2DRect rect; uniform sampler2DArray "
          "soft;\n"
          "out vec4 c;\nvoid main() { c = texture(rows, vec2(.5)) + texture(rect, vec2(1)) + "
          "texture(soft, vec3(.5)); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    ASSERT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
    session.drawIfNeeded();
    const scene::Scene& scene = session.live().scene();
    const auto content = [&](std::size_t texture, std::optional<int> layer) {
        return render::contentOf(*session.live().completed(scene::TextureIndex(texture), false), 0, layer)
            .value.value_or(render::Content{});
    };
    const render::Content row = content(2, 1);
    EXPECT_EQ(std::pair(row.width, row.height), std::pair(8, 1));
    EXPECT_EQ(row.at(5)[0], 5);
    EXPECT_EQ(content(2, 0).at(5)[0], 0);
    EXPECT_EQ(content(3, {}).at(8 + 3)[0], 3);
    EXPECT_EQ(content(4, 1).at(6)[0], 6) << "samples are resolved";
    std::vector<std::string> titles;
    for (const std::size_t each : {2U, 3U, 4U})
        titles.push_back(view::textureTitle(scene, scene::TextureIndex(each)));
    EXPECT_EQ(titles[0], "rows: 1D array, 8 x 3, r32f, line 2");
    EXPECT_EQ(titles[1], "rect: rectangle, 8 x 4, r32f, line 3");
    EXPECT_EQ(titles[2], "soft: 2D array, 8 x 4 x 2, r32f, 4 samples, line 4");
}

TEST(FrameCost, CountsFramesDrawsAndVertices) {
    const SceneFolder folder(kTwoPasses, kPassFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    const std::vector<std::byte> before = pixelsOf(session);
    const view::FrameCost cost = view::measureFrames(session, context().capabilities(), 12, 0);
    EXPECT_EQ(cost.frames, 12);
    EXPECT_GT(cost.millisecondsPerFrame, 0);
    ASSERT_EQ(cost.draws.size(), 2U);
    EXPECT_EQ(cost.draws[0].line, 8);
    ASSERT_EQ(cost.nodes.size(), 2U);
    EXPECT_EQ(cost.nodes[0].what, "pass into unit 6");
    EXPECT_EQ(cost.nodes[0].line, 4);
    EXPECT_EQ(cost.nodes[1].what, "pass into window");
    EXPECT_EQ(cost.draws[0].node, 0U);
    EXPECT_EQ(cost.draws[1].node, 1U);
    EXPECT_TRUE(cost.isTimed);
    EXPECT_LE(cost.nodes[0].milliseconds + cost.nodes[1].milliseconds, cost.millisecondsOfParts)
        << "passes are parts of the frame";
    EXPECT_GT(cost.nodes[0].milliseconds + cost.nodes[1].milliseconds, 0);
    for (const view::DrawCost& each : cost.draws)
        EXPECT_LE(each.milliseconds, cost.nodes[each.node].milliseconds) << "a draw is a part of its pass";
    EXPECT_TRUE(cost.blocks.empty());
    EXPECT_EQ(cost.draws[1].line, 12);
    if (cost.counts) {
        EXPECT_EQ(cost.counts->primitives, 2U * 2 * 4 * 4) << "two quads of 4 x 4 cells";
        // The pixels of both quads. Mesa 22 also counts other ones of the blocks that they touch.
        EXPECT_GE(cost.counts->fragments, 10U * 10 + 8 * 4);
        EXPECT_GE(cost.counts->vertices, 2U * 25);
    }
    session.drawIfNeeded();
    EXPECT_TRUE(pixelsOf(session) == before);
}

TEST(FrameCost, IsEstimatedWithoutATimer) {
    const SceneFolder folder(kTwoPasses, kPassFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    gpu::Capabilities none = context().capabilities();
    none.timerBits = 0;
    const view::FrameCost cost = view::measureFrames(session, none, 3, 0);
    EXPECT_FALSE(cost.isTimed);
    EXPECT_TRUE(cost.isEstimate);
    EXPECT_GT(cost.millisecondsPerFrame, 0) << "real time needs no timer";
    ASSERT_EQ(cost.draws.size(), 2U);
    ASSERT_EQ(cost.nodes.size(), 2U);
    for (const view::DrawCost& each : cost.draws) {
        EXPECT_GT(each.milliseconds, 0);
        EXPECT_LE(each.milliseconds, cost.nodes[each.node].milliseconds);
    }
    EXPECT_LE(cost.nodes[0].milliseconds + cost.nodes[1].milliseconds, cost.millisecondsOfParts);
}

TEST(FrameCost, RoundsEstimatesToTwoDigitsAndCutsParts) {
    view::FrameCost cost;
    cost.millisecondsOfParts = 12.349;
    EXPECT_EQ(view::decimalsOf(cost), 3);
    EXPECT_EQ(view::millisecondsText(12.349, 3), "12.349");
    cost.isEstimate = true;
    EXPECT_EQ(view::decimalsOf(cost), 0);
    cost.millisecondsOfParts = 1.249;
    EXPECT_EQ(view::decimalsOf(cost), 1);
    EXPECT_EQ(view::millisecondsText(1.249, 1), "1.2");
    EXPECT_EQ(view::millisecondsText(.68, 1), "0.6") << "0.6 and 0.5 do not exceed 1.2";
    EXPECT_EQ(view::millisecondsText(.04, 1), "< 0.1");
    EXPECT_EQ(view::millisecondsText(0, 1), "0.0");
}

}  // namespace
}  // namespace glibra::test
