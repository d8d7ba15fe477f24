// Modern scenes in a window: steps and sliders, reloading, keys, cameras, the mouse, buffers, costs.

#include <algorithm>

#include "image/image.h"
#include "plan/buffers.h"
#include "render/scene_renderer.h"
#include "render/simulation/simulation.h"
#include "scene_folder.h"
#include "view/session/frame_cost.h"

namespace glibra::test {
namespace {

using view::Session;

const std::string kStage = "#version 430\nlayout(local_size_x = 1) in;\n";
const std::string kTotal = "layout(std430) buffer sum { float total[]; };\n";
const std::string kReadTotal = "layout(std430) readonly buffer sum { float total[]; };\n";

std::string adds(const std::string& what) {
    return kStage + kTotal + "uniform float uGain, uExtra;\nvoid main() { total[0] += " + what + "; }\n";
}

std::string sumScene(const std::string& rate) {
    return "WindowSize 16 16\nLet gain <0 .25 1>\nLet start <0 0 8>\nBuffer sum float 1\n"
           "Compute init.comp\nProgram Init uStart start\n"
           "Compute add.comp\nProgram Add uGain gain uExtra <0 0 1>\n"
           "Fragment show.frag\nProgram Show\n"
           "Key g gain 0 .5\nKey R restart\n"
           "Once\nDispatch Init 1 1 1\nEndOnce\n"
           "Step " +
           rate + "\nDispatch Add 1 1 1\nEndStep\nFill window with Show\n";
}

const std::map<std::string, std::string> kSumFiles{
    {"init.comp", kStage + kTotal + "uniform float uStart;\nvoid main() { total[0] = uStart; }\n"},
    {"add.comp", adds("uGain + uExtra")},
    {"show.frag",
     "#version 430\n" + kReadTotal + "out vec4 c;\nvoid main() { c = vec4(total[0] / 16., 0, 0, 1); }\n"}};

/// The number that has been summed up at that time.
double sumAt(Session& session, double time) {
    session.clock().pauseAt(time);
    session.setNeedsFrame();
    session.drawIfNeeded();
    const std::vector<double> numbers = session.live().buffers().read({scene::BufferIndex(0)}, 0, 1);
    return numbers.empty() ? -1 : numbers.front();
}

TEST(ImagesInAWindow, AsManyAsTheDriverHasUnits) {
    GLint ofCompute = 0;
    glGetIntegerv(GL_MAX_COMPUTE_IMAGE_UNIFORMS, &ofCompute);
    const int count = std::min({context().capabilities().imageUnits, static_cast<int>(ofCompute), 12});
    std::string textures, uniforms, stores, values;
    for (int i = 0; i < count; ++i) {
        const std::string name = std::to_string(i);
        textures += "Texture2D image" + name + " 1 1 rgba8\n";
        uniforms += "layout(rgba8) uniform writeonly image2D uImage" + name + ";\n";
        stores += "imageStore(uImage" + name + ", ivec2(0), vec4(1, 0, 0, 1));\n";
        values += " uImage" + name + " image" + name;
    }
    const SceneFolder folder("WindowSize 8 8\n" + textures + "Compute a.comp\nProgram Write" + values +
                                 "\nFragment show.frag\nProgram Show uT image" + std::to_string(count - 1) +
                                 "\nDispatch Write 1 1 1\nFill window with Show\n",
                             {{"a.comp", kStage + uniforms + "void main() {\n" + stores + "}\n"},
                              {"show.frag",
                               "#version 330\nuniform sampler2D uT;\nout vec4 c;\nvoid main() { c = "
                               "texelFetch(uT, ivec2(0), 0); }\n"}});
    Session session{context(), {}};
    ASSERT_TRUE(session.open(folder.scene()));
    EXPECT_EQ(text(session.diagnostics()), "");
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 4, 4), (Color{255, 0, 0}));
}

class SumInAWindow : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(session.open(folder.scene()));
        ASSERT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
    }
    const SceneFolder folder{sumScene("10"), kSumFiles};
    Session session{context(), {}};
};

