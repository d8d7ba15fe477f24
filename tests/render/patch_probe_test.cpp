// The patches of a scene that are captured for the choice of tessellation levels.

#include "render/probe/patch_probe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "render/scene_renderer.h"
#include "scene_text.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

TEST(PatchProbe, GivesEachPatchItsNumberWithinTheWholeDraw) {
    // The stages place the patches of every draw by their number alone.
    std::string text =
        "WindowSize 64 64\nOrtho -1 1 -1 1 -1 1\nVertex v.vert\nTessEvaluation e.tese\nFragment f.frag\n"
        "Program P\nNumPatchVertices 1\nglBegin patches\n";
    constexpr int kPatches = 200;  // of which 64 are captured
    for (int i = 0; i < kPatches; ++i) text += "glVertex 0 0 0\n";
    const SceneFolder folder(
        text + "glEnd\n",
        {{"v.vert", "#version 400 core\nvoid main() { gl_Position = aVertex; }\n"},
         {"e.tese",
          "#version 400 core\nlayout(quads) in;\nvoid main() {\n"
          "  gl_Position = vec4(gl_PrimitiveID + gl_TessCoord.x, gl_TessCoord.y, 0., 256.);\n}\n"},
         {"f.frag", "#version 400 core\nout vec4 c;\nvoid main() { c = vec4(1.); }\n"}});
    render::Stats stats;
    Result<render::InterpretedScene> interpreted = render::interpretFile(folder / "scene.glib", {}, stats);
    ASSERT_TRUE(interpreted) << test::text(interpreted.diagnostics);
    const auto state = render::SceneState::of(sharedContext(), std::move(*interpreted), {}, stats, nullptr);
    ASSERT_TRUE(state) << test::text(state.diagnostics);
    const scene::Scene* scene = &(*state)->conductor.scene;
    render::PatchProbe probe(**state, {0.});
    for (std::size_t pass = 0; pass < scene->frame.passes.size(); ++pass)
        for (std::size_t step = 0; step < scene->frame.passes[pass].steps.size(); ++step) {
            if (!std::holds_alternative<scene::Draw>(scene->frame.passes[pass].steps[step])) continue;
            const auto patches = probe.patches(pass, step, {});
            ASSERT_TRUE(patches);
            ASSERT_EQ(patches->size(), 64U);
            std::set<double> numbers;
            for (const budget::Patch& patch : *patches) {
                ASSERT_EQ(patch.vertices.size(), 6U);
                const auto numberOf = [](const budget::PatchVertex& each) {
                    return std::floor(each.clip.x - each.coordinate.x + .5);
                };
                for (const budget::PatchVertex& each : patch.vertices)
                    EXPECT_EQ(numberOf(each), numberOf(patch.vertices.front()));
                numbers.insert(numberOf(patch.vertices.front()));
            }
            EXPECT_EQ(numbers.size(), patches->size()) << "each patch is another one";
            EXPECT_GE(*numbers.begin(), 0);
            EXPECT_LT(*numbers.rbegin(), kPatches);
        }
}

}  // namespace
}  // namespace glibra::test
