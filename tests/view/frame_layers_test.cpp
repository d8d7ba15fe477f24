// Passes into several layers of a texture, or faces of a cube map, at once.

#include <array>
#include <map>
#include <string>
#include <vector>

#include "scene_folder.h"
#include "view/debug_view/frame_items.h"
#include "view/debug_view/frame_watch.h"
#include "view/session/session.h"

namespace glibra::test {
namespace {

using view::FrameItem;
using view::PixelEvent;
using view::Session;

/// Two quads in three layers, the second one behind the first; in each layer they are larger: 4, 36 and 64
/// texels, of which the middle one loses its lowest row.
const char* const kLayersScene =
    "WindowSize 20 20\nTexture2DArray stack 8 8 3 rgba8\nCamera eye LookAt 0 0 5  0 0 0  0 1 0  Ortho -1 "
    "1 -1 1 1 10\n"
    "Vertex a.vert\nGeometry a.geom\nFragment a.frag\nProgram Layers\n"
    "Geometry\nFragment show.frag\nProgram Show uImage stack\n"
    "Use Layers\nPass stack clear {0 0 0 1}\n    QuadXY 0 1\n    QuadXY -1 1\nEndPass\n"
    "Fill window with Show\n";
const std::map<std::string, std::string> kLayersFiles{
    {"a.vert", "#version 330\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"},
    {"a.geom",
     "#version 330\nlayout(triangles) in; layout(triangle_strip, max_vertices = 9) out;\n"
     "flat out int vLayer;\n"
     "void main() { for (int i = 0; i < 3; ++i) { for (int k = 0; k < 3; ++k) { gl_Layer = i; vLayer = "
     "i;\n"
     "gl_Position = gl_in[k].gl_Position * vec4(vec2(float(i + 1) / 3.), 1., 1.); EmitVertex(); } "
     "EndPrimitive(); } }\n"},
    {"a.frag",
     "#version 330\nflat in int vLayer; out vec4 c;\n"
     "void main() { if (vLayer == 1 && gl_FragCoord.y < 2.) discard; c = vec4(float(vLayer) / 2., 0., 0., "
     "1.); }\n"},
    {"show.frag",
     "#version 330\nuniform sampler2DArray uImage; out vec4 c;\n"
     "void main() { c = texture(uImage, vec3(gl_FragCoord.xy / 20., 1.)); }\n"}};

TEST(FrameLayers, AreReadOneByOne) {
    const SceneFolder folder{kLayersScene, kLayersFiles};
    Session session{context(), {}};
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.keepTextures();
    session.drawIfNeeded();
    ASSERT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
    const std::vector<FrameItem> items = view::frameItems(session.live().scene(), session.live().plan());
    for (const int layer : {0, 1, 2}) {
        const view::FrameAnswer answer =
            view::watchFrame(context(), session.live(), items,
                             {session.look().width(), session.look().height(), 0,
                              std::vector<bool>(items.size(), true), 1, 0, layer});
        EXPECT_EQ(answer.layers, 3);
        ASSERT_TRUE(answer.content) << answer.problem;
        EXPECT_NEAR(answer.content->at(8 * 4 + 4)[0], layer / 2., .01);
        EXPECT_EQ(answer.layerName, "layer " + std::to_string(layer));
        // The quad is larger in each layer: its pixels, and how many surfaces there are.
        constexpr std::array<std::size_t, 3> kCovered{4, 30, 64};
        const std::size_t covered = kCovered.at(static_cast<std::size_t>(layer));
        ASSERT_TRUE(answer.mask);
        EXPECT_EQ(answer.mask->passedPixels, covered);
        EXPECT_EQ(answer.mask->hiddenPixels, 0U);
        const view::FrameAnswer behind =
            view::watchFrame(context(), session.live(), items,
                             {session.look().width(), session.look().height(), 0,
                              std::vector<bool>(items.size(), true), 2, 0, layer});
        ASSERT_TRUE(behind.mask);
        EXPECT_EQ(behind.mask->passedPixels, 0U);
        EXPECT_EQ(behind.mask->hiddenPixels, covered);
        view::TexelImage numbers;
        ASSERT_EQ(session.numbersOfPass(items[1].step.pass, view::DebugView::layers, numbers, layer), "");
        float surfaces = 0;
        for (std::size_t i = 0; i < numbers.rgba.size(); i += 4) surfaces += numbers.rgba[i];
        EXPECT_EQ(surfaces, static_cast<float>(2 * covered));
    }
}

TEST(FrameLayers, HaveTheirOwnHistoryAndValues) {
    const SceneFolder folder{kLayersScene, kLayersFiles};
    Session session{context(), {}};
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.keepTextures();
    session.drawIfNeeded();
    ASSERT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
    const std::vector<FrameItem> items = view::frameItems(session.live().scene(), session.live().plan());
    ASSERT_EQ(items.size(), 5U);
    // Twice: to look changes nothing.
    for (const int layer : {0, 1, 2, 0, 1, 2}) {
        SCOPED_TRACE(layer);
        const auto history = [&](int x, int y) {
            return view::pixelHistory(context(), session.live(), items, 1, 20, 20, 0, {x, y, layer}, 0);
        };
        const view::PixelHistory middle = history(4, 4);
        ASSERT_EQ(middle.events.size(), 3U) << middle.problem;
        EXPECT_EQ(middle.events[0].outcome, PixelEvent::Outcome::begins);
        EXPECT_EQ(middle.events[1].outcome, PixelEvent::Outcome::passed);
        EXPECT_EQ(middle.events[1].fragments, 1U);
        EXPECT_EQ(middle.events[2].outcome, PixelEvent::Outcome::depthFails);
        EXPECT_EQ(middle.events[2].fragments, 1U);
        ASSERT_TRUE(middle.events[2].after.depth);
        EXPECT_NEAR(*middle.events[2].after.depth, 4. / 9., 1e-5);
        EXPECT_NEAR(middle.events[2].after.color.at(0), layer / 2., .01);

        const view::PixelHistory corner = history(0, 0);
        if (layer == 2) {
            EXPECT_EQ(corner.events.size(), 3U);
        } else {
            EXPECT_EQ(corner.untouched, 2U);
            EXPECT_EQ(corner.events.size(), 1U);
        }

        const view::PixelHistory low = history(4, 1);
        ASSERT_EQ(low.events.size(), layer == 0 ? 1U : 3U);
        if (layer > 0) {
            EXPECT_EQ(low.events[1].outcome,
                      layer == 1 ? PixelEvent::Outcome::discarded : PixelEvent::Outcome::passed);
        }

        const view::ProbedPixel front = session.probeDraw(items[1].step, {4, 4, layer});
        ASSERT_TRUE(front.isDrawn);
        EXPECT_FALSE(front.isHidden);
        EXPECT_NEAR(front.depth, 4. / 9., 1e-5);
        ASSERT_NE(front.find("vLayer"), nullptr);
        EXPECT_EQ(front.find("vLayer")->numbers.at(0), layer);
        const view::ProbedPixel back = session.probeDraw(items[2].step, {4, 4, layer});
        EXPECT_TRUE(back.isDrawn && back.isHidden);
        EXPECT_NEAR(back.depth, 5. / 9., 1e-5);
        EXPECT_EQ(session.probeDraw(items[1].step, {0, 0, layer}).isDrawn, layer == 2);
    }
}

TEST(FrameLayers, OfACubeAreFaces) {
    const SceneFolder folder{
        "WindowSize 20 20\nCubeMap sides 8 rgba8\nCamera eye LookAt 0 0 5  0 0 0  0 1 0  Ortho -1 1 -1 1 "
        "1 "
        "10\nVertex a.vert\nGeometry a.geom\nFragment a.frag\nProgram Layers\n"
        "Pass sides clear {0 0 0 1}\n    QuadXY 0 1\nEndPass\nGeometry\nFragment show.frag\nProgram Show "
        "uImage sides\nFill window with Show\n",
        {{"a.vert", "#version 330\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"},
         {"a.geom",
          "#version 330\nlayout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n"
          "void main() { for (int k = 0; k < 3; ++k) { gl_Layer = 3;\n"
          "gl_Position = gl_in[k].gl_Position; EmitVertex(); } EndPrimitive(); }\n"},
         {"a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); }\n"},
         {"show.frag",
          "#version 330\nuniform samplerCube uImage; out vec4 c;\n"
          "void main() { c = texture(uImage, vec3(0., -1., 0.)); }\n"}}};
    Session session{context(), {}};
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.keepTextures();
    session.drawIfNeeded();
    ASSERT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
    const std::vector<FrameItem> items = view::frameItems(session.live().scene(), session.live().plan());
    for (const int layer : {2, 3}) {
        const view::FrameAnswer answer =
            view::watchFrame(context(), session.live(), items,
                             {session.look().width(), session.look().height(), 0,
                              std::vector<bool>(items.size(), true), 1, 0, layer});
        EXPECT_EQ(answer.layerName, layer == 2 ? "face +y" : "face -y");
        ASSERT_TRUE(answer.mask);
        EXPECT_EQ(answer.mask->passedPixels, layer == 2 ? 0U : 64U);
    }
    for (const int layer : {2, 3}) {
        const view::PixelHistory history =
            view::pixelHistory(context(), session.live(), items, 1, 20, 20, 0, {4, 4, layer}, 0);
        ASSERT_EQ(history.events.size(), layer == 2 ? 1U : 2U) << history.problem;
        EXPECT_EQ(history.events.back().after.color.at(1), layer == 2 ? 0. : 1.);
        EXPECT_EQ(session.probeDraw(items[1].step, {4, 4, layer}).isDrawn, layer == 3);
    }
}

}  // namespace
}  // namespace glibra::test
