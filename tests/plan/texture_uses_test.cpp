#include "plan/texture_binding.h"

#include <gtest/gtest.h>

#include "by_hand.h"

namespace glibra::plan {
namespace {

using scene::TextureTarget;
using test::SceneByHand;

std::vector<int> driverUnits(const Result<std::vector<UnitUse>>& result) {
    std::vector<int> units;
    for (const UnitUse& each : *result) units.push_back(each.driverUnit);
    return units;
}

TEST(DriverUnits, AreCompactWhateverTheUnitsOfTheLanguage) {
    const auto interface =
        test::interfaceWith({{"a", "sampler2D"}, {"b", "sampler3D"}, {"c", "samplerCube"}});
    const std::vector<SamplerBinding> samplers{
        {UniformIndex(0), 0, 127}, {UniformIndex(1), 0, 3}, {UniformIndex(2), 0, 50}};
    EXPECT_EQ(driverUnits(assignUnits(interface, samplers, 80, 8)), (std::vector<int>{0, 1, 2}));
}
TEST(DriverUnits, AreSharedBySamplersOfOneTypeOnOneUnit) {
    const auto interface = test::interfaceWith({{"a", "sampler2D"}, {"b", "sampler2D[2]"}});
    const std::vector<SamplerBinding> samplers{
        {UniformIndex(0), 0, 5}, {UniformIndex(1), 0, 6}, {UniformIndex(1), 1, 5}};
    EXPECT_EQ(driverUnits(assignUnits(interface, samplers, 80, 8)), (std::vector<int>{0, 1, 0}));
}
TEST(DriverUnits, AreSeparateForSamplersOfDifferentTypesOnOneUnit) {
    const auto interface =
        test::interfaceWith({{"a", "sampler2D"}, {"b", "samplerCube"}, {"c", "isampler2D"}});
    const std::vector<SamplerBinding> samplers{
        {UniformIndex(0), 0, 5}, {UniformIndex(1), 0, 5}, {UniformIndex(2), 0, 5}};
    EXPECT_EQ(driverUnits(assignUnits(interface, samplers, 80, 8)), (std::vector<int>{0, 1, 2}));
}
TEST(DriverUnits, OfImagesAreCountedSeparately) {
    const auto interface = test::interfaceWith({{"a", "sampler2D"}, {"b", "image2D"}});
    const std::vector<SamplerBinding> samplers{{UniformIndex(0), 0, 5}, {UniformIndex(1), 0, 6}};
    EXPECT_EQ(driverUnits(assignUnits(interface, samplers, 80, 8)), (std::vector<int>{0, 0}));
}
TEST(DriverUnits, AreNotMoreThanTheDriverHas) {
    const auto interface = test::interfaceWith({{"a", "sampler2D[3]"}});
    const std::vector<SamplerBinding> samplers{
        {UniformIndex(0), 0, 5}, {UniformIndex(0), 1, 6}, {UniformIndex(0), 2, 7}};
    EXPECT_TRUE(assignUnits(interface, samplers, 3, 8));
    const auto result = assignUnits(interface, samplers, 2, 8);
    EXPECT_FALSE(result);
    EXPECT_EQ(result.diagnostics.at(0).id, "draw-E13");
}
TEST(DriverUnits, ForImagesAreNotMoreThanTheDriverHas) {
    const auto interface = test::interfaceWith({{"a", "image2D"}});
    EXPECT_FALSE(assignUnits(interface, std::vector<SamplerBinding>{{UniformIndex(0), 0, 5}}, 80, 0));
}

std::vector<TextureUse> uses(SceneByHand& hand, const ProgramInterface& interface, int unit,
                             bool clamp = false) {
    scene::Draw& draw = hand.sphere();
    draw.sampling.clamp = clamp;
    return textureUses(hand.scene, draw.slots, draw.sampling, interface,
                       std::vector<UnitUse>{{{UniformIndex(0), 0, unit}, 0}});
}

TEST(TextureUse, FollowsTheTypeOfTheSampler) {
    SceneByHand hand;
    const auto picture = hand.texture(5);
    const auto cube = hand.texture(5, TextureTarget::cube);
    EXPECT_EQ(uses(hand, test::interfaceWith({{"a", "sampler2D"}}), 5).at(0).view.texture, picture);
    EXPECT_EQ(uses(hand, test::interfaceWith({{"a", "samplerCube"}}), 5).at(0).view.texture, cube);
    EXPECT_FALSE(uses(hand, test::interfaceWith({{"a", "sampler3D"}}), 5).at(0).view.texture);
}
TEST(TextureUse, SeesWhatTheSlotHoldsAtTheDraw) {
    SceneByHand hand;
    const auto interface = test::interfaceWith({{"a", "sampler2D"}});
    const auto before = hand.texture(6);
    EXPECT_EQ(uses(hand, interface, 6).at(0).view.texture, before);
    const auto after = hand.texture(6);
    EXPECT_EQ(uses(hand, interface, 6).at(0).view.texture, after);
    EXPECT_NE(before, after);
}
TEST(TextureUse, ClampsByTheDrawExceptNoiseAndCubes) {
    SceneByHand hand;
    hand.texture(5);
    hand.texture(5, TextureTarget::cube);
    hand.noise(3);
    const auto picture = test::interfaceWith({{"a", "sampler2D"}});
    const auto cube = test::interfaceWith({{"a", "samplerCube"}});
    const auto noise = test::interfaceWith({{"a", "sampler3D"}});
    const auto clamps = [&](const ProgramInterface& interface, int unit, bool clamp) {
        const base::Wrap wrap = uses(hand, interface, unit, clamp).at(0).sampler.wrap[0];
        EXPECT_TRUE(wrap == base::Wrap::clampToEdge || wrap == base::Wrap::repeat);
        return wrap == base::Wrap::clampToEdge;
    };
    EXPECT_FALSE(clamps(picture, 5, false));
    EXPECT_TRUE(clamps(picture, 5, true));
    EXPECT_TRUE(clamps(cube, 5, false));
    EXPECT_FALSE(clamps(noise, 3, true));
}
TEST(TextureUse, OfASamplerThatScenesCannotFillIsEmpty) {
    SceneByHand hand;
    hand.texture(5);
    EXPECT_FALSE(uses(hand, test::interfaceWith({{"a", "sampler2DArray"}}), 5).at(0).view.texture);
}
TEST(SlotText, NamesUnitAndTarget) {
    EXPECT_EQ(slotText(5, TextureTarget::texture3D), "5 / 3D");
    EXPECT_EQ(slotText(0, TextureTarget::cube), "0 / cube");
}

}  // namespace
}  // namespace glibra::plan
