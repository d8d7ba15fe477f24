// Which passes of a modern scene are needed, and which texture a sampler reads.

#include <gtest/gtest.h>

#include <algorithm>

#include "by_hand.h"
#include "plan/needs.h"
#include "plan/texture_binding.h"

namespace glibra::plan {
namespace {

using base::TexelFormat;
using scene::TextureTarget;
using scene::TextureView;
using test::SceneByHand;

scene::TextureIndex named(SceneByHand& hand, const std::string& name, TexelFormat format = TexelFormat::rgba8,
                          TextureTarget target = TextureTarget::texture2D) {
    scene::Texture texture;
    texture.target = target;
    texture.source = scene::EmptySource{16, 16, target == TextureTarget::texture2D ? 1 : 4, format};
    texture.name = name;
    texture.place = test::at(1);
    return hand.scene.textures.add(texture);
}

/// A scene with a program of one sampler; draws of the window read the textures that are bound to it.
struct Scene {
    SceneByHand hand;
    test::Programs programs;

    Scene() {
        hand.scene.suppliesNames = true;
        hand.scene.frame = {};
        const auto program = hand.program("P");
        programs.byIndex[program] = test::interfaceWith({{"uMap", "sampler2D"}});
    }
    scene::Pass& pass(std::vector<scene::TextureIndex> targets, bool clears = true) {
        scene::Pass& made = hand.target(std::move(targets));
        made.clearColors.assign(std::max<std::size_t>(1, made.targets.size()), std::nullopt);
        if (clears)
            for (auto& each : made.clearColors) each = glm::dvec4(0);
        return made;
    }
    void read(const TextureView& view) {
        if (!view.texture) {
            hand.sphere();
            return;
        }
        scene::UniformSet set;
        set.objects.push_back({"uMap", view, {1, 1}, {1, 1}});
        hand.sphere().uniforms = hand.scene.uniformSets.add(std::move(set));
    }
    std::vector<std::size_t> planned(const PlanOptions& options = {}) {
        const FramePlan plan = programs.plan(hand.scene, options);
        std::vector<std::size_t> passes;
        for (const PlannedPass& each : plan.passes) passes.push_back(each.pass);
        return passes;
    }
};

using Passes = std::vector<std::size_t>;

TEST(LiveNeeds, EndWhereATargetIsCleared) {
    Scene scene;
    const auto map = named(scene.hand, "map");
    scene.pass({map});
    scene.read({});
    scene.pass({map});
    scene.read({});
    scene.pass({});
    scene.read({.texture = map});
    scene.pass({map});
    EXPECT_EQ(scene.planned(), (Passes{1, 2}));
}
TEST(LiveNeeds, GoOnWhereATargetIsKept) {
    Scene scene;
    const auto map = named(scene.hand, "map");
    scene.pass({map});
    scene.pass({map}, false);
    scene.pass({});
    scene.read({.texture = map});
    EXPECT_EQ(scene.planned(), (Passes{0, 1, 2}));
}
TEST(LiveNeeds, GoOnWhereOnlyAPartIsCleared) {
    Scene scene;
    const auto map = named(scene.hand, "map");
    scene.hand.scene.textures[map].levels = 3;
    scene.pass({map});
    scene.pass({map}).parts = {{1, {}}};
    scene.pass({});
    scene.read({.texture = map});
    EXPECT_EQ(scene.planned(), (Passes{0, 1, 2}));
}
TEST(LiveNeeds, FollowTheDepthThatAPassTestsAgainst) {
    Scene scene;
    const auto map = named(scene.hand, "map");
    const auto depth = named(scene.hand, "depth", TexelFormat::depth24);
    scene.pass({}).depth = TextureView{.texture = depth};
    scene.hand.scene.frame.passes.back().isWindow = false;
    scene::Pass& second = scene.pass({map});
    second.depth = TextureView{.texture = depth};
    second.clearDepth = false;
    scene.read({});
    scene.pass({});
    scene.read({.texture = map});
    EXPECT_EQ(scene.planned(), (Passes{0, 1, 2}));
    scene.hand.scene.frame.passes[1].clearDepth = true;
    EXPECT_EQ(scene.planned(), (Passes{1, 2}));
}
TEST(LiveNeeds, IncludeWhatIsWantedBesidesTheWindow) {
    Scene scene;
    const auto map = named(scene.hand, "map");
    scene.pass({map});
    scene.read({});
    scene.pass({});
    scene.read({});
    EXPECT_EQ(scene.planned(), (Passes{1}));
    PlanOptions options;
    options.roots.emplace_back(TextureView{.texture = map});
    EXPECT_EQ(scene.planned(options), (Passes{0, 1}));
}
TEST(LiveNeeds, LeaveOutWindowPassesThatAreClearedAgain) {
    Scene scene;
    scene.pass({});
    scene.read({});
    const int line = scene.pass({}).place.line;
    scene.read({});
    const FramePlan plan = scene.programs.plan(scene.hand.scene, {});
    EXPECT_EQ(plan.passes.size(), 1U);
    EXPECT_EQ(test::skipped(plan, "pass"),
              (std::vector<std::string>{"the window is cleared again on line " + std::to_string(line)}));
}

TEST(SamplerTypes, AreReadFromTheirWords) {
    const SamplerType shadow = samplerTypeOf("sampler2DArrayShadow");
    EXPECT_EQ(shadow.target, TextureTarget::texture2DArray);
    EXPECT_TRUE(shadow.isShadow);
    const SamplerType samples = samplerTypeOf("usampler2DMS");
    EXPECT_EQ(samples.target, TextureTarget::texture2D);
    EXPECT_TRUE(samples.isMultisampled);
    EXPECT_EQ(samples.texels, BaseType::unsignedInteger);
    EXPECT_EQ(samplerTypeOf("iimage3D").texels, BaseType::integer);
    EXPECT_EQ(samplerTypeOf("image2D").texels, BaseType::floating);
    EXPECT_EQ(samplerTypeOf("samplerCubeArray").target, TextureTarget::cubeArray);
    EXPECT_EQ(samplerTypeOf("sampler1DArrayShadow").target, TextureTarget::texture1DArray);
    EXPECT_EQ(samplerTypeOf("usampler2DRect").target, TextureTarget::rectangle);
    const SamplerType layeredSamples = samplerTypeOf("isampler2DMSArray");
    EXPECT_EQ(layeredSamples.target, TextureTarget::texture2DArray);
    EXPECT_TRUE(layeredSamples.isMultisampled);
    const SamplerType buffer = samplerTypeOf("isamplerBuffer");
    EXPECT_TRUE(buffer.isBuffer);
    EXPECT_FALSE(buffer.target);
    EXPECT_EQ(buffer.texels, BaseType::integer);
    EXPECT_FALSE(samplerTypeOf("atomic_uint").target);
}

TEST(BoundTextures, GetUnitsOfTheirOwn) {
    const auto interface = test::interfaceWith({{"a", "sampler2D"}, {"b", "sampler2D"}, {"c", "sampler2D"}});
    const BoundTexture bound{{.texture = scene::TextureIndex(0)}, {}};
    const std::vector<SamplerBinding> samplers{
        {UniformIndex(0), 0, 0, bound}, {UniformIndex(1), 0, 0, {}}, {UniformIndex(2), 0, 0, bound}};
    const auto units = assignUnits(interface, samplers, 80, 8);
    ASSERT_TRUE(units);
    EXPECT_EQ(units->at(0).driverUnit, 0);
    EXPECT_EQ(units->at(1).driverUnit, 1);
    EXPECT_EQ(units->at(2).driverUnit, 2);
}

TEST(BoundTextures, AreFoundByTheNameOfTheUniform) {
    Scene scene;
    const auto map = named(scene.hand, "uMap");
    scene.pass({map});
    scene.pass({});
    scene.hand.sphere();
    const FramePlan plan = scene.programs.plan(scene.hand.scene, {});
    EXPECT_EQ(std::get<PlannedDraw>(plan.passes.back().steps[0]).textures.at(0).view.texture, map);
    EXPECT_EQ(test::ids(plan.diagnostics), "");
}

TEST(BoundTextures, ThatDoNotExistAreReportedWithTheirParts) {
    Scene scene;
    const auto map = named(scene.hand, "map");
    scene.pass({});
    scene.read({.texture = map, .level = 2});
    const FramePlan plan = scene.programs.plan(scene.hand.scene, {});
    EXPECT_EQ(test::textOf(plan.diagnostics, "draw-E10"),
              "'map.level(2)' does not exist: 'map' has 1 level (line 1)");
    EXPECT_TRUE(plan.passes[0].steps.empty()) << "nothing can be drawn with it";
}

}  // namespace
}  // namespace glibra::plan
