// What a frame executes, and what each part of it leaves.

#include <algorithm>
#include <glm/matrix.hpp>

#include "scene_folder.h"
#include "view/debug_view/draw_state.h"
#include "view/debug_view/frame_items.h"
#include "view/debug_view/frame_watch.h"
#include "view/debug_view/mesh_capture.h"
#include "view/debug_view/pixel_probe.h"
#include "view/session/frame_cost.h"
#include "view/session/session.h"

namespace glibra::test {
namespace {

using view::FrameItem;
using view::PixelEvent;
using view::Session;

/// A pass of three overlapping quads into a texture of 16 x 16 with its own depth, and a Fill that shows it.
/// The far quad is drawn last; the middle one is not drawn where x < 0.
const std::string kFrame =
    "WindowSize 40 20\nTexture2D glow 16 16 rgba16f\nCamera eye LookAt 0 0 5  0 0 0  0 1 0  Ortho -1 1 -1 1 "
    "1 10\n"
    "Vertex a.vert\nFragment a.frag\nProgram Flat uColor {1. 0. 0.} uCut <-2. -2. 2.>\n"
    "Fragment show.frag\nProgram Show uImage glow\n"
    "Use Flat\nPass glow clear {0 0 .25 1}\n    QuadXY 0 .5\n"
    "    Set uColor {0. 1. 0.} uCut 0\n    QuadXY 1 1\n"
    "    Set uColor {0. 0. 1.} uCut -2\n    QuadXY -1 1\nEndPass\nFill window with Show\n";
const std::map<std::string, std::string> kFrameFiles{
    {"a.vert",
     "#version 330\nout vec3 vPlace;\nvoid main() { vPlace = aVertex.xyz; gl_Position = "
     "uModelViewProjectionMatrix * "
     "aVertex; }\n"},
    {"a.frag",
     "#version 330\nuniform vec3 uColor; uniform float uCut; in vec3 vPlace; out vec4 c;\n"
     "void main() { if (vPlace.x < uCut) discard; c = vec4(2. * uColor, 1.); }\n"},
    {"show.frag",
     "#version 330\nuniform sampler2D uImage; out vec4 c;\n"
     "void main() { c = texture(uImage, gl_FragCoord.xy / vec2(40., 20.)); }\n"}};

std::string changed(std::string text, std::string_view from, std::string_view to) {
    return text.replace(text.find(from), from.size(), to);
}

class Frame : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
        session.drawIfNeeded();
        ASSERT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
        items = view::frameItems(session.live().scene(), session.live().plan());
    }
    /// The draw in that place among those of the frame.
    std::size_t draw(std::size_t number) {
        for (std::size_t i = 0; i < items.size(); ++i)
            if (items[i].kind == FrameItem::Kind::draw && number-- == 0) return i;
        return 0;
    }
    view::FrameAnswer watch(std::size_t item, std::size_t target = 0) {
        return view::watchFrame(context(), session.live(), items,
                                {session.look().width(), session.look().height(), 0,
                                 std::vector<bool>(items.size(), true), item, target});
    }
    view::PixelHistory history(int x, int y) {
        return view::pixelHistory(context(), session.live(), items, draw(0), session.look().width(),
                                  session.look().height(), 0, {x, y}, 0);
    }

    const SceneFolder folder{kFrame, kFrameFiles};
    Session session{context(), {}};
    std::vector<FrameItem> items;
};

TEST_F(Frame, IsListedInOrder) {
    std::vector<std::string> titles;
    for (const FrameItem& each : items) titles.push_back(each.title);
    EXPECT_EQ(titles, (std::vector<std::string>{"pass into glow", "QuadXY", "QuadXY", "QuadXY",
                                                "pass into window", "Fill"}));
    EXPECT_EQ(items[1].program, "Flat");
    EXPECT_EQ(items[1].place.line, 11);
    ASSERT_EQ(items[1].targets.size(), 3U) << "colour, depth, stencil";
    EXPECT_EQ(items[1].targets[0].name, "glow");
    EXPECT_EQ(items[5].targets[0].name, "window");
    EXPECT_EQ(items[1].key, "draw 0:11:0");
    EXPECT_EQ(items[1].number, 0) << "the only one of its line";
}