TEST_F(SumInAWindow, StepsGoOnWithTheSlidersAsTheyAre) {
    EXPECT_EQ(sumAt(session, .45), 1) << "4 steps";
    session.values().set(knobIndex(session, "gain"), {.5});
    EXPECT_EQ(sumAt(session, .65), 2) << "a variable that Step reads";
    session.values().set(knobIndex(session, "uExtra"), {1});
    EXPECT_EQ(sumAt(session, .85), 5) << "a slider of a program that only Step runs";
    session.values().set(knobIndex(session, "start"), {4});
    EXPECT_EQ(sumAt(session, .85), 4 + 8 * 1.5) << "Once reads it, so everything begins anew";
}

TEST_F(SumInAWindow, WhatLastsSurvivesAReloadUnlessWhatMakesItHasChanged) {
    sumAt(session, .45);
    session.values().set(knobIndex(session, "gain"), {.5});
    ASSERT_EQ(sumAt(session, .65), 2);
    const auto reloaded = [&] {
        EXPECT_TRUE(session.reload());
        return sumAt(session, .65);
    };
    EXPECT_EQ(reloaded(), 2) << "nothing has changed";
    folder.write("show.frag", "#version 430\n" + kReadTotal +
                                  "out vec4 c;\nvoid main() { c = vec4(0, total[0] / 4., 0, 1); }\n");
    EXPECT_EQ(reloaded(), 2) << "a shader of the frame";
    EXPECT_EQ(pixelOf(session, 8, 8), (std::array<int, 3>{0, 128, 0}));
    folder.write("scene.glib", "# A comment.\nBackground 0 0 1\n" + sumScene("10"));
    EXPECT_EQ(reloaded(), 2) << "statements of the frame, and their lines";
    folder.write("add.comp", adds("2. * uGain + uExtra"));
    EXPECT_EQ(reloaded(), 6) << "the shader of Step: 6 steps again";
    session.values().set(knobIndex(session, "gain"), {.25});
    sumAt(session, .75);
    folder.write("scene.glib", sumScene("20"));
    EXPECT_EQ(reloaded(), 13 * .5) << "another rate";
}

TEST_F(SumInAWindow, KeysSetVariablesAndRestart) {
    EXPECT_EQ(sumAt(session, .45), 1);
    const auto gain = [&] { return session.values().knobs()[knobIndex(session, "gain")].current.front(); };
    EXPECT_TRUE(session.pressKey("g"));
    EXPECT_EQ(gain(), 0) << "the first value, because the slider has none of them";
    EXPECT_TRUE(session.pressKey("G"));
    EXPECT_EQ(gain(), .5);
    EXPECT_TRUE(session.pressKey("g"));
    EXPECT_EQ(gain(), 0) << "after the last one comes the first";
    EXPECT_FALSE(session.pressKey("x"));
    session.pressKey("g");
    EXPECT_TRUE(session.pressKey("r"));
    EXPECT_EQ(session.clock().time(), 0);
    EXPECT_EQ(sumAt(session, 0), 0);
    EXPECT_EQ(sumAt(session, .25), 1) << "the steps so far are forgotten";
}

TEST_F(SumInAWindow, HeldKeysMoveVariablesWithinTheirRanges) {
    folder.write("scene.glib", sumScene("10") +
                                   "Let z <-1 0 1>\nLet speed 2\nKey w held z (z + speed)\n"
                                   "Key s z (z - .75)\n");
    ASSERT_TRUE(session.reload());
    const auto z = [&] { return session.values().knobs()[knobIndex(session, "z")].current.front(); };
    EXPECT_TRUE(session.pressKey("w"));
    EXPECT_EQ(z(), 0) << "a press alone moves nothing, but belongs to the scene";
    session.holdKey("W", .125);
    EXPECT_EQ(z(), .25);
    sumAt(session, .1);
    session.holdKey("w", .25);
    EXPECT_EQ(z(), .75) << "the speed stays the same";
    sumAt(session, .1);
    session.holdKey("w", 1);
    EXPECT_EQ(z(), 1) << "the end of the slider";
    session.holdKey("x", 1);
    sumAt(session, .1);
    for (const double expected : {.25, -.5, -1., -1.}) {
        EXPECT_TRUE(session.pressKey("s"));
        EXPECT_EQ(z(), expected) << "steps stop at the end, too";
        sumAt(session, .1);
        EXPECT_TRUE(session.diagnostics().empty());
    }
}

TEST_F(SumInAWindow, GoesFromStepToStep) {
    sumAt(session, .45);
    session.nextStep();
    session.drawIfNeeded();
    EXPECT_EQ(session.clock().time(), .5);
    EXPECT_FALSE(session.clock().isPlaying());
    ASSERT_EQ(session.live().steps().size(), 1U);
    EXPECT_EQ(session.live().steps()[0].steps, 5);
    EXPECT_EQ(session.live().steps()[0].place.line, 16);
    for (int i = 0; i < 25; ++i) session.nextStep();
    session.drawIfNeeded();
    EXPECT_EQ(session.live().steps()[0].steps, 30);
}

TEST_F(SumInAWindow, CostsAreMeasuredForStepsToo) {
    EXPECT_EQ(sumAt(session, .85), 2);
    const view::FrameCost cost = view::measureFrames(session, context().capabilities(), 3, 0);
    ASSERT_EQ(cost.nodes.size(), 1U);
    EXPECT_EQ(cost.nodes[0].what, "pass into window");
    ASSERT_EQ(cost.blocks.size(), 2U);
    EXPECT_EQ(cost.blocks[0].what, "Step 10");
    EXPECT_EQ(cost.blocks[0].line, 16);
    EXPECT_EQ(cost.blocks[0].runs, 5) << "the last five of eight";
    ASSERT_EQ(cost.blocks[0].nodes.size(), 1U);
    EXPECT_EQ(cost.blocks[0].nodes[0].what, "dispatch of Add");
    EXPECT_EQ(cost.blocks[0].nodes[0].line, 17);
    EXPECT_EQ(cost.blocks[1].what, "Once");
    EXPECT_EQ(cost.blocks[1].runs, 1);
    EXPECT_EQ(sumAt(session, .85), 2) << "the state is the same afterwards";
}