TEST_F(Frame, ShowsWhatEachDrawLeft) {
    const std::vector<std::byte> before = pixelsOf(session);
    const view::FrameAnswer first = watch(draw(0)), second = watch(draw(1)), pass = watch(0);
    ASSERT_TRUE(first.content && second.content && pass.content) << first.problem;
    ASSERT_EQ(first.content->width, 16);
    const auto at = [](const view::FrameAnswer& answer, int x, int y) {
        const auto texel = answer.content->at(static_cast<std::size_t>(16 * y + x));
        return std::vector<double>(texel.begin(), texel.end());
    };
    EXPECT_EQ(at(first, 8, 8), (std::vector<double>{2, 0, 0, 1})) << "a float target keeps 2";
    EXPECT_EQ(at(first, 1, 1), (std::vector<double>{0, 0, .25, 1}));
    EXPECT_EQ(at(second, 12, 1), (std::vector<double>{0, 2, 0, 1}));
    EXPECT_EQ(at(second, 1, 1), (std::vector<double>{0, 0, .25, 1})) << "discarded";
    EXPECT_EQ(at(pass, 1, 1), (std::vector<double>{0, 0, 2, 1}));
    EXPECT_EQ(at(pass, 12, 1), (std::vector<double>{0, 2, 0, 1})) << "the far quad is behind";
    ASSERT_EQ(pass.thumbnails.size(), items.size());
    for (const view::FrameThumbnail& each : pass.thumbnails) EXPECT_FALSE(each.rgba.empty());
    EXPECT_EQ(std::count(pass.isExecuted.begin(), pass.isExecuted.end(), true), 6);
    session.setNeedsFrame();
    session.drawIfNeeded();
    EXPECT_TRUE(pixelsOf(session) == before) << "nothing of the scene changes";
}

TEST_F(Frame, ReadsDepthAndWindow) {
    const view::FrameAnswer depth = watch(draw(1), 1);
    ASSERT_TRUE(depth.content) << depth.problem;
    EXPECT_EQ(depth.content->components, 1);
    EXPECT_NEAR(depth.content->at(16 * 1 + 12)[0], 3. / 9, 1e-4) << "4 from the eye, between 1 and 10";
    EXPECT_EQ(depth.content->at(16 * 1 + 1)[0], 1);
    const view::FrameAnswer window = watch(draw(3));
    ASSERT_TRUE(window.content);
    EXPECT_EQ(window.content->width, 40);
    EXPECT_EQ(window.content->at(20 * 40 / 2 + 20)[1], 1) << "green, in bytes";
}

TEST_F(Frame, MarksThePixelsOfADraw) {
    const view::FrameAnswer far = watch(draw(2));
    ASSERT_TRUE(far.mask);
    EXPECT_EQ(far.mask->width, 16);
    EXPECT_EQ(far.mask->passedPixels + far.mask->hiddenPixels, 16U * 16);
    EXPECT_EQ(far.mask->hiddenPixels, 16U * 8 + 4 * 8) << "behind the right half and the small quad";
    EXPECT_EQ(far.mask->pixels[16 * 1 + 1], view::DrawMask::passed);
    EXPECT_EQ(far.mask->pixels[16 * 1 + 12], view::DrawMask::hidden);
}

TEST_F(Frame, TellsTheHistoryOfAPixel) {
    const view::PixelHistory there = history(12, 8);
    EXPECT_EQ(there.problem, "");
    ASSERT_EQ(there.events.size(), 3U) << "the small quad ends at 12";
    EXPECT_EQ(there.untouched, 1U);
    EXPECT_EQ(there.events[0].outcome, PixelEvent::Outcome::begins);
    EXPECT_EQ(there.events[0].after.color, (std::vector<double>{0, 0, .25, 1}));
    EXPECT_EQ(there.events[1].outcome, PixelEvent::Outcome::passed);
    EXPECT_EQ(there.events[1].item, draw(1));
    EXPECT_EQ(there.events[1].fragments, 1U);
    EXPECT_EQ(there.events[1].before.color, (std::vector<double>{0, 0, .25, 1}));
    EXPECT_EQ(there.events[1].after.color, (std::vector<double>{0, 2, 0, 1}));
    ASSERT_TRUE(there.events[1].after.depth);
    EXPECT_NEAR(*there.events[1].after.depth, 3. / 9, 1e-4);
    EXPECT_EQ(there.events[2].outcome, PixelEvent::Outcome::depthFails);
    EXPECT_EQ(there.events[2].after, there.events[1].after);

    const view::PixelHistory left = history(1, 8);
    ASSERT_EQ(left.events.size(), 3U);
    EXPECT_EQ(left.events[1].outcome, PixelEvent::Outcome::discarded);
    EXPECT_EQ(left.events[2].outcome, PixelEvent::Outcome::passed);
    EXPECT_NE(history(99, 0).problem, "");
}