TEST(ModernScene, ReportsAKeyThatKeyboardsDoNotHave) {
    const SceneFolder folder("Let a <0 1 2>\nKey hyper a 1\nKey Space a 2\nKey 5 a 0\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    ASSERT_EQ(session.live().scene().keys.size(), 2U);
    ASSERT_TRUE(hasError(session.diagnostics()));
    EXPECT_EQ(session.diagnostics().front().place.line, 2);
    EXPECT_TRUE(session.pressKey("5"));
    EXPECT_EQ(session.values().knobs()[0].current.front(), 0);
    EXPECT_TRUE(session.pressKey("space"));
    EXPECT_EQ(session.values().knobs()[0].current.front(), 2);
}

const std::string kEye = "LookAt 0 0 5  0 0 0  0 1 0  Perspective 60 .1 100\n";
const std::string kFromTheSide = "LookAt 5 1 0  0 0 0  0 1 0  Ortho -2 2 -2 2 .1 10\n";

std::string twoCameras(const std::string& eye, const std::string& other) {
    return "WindowSize 32 32\nTexture2D small 4 4 rgba8\nFragment show.frag\nProgram Show\n"
           "Camera eye " +
           eye + "Camera other " + other + "Camera mirrored Reflect other 1 0 0 0\n" +
           "Pass small from other clear\nBox 1\nEndPass\nPass window from eye clear {0 0 0 1}\n"
           "Color 1 .5 0\nTranslate .5 0 1\nBox 1 1 2\nEndPass\n";
}

std::vector<std::byte> pictureBy(const std::string& scene, const std::string& camera) {
    const SceneFolder folder(scene,
                             {{"show.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(1); }\n"}});
    Session session(context(), {});
    EXPECT_TRUE(session.open(folder.scene()));
    EXPECT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
    session.look().setCamera(camera);
    EXPECT_EQ(session.look().camera(), camera);
    session.drawIfNeeded();
    return pixelsOf(session);
}

TEST(ModernScene, IsSeenThroughAnyOfItsCameras) {
    const auto own = pictureBy(twoCameras(kEye, kFromTheSide), "");
    const auto other = pictureBy(twoCameras(kEye, kFromTheSide), "other");
    EXPECT_FALSE(own == other);
    EXPECT_TRUE(other == pictureBy(twoCameras(kFromTheSide, kEye), ""));
    EXPECT_TRUE(own == pictureBy(twoCameras(kEye, kFromTheSide), "eye"));
}

TEST(ModernScene, KeepsTheCameraThroughAReloadAndReturnsToItsOwn) {
    const SceneFolder folder(twoCameras(kEye, kFromTheSide),
                             {{"show.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(1); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    const auto own = pixelsOf(session);
    session.look().nextCamera();
    session.look().nextCamera();
    session.look().nextCamera();
    EXPECT_EQ(session.look().camera(), "other") << "eye, mirrored, other";
    session.drawIfNeeded();
    const auto other = pixelsOf(session);
    EXPECT_EQ(session.onlyOnScreen(), "the camera 'other'");
    ASSERT_TRUE(session.reload());
    session.drawIfNeeded();
    EXPECT_TRUE(pixelsOf(session) == other);
    session.look().drag(view::TransformMode::eye, {view::Gesture::rotate, {9, 0}, {32, 32}});
    session.drawIfNeeded();
    EXPECT_FALSE(pixelsOf(session) == other) << "the mouse moves the camera";
    session.look().resetTransforms();
    session.look().nextCamera();
    EXPECT_EQ(session.look().camera(), "");
    session.drawIfNeeded();
    EXPECT_TRUE(pixelsOf(session) == own);
    session.look().setCamera("nobody");
    EXPECT_EQ(session.look().camera(), "");
}

TEST(ModernScene, ReadsTheMouse) {
    const SceneFolder folder(
        "WindowSize 16 16\nOrtho -1 1 -1 1\nColor (mouse.x) (mouse.y) (mouse.down ? 1 : 0)\nQuadXY 0 2\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    ASSERT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 8, 8), (std::array<int, 3>{128, 128, 0}));
    session.setMouse(.2, .6, true);
    EXPECT_TRUE(session.drawIfNeeded());
    EXPECT_EQ(pixelOf(session, 8, 8), (std::array<int, 3>{51, 153, 255}));
    EXPECT_EQ(session.onlyOnScreen(), "the mouse");
    session.setMouse(.2, .6, true);
    EXPECT_FALSE(session.drawIfNeeded());
    const SceneFolder still("WindowSize 16 16\nLet size <0 1 2>\nSphere (size)\n");
    ASSERT_TRUE(session.open(still.scene()));
    session.drawIfNeeded();
    session.setMouse(.3, .3, false);
    EXPECT_FALSE(session.drawIfNeeded()) << "a scene that does not read it stays still";
}

TEST(BufferTable, HasAColumnForEachMember) {
    const SceneFolder folder(
        "WindowSize 8 8\nBuffer Things Thing 300\nCompute fill.comp\nProgram Put\nDispatch Put 300 1 1\n"
        "Fragment show.frag\nProgram Show\nFill window with Show\n",
        {{"fill.comp",
          "#version 430\nlayout(local_size_x = 1) in;\nstruct Thing { vec3 place; uint id; mat2 turn; float "
          "trail[2]; };\n"
          "layout(std430) buffer Things { int count; ivec2 size; Thing all[]; };\n"
          "void main() { uint i = gl_GlobalInvocationID.x; count = 300; size = ivec2(-1, 7);\n"
          "all[i] = Thing(vec3(i, .5, -1), 4000000000u + i, mat2(1, 2, 3, 4), float[2](8., 9.)); }\n"},
         {"show.frag",
          "#version 430\nstruct Thing { vec3 place; uint id; mat2 turn; float trail[2]; };\n"
          "layout(std430) readonly buffer Things { int count; ivec2 size; Thing all[]; };\nout vec4 c;\n"
          "void main() { c = vec4(all[7].place, float(count)); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    ASSERT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
    session.drawIfNeeded();
    const scene::BufferIndex buffer(0);
    const render::DeviceBuffers& buffers = session.live().buffers();
    const plan::BufferLayout* layout = buffers.layout(buffer);
    ASSERT_TRUE(layout);
    const plan::BufferTable table = plan::tableOf(*layout, 60);
    std::string names;
    for (const plan::BufferColumn& each : table.head) names += each.name + " ";
    names += "| ";
    for (const plan::BufferColumn& each : table.columns) names += each.name + " ";
    EXPECT_EQ(names, "count size | place id turn trail[0] trail[1] ");
    EXPECT_EQ(table.elements, 300U);
    const std::size_t size = layout->pattern.element.size();
    ASSERT_EQ(size, 10U);
    const std::vector<double> values = buffers.read({buffer}, layout->pattern.head.size() + 299 * size, size);
    ASSERT_EQ(values.size(), size);
    std::string cells;
    for (const plan::BufferColumn& each : table.columns)
        cells += plan::cellText(std::span(layout->pattern.element).subspan(each.first, each.count),
                                std::span(values).subspan(each.first, each.count)) +
                 " | ";
    EXPECT_EQ(cells, "299 0.5 -1 | 4000000299 | 1 2 3 4 | 8 | 9 | ");
    plan::BufferLayout withoutNames = *layout;
    withoutNames.block.reset();
    const plan::BufferTable plain = plan::tableOf(withoutNames, 60);
    ASSERT_EQ(plain.columns.size(), 3U) << "four numbers each without names";
    EXPECT_EQ(plain.columns[2].count, 2U);
}

TEST(BufferTable, NamesTheMembersOfUniformBlocks) {
    const SceneFolder folder(
        "WindowSize 8 8\nBuffer Light float [1 2 3 9 4 5 6 7]\nFragment show.frag\nProgram Show\n"
        "Fill window with Show\n",
        {{"show.frag",
          "#version 430\nlayout(std140) uniform Light { vec3 place; float power; vec4 color; };\nout vec4 "
          "c;\n"
          "void main() { c = vec4(place * power, 1) + color; }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    ASSERT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
    session.drawIfNeeded();
    const scene::BufferIndex buffer(0);
    const plan::BufferLayout* layout = session.live().buffers().layout(buffer);
    ASSERT_TRUE(layout);
    const plan::BufferTable table = plan::tableOf(*layout, 60);
    std::string names;
    for (const plan::BufferColumn& each : table.head) names += each.name + " ";
    for (const plan::BufferColumn& each : table.columns) names += each.name + " ";
    EXPECT_EQ(names, "place power color ");
}

TEST(ModernScene, TexturesOfTheWindowsSizeFollowIt) {
    const std::filesystem::path scene = GLIBRA_SOURCE_DIR "/glib/start/pass.glib";  // 800 x 600
    Session session(context(), {});
    ASSERT_TRUE(session.open(scene)) << text(session.diagnostics());
    session.drawIfNeeded();
    for (const auto& [width, height] : {std::pair(300, 700), std::pair(900, 200), std::pair(200, 150)}) {
        session.look().resize(width, height);
        session.drawIfNeeded();
        render::Stats stats;
        RenderOptions options;
        options.width = width;
        options.height = height;
        auto renderer = render::SceneRenderer::load(context(), scene, options, stats);
        ASSERT_TRUE(renderer) << text(renderer.diagnostics);
        const auto picture = renderer->draw(0, stats);
        ASSERT_TRUE(picture) << text(picture.diagnostics);
        EXPECT_TRUE(pixelsOf(session) == picture->data) << width << " x " << height;
    }
}

}  // namespace
}  // namespace glibra::test