TEST(PixelHistory, TellsStencilAndCulling) {
    const SceneFolder folder(
        "WindowSize 20 20\nCamera eye LookAt 0 0 5  0 0 0  0 1 0  Ortho -1 1 -1 1 1 10\n"
        "Pass window clear {0 0 0 1}\n"
        "    Group\n        State stencil less 1\n        QuadXY 0 1\n    EndGroup\n"
        "    Group\n        State cull front\n        QuadXY 0 1\n    EndGroup\n    QuadXY 0 1\nEndPass\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.drawIfNeeded();
    ASSERT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
    const auto items = view::frameItems(session.live().scene(), session.live().plan());
    const view::PixelHistory found =
        view::pixelHistory(context(), session.live(), items, 0, 20, 20, 0, {10, 10}, 0);
    ASSERT_EQ(found.events.size(), 4U) << found.problem;
    EXPECT_EQ(found.events[1].outcome, PixelEvent::Outcome::stencilFails);
    EXPECT_EQ(found.events[2].outcome, PixelEvent::Outcome::culled);
    EXPECT_EQ(found.events[3].outcome, PixelEvent::Outcome::passed);
    EXPECT_EQ(found.events[3].after.stencil, 0);
}

TEST_F(Frame, ProbesAnyDrawOfAnyPass) {
    const view::ProbedPixel hidden = session.probeDraw(items[draw(2)].step, {12, 1});
    ASSERT_TRUE(hidden.isDrawn);
    EXPECT_TRUE(hidden.isHidden);
    EXPECT_EQ(view::rowOf(hidden), 1);
    ASSERT_NE(hidden.find("c"), nullptr);
    EXPECT_EQ(hidden.find("c")->numbers, (std::vector<double>{0, 0, 2, 1}));
    ASSERT_NE(hidden.find("vPlace"), nullptr);
    EXPECT_NEAR(hidden.find("vPlace")->numbers[0], 2 * 12.5 / 16 - 1, 1e-5);
    EXPECT_EQ(hidden.find("gl_FragCoord")->numbers[1], 1.5);
    const view::ProbedPixel seen = session.probeDraw(items[draw(0)].step, {8, 8});
    ASSERT_TRUE(seen.isDrawn);
    EXPECT_FALSE(seen.isHidden);
    EXPECT_NEAR(seen.depth, 4. / 9, 1e-4);
    EXPECT_EQ(seen.find("uColor")->numbers, (std::vector<double>{1, 0, 0}));
    EXPECT_FALSE(session.probeDraw(items[draw(0)].step, {1, 1}).isDrawn) << "the small quad is not there";
    const std::vector<std::byte> before = pixelsOf(session);
    session.setNeedsFrame();
    session.drawIfNeeded();
    EXPECT_TRUE(pixelsOf(session) == before);
}

TEST_F(Frame, ShowsADebugViewOfOnePass) {
    view::TexelImage numbers;
    const std::size_t pass = items[0].step.pass;
    ASSERT_EQ(session.numbersOfPass(pass, view::DebugView::layers, numbers), "");
    ASSERT_EQ(numbers.width, 16);
    const auto at = [&](int x, int y, int channel) {
        return numbers.rgba[static_cast<std::size_t>(4 * (16 * y + x) + channel)];
    };
    EXPECT_EQ(at(12, 1, 0), 2);
    EXPECT_EQ(at(8, 8, 0), 3);
    EXPECT_EQ(at(1, 1, 0), 1);
    ASSERT_EQ(session.numbersOfPass(pass, view::DebugView::overdraw, numbers), "");
    EXPECT_EQ(at(12, 1, 0), 1) << "the far quad is tested against the depth of the pass";
    ASSERT_EQ(session.numbersOfPass(pass, view::DebugView::depth, numbers), "");
    EXPECT_NEAR(at(1, 1, 1), 6, 1e-3) << "from the eye";
}

TEST(PassView, ShowsAShadowMapWhoseShaderNamesItsInputsItself) {
    const SceneFolder folder(
        "WindowSize 20 20\nCamera eye LookAt 0 0 5  0 0 0  0 1 0  Ortho -1 1 -1 1 1 10\n"
        "Texture2D shadow 16 16 depth24\nVertex depth.vert\nProgram Depth\nFragment show.frag\n"
        "Program Show uImage shadow\nUse Depth\nPass shadow\n    QuadXY 0 .5\nEndPass\nFill window with "
        "Show\n",
        {{"depth.vert",
          "#version 430\nuniform mat4 m_matrix, v_matrix, p_matrix; in vec3 vertPos;\n"
          "void main() { gl_Position = p_matrix * v_matrix * m_matrix * vec4(vertPos, 1.); }\n"},
         {"show.frag",
          "#version 430\nuniform sampler2D uImage; out vec4 c;\nvoid main() { c = texture(uImage, vec2(.5)); "
          "}\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.drawIfNeeded();
    ASSERT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
    view::TexelImage numbers;
    ASSERT_EQ(session.numbersOfPass(0, view::DebugView::layers, numbers), "");
    ASSERT_EQ(numbers.width, 16);
    EXPECT_EQ(numbers.rgba[4 * (16 * 8 + 8)], 1);
    EXPECT_EQ(numbers.rgba[4 * (16 * 1 + 1)], 0);
}

TEST_F(Frame, CapturesTheVerticesOfADraw) {
    const auto stages = view::captureMesh(context(), session.live(), items[draw(1)].step, 40, 20, 0);
    ASSERT_EQ(stages.size(), 2U);
    const view::MeshStage& in = stages[0];
    const view::MeshStage& out = stages[1];
    EXPECT_EQ(in.problem + out.problem, "");
    ASSERT_EQ(in.rows, out.rows) << "each vertex once, in the order of the indices";
    EXPECT_EQ(out.corners, 3);
    EXPECT_EQ(out.rows % 3, 0U);
    ASSERT_GE(in.position, 0);
    const auto numbers = [](const view::MeshStage& stage, const std::string& name, std::size_t row) {
        for (const view::MeshColumn& each : stage.columns)
            if (each.name == name)
                return std::vector<double>(stage.row(row) + each.first,
                                           stage.row(row) + each.first + each.components);
        return std::vector<double>();
    };
    for (std::size_t row = 0; row < in.rows; ++row) {
        const auto vertex = numbers(in, "aVertex", row), clip = numbers(out, "gl_Position", row);
        ASSERT_EQ(vertex.size(), 4U);
        ASSERT_EQ(clip.size(), 4U);
        EXPECT_NEAR(clip[0], vertex[0], 1e-6);
        EXPECT_NEAR(clip[2], 2 * (4. - 1) / 9 - 1, 1e-5) << "the depth of the plane at z = 1";
        EXPECT_EQ(numbers(out, "vPlace", row), (std::vector<double>{vertex[0], vertex[1], vertex[2]}));
    }
    const std::string csv = view::csvOf(out);
    EXPECT_EQ(csv.substr(0, csv.find('\r')),
              "vertex,gl_Position.x,gl_Position.y,gl_Position.z,gl_Position.w,vPlace.x,vPlace.y,vPlace.z");
}

TEST(MeshCapture, ShowsWhatTheGeometryStageMakes) {
    const SceneFolder folder(
        kHead + "Vertex a.vert\nGeometry a.geom\nFragment a.frag\nProgram P\nQuadXY 0 1 1 1\n",
        {{"a.vert", "#version 330\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"},
         {"a.geom",
          "#version 330\nlayout(triangles) in; layout(line_strip, max_vertices = 2) out; out float gEnd;\n"
          "void main() { for (int i = 0; i < 2; ++i) { gEnd = float(i); gl_Position = gl_in[i].gl_Position; "
          "EmitVertex(); } }\n"},
         {"a.frag", "#version 330\nin float gEnd; out vec4 c;\nvoid main() { c = vec4(gEnd); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.drawIfNeeded();
    const auto items = view::frameItems(session.live().scene(), session.live().plan());
    ASSERT_EQ(items.size(), 2U);
    const auto stages = view::captureMesh(context(), session.live(), items[1].step, 40, 40, 0);
    ASSERT_EQ(stages.size(), 3U);
    EXPECT_EQ(stages[1].title, "after the vertex stage");
    EXPECT_EQ(stages[1].rows, 6U);
    EXPECT_EQ(stages[2].title, "after the geometry stage");
    EXPECT_EQ(stages[2].problem, "");
    EXPECT_EQ(stages[2].corners, 2);
    ASSERT_EQ(stages[2].rows, 4U) << "a line for each triangle";
    EXPECT_EQ(stages[2].row(1)[4], 1) << "gEnd";
}

TEST_F(Frame, TellsTheStateOfADraw) {
    const plan::PlannedPass& pass = session.live().plan().passes[0];
    const auto& draw = std::get<plan::PlannedDraw>(pass.steps[0]);
    const auto lines =
        view::stateOf(session.live().scene(), session.live().plan(), draw, session.live().view(), 1);
    const auto value = [&](const std::string& name) {
        for (const view::StateLine& each : lines)
            if (each.name == name) return each.value;
        return std::string("none");
    };
    EXPECT_EQ(value("depth test"), "lequal, writes depth");
    EXPECT_EQ(value("program"), "Flat, line 6");
    EXPECT_EQ(value("model-view"), " 1   0   0   0\n 0   1   0   0\n 0   0   1  -5\n 0   0   0   1");
    const auto& fill = std::get<plan::PlannedDraw>(session.live().plan().passes[1].steps[0]);
    const auto ofFill =
        view::stateOf(session.live().scene(), session.live().plan(), fill, session.live().view(), 2);
    const auto texture = std::find_if(ofFill.begin(), ofFill.end(),
                                      [](const view::StateLine& each) { return each.name == "uImage"; });
    ASSERT_NE(texture, ofFill.end());
    EXPECT_EQ(texture->value, "'glow'");
    EXPECT_TRUE(bool(texture->texture));
}

TEST_F(Frame, TriesAnotherStateForADraw) {
    const std::vector<std::byte> before = pixelsOf(session);
    const auto far = [&]() -> const scene::Draw& {
        return std::get<scene::Draw>(session.live()
                                         .scene()
                                         .frame.passes.at(items[draw(2)].step.pass)
                                         .steps.at(items[draw(2)].step.step));
    };
    base::RasterState always = *far().raster;
    always.depthFunction = base::Comparison::always;
    session.tryState(far(), always);
    session.drawIfNeeded();
    EXPECT_FALSE(pixelsOf(session) == before) << "the far quad is in front now";
    EXPECT_EQ(*far().raster, always);
    EXPECT_EQ(watch(draw(2)).mask->hiddenPixels, 0U);
    EXPECT_NE(session.onlyOnScreen().find("tried"), std::string::npos);
    // It stays while other things change, also when the scene is read again.
    folder.write("a.frag", changed(kFrameFiles.at("a.frag"), "2. *", "3. *"));
    ASSERT_TRUE(session.reload());
    EXPECT_EQ(*far().raster, always);
    session.look().setCamera("eye");
    EXPECT_EQ(*far().raster, always);
    folder.write("a.frag", kFrameFiles.at("a.frag"));
    ASSERT_TRUE(session.reload());
    // A third state is another one than the scene's, not than the second.
    base::RasterState lines = always;
    lines.polygon = base::PolygonMode::line;
    session.tryState(far(), lines);
    ASSERT_EQ(session.trials().states().size(), 1U);
    EXPECT_EQ(session.trials().states().begin()->second.ofScene.depthFunction, base::Comparison::lequal);
    session.tryState(far(), session.trials().states().begin()->second.ofScene);
    EXPECT_TRUE(session.trials().states().empty());
    session.drawIfNeeded();
    EXPECT_TRUE(pixelsOf(session) == before) << "as in the scene";
}

TEST_F(Frame, WhatTheSceneSaysNowCountsMoreThanWhatIsTried) {
    const scene::StepIndex at = items[draw(1)].step;
    const auto near = [&]() -> const scene::Draw& {
        return std::get<scene::Draw>(session.live().scene().frame.passes.at(at.pass).steps.at(at.step));
    };
    base::RasterState wanted = *near().raster;
    wanted.cull = base::Cull::both;
    session.tryState(near(), wanted);
    folder.write("scene.glib", changed(kFrame, "Set uColor {0. 1. 0.} uCut 0", "State depthwrite off"));
    ASSERT_TRUE(session.reload());
    EXPECT_FALSE(near().raster->depthWrite);
    EXPECT_EQ(near().raster->cull, base::Cull::off);
}

TEST_F(Frame, WhatIsTriedGoesWithItsDrawWhenTheSceneIsEdited) {
    // The depth function of each draw of the pass.
    const auto functions = [&] {
        std::vector<base::Comparison> found;
        for (const FrameItem& each : view::frameItems(session.live().scene(), session.live().plan()))
            if (each.title == "QuadXY")
                found.push_back(
                    std::get<scene::Draw>(
                        session.live().scene().frame.passes.at(each.step.pass).steps.at(each.step.step))
                        .raster->depthFunction);
        return found;
    };
    const auto edit = [&](const std::string& text) {
        folder.write("scene.glib", text);
        return session.reload();
    };
    using enum base::Comparison;
    using Functions = std::vector<base::Comparison>;
    const scene::StepIndex at = items[draw(1)].step;
    const auto& middle =
        std::get<scene::Draw>(session.live().scene().frame.passes.at(at.pass).steps.at(at.step));
    base::RasterState wanted = *middle.raster;
    wanted.depthFunction = base::Comparison::always;
    session.tryState(middle, wanted);
    EXPECT_EQ(functions(), (Functions{lequal, always, lequal}));
    // Lines are inserted and removed before it; it is edited, also so that it is no statement for a while.
    ASSERT_TRUE(
        edit(changed(kFrame, "    QuadXY 0 .5\n", "    # A comment.\n    QuadXY 0 .5\n    QuadXY 0 .2\n")));
    EXPECT_EQ(functions(), (Functions{lequal, lequal, always, lequal}));
    ASSERT_TRUE(edit(changed(kFrame, "    QuadXY 0 .5\n", "")));
    EXPECT_EQ(functions(), (Functions{always, lequal}));
    ASSERT_TRUE(edit(changed(kFrame, "    QuadXY 1 1\n", "    QuadX\n")));
    EXPECT_EQ(functions(), (Functions{lequal, lequal}));
    EXPECT_TRUE(session.trials().states().empty());
    ASSERT_TRUE(edit(changed(kFrame, "    QuadXY 1 1\n", "    QuadXY 1 .9\n")));
    EXPECT_EQ(functions(), (Functions{lequal, always, lequal}));
    // The last draw stands on its line now, with the same words and state, but it is another one.
    ASSERT_TRUE(edit(changed(kFrame, "    QuadXY 1 1\n    Set uColor {0. 0. 1.} uCut -2\n", "")));
    EXPECT_EQ(functions(), (Functions{lequal, lequal}));
    ASSERT_TRUE(edit(kFrame));
    EXPECT_EQ(functions(), (Functions{lequal, always, lequal})) << "undone";
}

TEST(StateChoices, AreTheWordsOfTheStatement) {
    const base::RasterState state;
    EXPECT_EQ(view::stateStatement(state, state), "");
    for (const view::StateChoice& each : view::stateChoices()) {
        EXPECT_LT(each.wordOf(state), each.words.size()) << each.key;
        for (std::size_t i = 0; i < each.words.size(); ++i) {
            base::RasterState chosen;
            each.choose(chosen, i);
            EXPECT_EQ(each.wordOf(chosen), i) << each.key;
            if (i == each.wordOf(state)) continue;
            // The language reads the statement as that state.
            const std::string statement = view::stateStatement(state, chosen);
            const SceneFolder folder{
                "Camera eye LookAt 0 0 5  0 0 0  0 1 0  Ortho -1 1 -1 1 1 10\nPass window\n" + statement +
                    "\nQuadXY 0 1\nEndPass\n",
                {}};
            Session session{context(), {}};
            ASSERT_TRUE(session.open(folder.scene()));
            EXPECT_FALSE(hasError(session.diagnostics())) << statement << text(session.diagnostics());
            const auto& steps = session.live().scene().frame.passes.at(0).steps;
            ASSERT_FALSE(steps.empty()) << statement;
            EXPECT_EQ(*std::get<scene::Draw>(steps.at(0)).raster, chosen) << statement;
        }
    }
    base::RasterState biased = state;
    biased.offsetFactor = 1.5;
    biased.offsetUnits = 4;
    biased.cull = base::Cull::front;
    EXPECT_EQ(view::stateStatement(state, biased), "State cull front  offset 1.5 4");
    // What has no word of its own is not said.
    biased.blend[1].isOn = true;
    EXPECT_EQ(view::stateStatement(state, biased), "State cull front  offset 1.5 4");
}

TEST_F(Frame, TimesItsParts) {
    const view::FrameCost cost = view::measureParts(session, context().capabilities());
    ASSERT_EQ(cost.nodes.size(), 2U);
    ASSERT_EQ(cost.draws.size(), 4U);
    EXPECT_EQ(cost.draws[1].step, items[draw(1)].step);
    EXPECT_EQ(cost.frames, 0) << "the whole is not measured";
    for (const view::DrawCost& each : cost.draws)
        EXPECT_LE(each.milliseconds, cost.nodes[each.node].milliseconds + 1e-9);
}

TEST(ProbedText, ShowsMatricesByTheirRows) {
    EXPECT_EQ(view::numbersText({"m", "mat2", {1, 2, 3, 4}}), "1  3\n2  4");
    EXPECT_EQ(view::numbersText({"m", "mat3x2", {1, 2, 3, 4, 5, 6}}), "1  3  5\n2  4  6");
    EXPECT_EQ(view::numbersText({"m", "mat2[2]", {1, 2, 3, 4, 5, 6, 7, 8}}), "1  3\n2  4\n\n5  7\n6  8");
    EXPECT_EQ(view::numbersText({"v", "vec2", {1, 2}}), "1 2");
}

TEST(BeforeAndAfter, KeepsThePictureFromBeforeAnEdit) {
    const SceneFolder folder(kHead + "Color 1 0 0\nQuadXY 0 1\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    EXPECT_EQ(session.pictureBefore(), nullptr);
    folder.write("scene.glib", kHead + "Color 0 1 0\nQuadXY 0 1\n");
    ASSERT_TRUE(session.reload());
    session.drawIfNeeded();
    session.showBefore(true);
    ASSERT_NE(session.shownPicture(), session.picture());
    EXPECT_EQ(view::contentOf(*session.shownPicture(), false).at(20 * 40 + 20)[0], 1) << "red";
    EXPECT_EQ(view::contentOf(*session.picture(), false).at(20 * 40 + 20)[1], 1) << "green";
    // While one types, it stays the picture of what is saved.
    for (const char* each : {"0 0 1", "0 .5 1"}) {
        session.setTexts({{folder.scene(), kHead + "Color " + each + "\nQuadXY 0 1\n"}});
        ASSERT_TRUE(session.reload());
        EXPECT_FALSE(session.showsBefore());
        session.drawIfNeeded();
    }
    session.showBefore(true);
    EXPECT_EQ(view::contentOf(*session.shownPicture(), false).at(20 * 40 + 20)[1], 1) << "green";
}

TEST(BeforeAndAfter, BothPicturesAreOfOneMoment) {
    const std::string head =
        "WindowSize 40 40\nTimer 1\nOrtho -1 1 -1 1 -1 1\nVertex a.vert\nFragment a.frag\n";
    const std::string shader = "#version 330\nout vec4 c;\nvoid main() { c = vec4(Timer, 0., 0., 1.); }\n";
    const SceneFolder folder(head + "Program P\nQuadXY 0 1\n",
                             {{"a.vert", kPlainVertex}, {"a.frag", shader}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.advance(.25);
    session.drawIfNeeded();
    folder.write("a.frag", "// edited\n" + shader);
    ASSERT_TRUE(session.reload());
    session.drawIfNeeded();
    session.advance(.5);
    session.drawIfNeeded();
    session.showBefore(true);
    session.drawIfNeeded();
    EXPECT_FALSE(session.isMoving());
    EXPECT_EQ(pixelOf(session, 20, 20)[0], 64) << "the one after the edit";
    EXPECT_NEAR(view::contentOf(*session.shownPicture(), false).at(20 * 40 + 20)[0], 64. / 255, 1e-3);
    session.showBefore(false);
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 20, 20)[0], 64);
}

}  // namespace
}  // namespace glibra::test
