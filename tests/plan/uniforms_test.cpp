// Which uniform a tag names, and the messages about uniforms without a tag (language, 5.3 and 6).
#include "plan/uniforms.h"

#include <gtest/gtest.h>

#include "by_hand.h"

namespace glibra::plan {
namespace {

using glib::UniformForm;
using test::ids;
using test::interfaceWith;
using test::number;
using test::spec;
using test::textOf;
using test::Values;

scene::Program program(std::vector<glib::UniformSpec> pairs) {
    scene::Program result;
    result.name = "Dots";
    result.place = test::at(5);
    result.uniforms = std::move(pairs);
    return result;
}
UniformResolution resolve(const ProgramInterface& interface, std::vector<glib::UniformSpec> pairs,
                          const std::vector<Override>& overrides = {}) {
    std::vector<bool> used;
    return resolveUniforms(program(std::move(pairs)), test::kScenePath, interface, overrides, used);
}
/// The literal of a uniform; the last one if there are several.
Values literal(const UniformResolution& resolution, std::size_t uniform) {
    Values values;
    for (const UniformBinding& each : resolution.values)
        if (const auto* found = std::get_if<Literal>(&each.value);
            each.uniform.position() == uniform && found != nullptr)
            values = found->values;
    return values;
}

TEST(Tag, NamesAUniformExactly) {
    const UniformResolution result = resolve(interfaceWith({{"uKa", "float"}}), {number("uKa", .5)});
    EXPECT_EQ(literal(result, 0), Values{.5});
    EXPECT_TRUE(result.diagnostics.empty());
}
TEST(Tag, IsUnknownInAnotherCaseAndTheNearNameIsOffered) {
    const UniformResolution result = resolve(interfaceWith({{"uShrink", "float"}}), {number("ushrink", .5)});
    EXPECT_TRUE(literal(result, 0).empty());
    EXPECT_EQ(textOf(result.diagnostics, "glib-W23"),
              "no shader of 'Dots' has a uniform 'ushrink'; did you mean 'uShrink'?");
    EXPECT_EQ(result.diagnostics.front().place, (Place{test::kScenePath, 7, 3}));
}
TEST(Tag, NamesAnArrayWithSubscriptZero) {
    const auto interface = interfaceWith({{"uA", "float[3]"}});
    EXPECT_EQ(literal(resolve(interface, {spec("uA[0]", UniformForm::list, {5})}), 0), Values{5});
}
TEST(Tag, NamesOneElementOfAnArray) {
    const UniformResolution result = resolve(interfaceWith({{"uA", "float[3]"}}), {number("uA[2]", 5)});
    ASSERT_EQ(result.values.size(), 1U);
    EXPECT_EQ(result.values[0].firstElement, 2);
    EXPECT_TRUE(result.diagnostics.empty());
}
TEST(Tag, BeyondAnArrayIsNotItsElement) {
    const auto interface = interfaceWith({{"uA", "float[3]"}});
    EXPECT_TRUE(resolve(interface, {number("uA[3]", 5)}).values.empty());
    EXPECT_TRUE(resolve(interface, {number("uA[-1]", 5)}).values.empty());
    EXPECT_TRUE(resolve(interface, {number("uA[99999999999999999999]", 5)}).values.empty());
    EXPECT_TRUE(resolve(interface, {number("uA[]", 5)}).values.empty());
}
TEST(Tag, NamesAMemberOfAStructure) {
    const UniformResolution result =
        resolve(interfaceWith({{"uLight.power", "float"}}), {number("uLight.power", 3)});
    EXPECT_EQ(literal(result, 0), Values{3});
}
TEST(Tag, ThatNamesAWholeStructurePointsToAMember) {
    const UniformResolution result =
        resolve(interfaceWith({{"uLight.power", "float"}}), {number("uLight", 3)});
    EXPECT_EQ(textOf(result.diagnostics, "glib-W23"),
              "no shader of 'Dots' has a uniform 'uLight'; did you mean 'uLight.power'?");
}
TEST(Tag, NamesABlockMemberByItsOwnOrItsFullName) {
    for (const char* reported : {"Material.uKd", "uKd"})
        for (const char* tag : {"Material.uKd", "uKd"}) {
            ProgramInterface interface = interfaceWith({{reported, "float"}});
            interface.uniforms[0].block = 0;
            interface.uniforms[0].blockName = "Material";
            EXPECT_EQ(literal(resolve(interface, {number(tag, .5)}), 0), Values{.5})
                << reported << ' ' << tag;
        }
}
TEST(Tag, NamesAPlainUniformBeforeABlockMember) {
    ProgramInterface interface = interfaceWith({{"Material.uKd", "float"}, {"uKd", "float"}});
    interface.uniforms[0].block = 0;
    interface.uniforms[0].blockName = "Material";
    const UniformResolution result = resolve(interface, {number("uKd", .5)});
    EXPECT_TRUE(literal(result, 0).empty());
    EXPECT_EQ(literal(result, 1), Values{.5});
}
TEST(Tag, GivenTwiceUsesTheLastValue) {
    const auto interface = interfaceWith({{"uKa", "int"}});
    const UniformResolution result = resolve(interface, {number("uKa", 1.5), number("uKa", 2)});
    EXPECT_EQ(literal(result, 0), Values{2});
    EXPECT_EQ(ids(result.diagnostics), "");
}
TEST(Tag, OfADeclaredButUnusedUniformHasNoEffect) {
    ProgramInterface interface = interfaceWith({});
    interface.facts.uniforms["uKs"] = {};
    const UniformResolution result = resolve(interface, {number("uKs", 1)});
    EXPECT_EQ(textOf(result.diagnostics, "glib-W24"),
              "uniform 'uKs' is declared in 'Dots' but unused, so its value has no effect");
}
TEST(Tag, OfAnUnusedMemberHasNoEffect) {
    const ProgramInterface interface = interfaceWith({{"uLight.power", "float"}});
    EXPECT_EQ(ids(resolve(interface, {number("uLight.power", 1), number("uLight.size", 1)}).diagnostics),
              "glib-W24");
}

TEST(SuppliedTag, TimerPointsToTheCommand) {
    for (const auto& interface : {interfaceWith({{"Timer", "float"}}), interfaceWith({})}) {
        const UniformResolution result = resolve(interface, {number("Timer", 10)});
        EXPECT_EQ(textOf(result.diagnostics, "glib-W25"),
                  "glibra supplies 'Timer'; set its period with the command 'Timer 10'");
        for (const UniformBinding& each : result.values)
            EXPECT_TRUE(std::holds_alternative<Supplied>(each.value));
    }
}
TEST(SuppliedTag, OfAMatrixHasNoEffect) {
    const UniformResolution result =
        resolve(interfaceWith({{"uModelViewMatrix", "mat4"}}), {number("uModelViewMatrix", 2)});
    EXPECT_EQ(ids(result.diagnostics), "glib-W25");
    ASSERT_EQ(result.values.size(), 1U);
    ASSERT_TRUE(std::holds_alternative<Supplied>(result.values[0].value));
    EXPECT_EQ(std::get<Supplied>(result.values[0].value).value, glsl::Builtin::modelView);
}
TEST(SuppliedTag, OfACompatibilityNameHasNoEffect) {
    EXPECT_EQ(ids(resolve(interfaceWith({}), {number("gl_ModelViewMatrix", 2)}).diagnostics), "glib-W25");
}
TEST(SuppliedTag, OfNoiseSelectsAnotherUnit) {
    const UniformResolution result = resolve(interfaceWith({{"Noise3", "sampler3D"}}), {number("Noise3", 9)});
    EXPECT_EQ(ids(result.diagnostics), "glib-W25");
    ASSERT_EQ(result.samplers.size(), 1U);
    EXPECT_EQ(result.samplers[0].unit, 9);
}
TEST(SuppliedName, WithAnotherTypeIsAnOrdinaryUniform) {
    const UniformResolution result = resolve(interfaceWith({{"Noise3", "float"}, {"Timer", "int"}}),
                                             {number("Noise3", .5), number("Timer", 4)});
    EXPECT_EQ(literal(result, 0), Values{.5});
    EXPECT_EQ(literal(result, 1), Values{4});
    EXPECT_EQ(ids(result.diagnostics), "");
}

TEST(SuppliedName, OfTextureMatricesIsAnArray) {
    const auto isSupplied = [](const char* type) {
        return ids(resolve(interfaceWith({{"gl_TextureMatrix", type}}), {number("gl_TextureMatrix", 1)})
                       .diagnostics) == "glib-W25";
    };
    EXPECT_TRUE(isSupplied("mat4[2]"));
    EXPECT_FALSE(isSupplied("mat4"));
}

TEST(UnsetUniform, IsReported) {
    const UniformResolution result = resolve(interfaceWith({{"uTime", "float"}}), {});
    EXPECT_EQ(textOf(result.diagnostics, "glib-W37"), "uniform 'uTime' of 'Dots' is not set; it is 0");
    EXPECT_EQ(result.diagnostics.front().place, test::at(5));
}
TEST(UnsetUniform, WithAWellKnownNameNeedsAModernScene) {
    EXPECT_EQ(textOf(resolve(interfaceWith({{"mvp", "mat4"}}), {}).diagnostics, "glib-W37"),
              "uniform 'mvp' of 'Dots' is not set; it is 0; scenes with a Camera or another modern statement "
              "supply it");
}
TEST(UnsetUniform, IsNotReportedIfItIsSupplied) {
    const auto interface = interfaceWith({{"Timer", "float"},
                                          {"uNormalMatrix", "mat3"},
                                          {"Noise2", "sampler2D"},
                                          {"uModelViewProjectionMatrix", "mat4"}});
    const UniformResolution result = resolve(interface, {});
    EXPECT_EQ(ids(result.diagnostics), "");
    EXPECT_EQ(result.values.size(), 3U);
}
TEST(UnsetUniform, IsNotReportedIfItHasAnInitialiser) {
    ProgramInterface interface = interfaceWith({{"uTime", "float"}, {"uLight.power", "float"}});
    interface.facts.uniforms["uTime"].hasInitializer = true;
    interface.facts.uniforms["uLight"].hasInitializer = true;
    EXPECT_EQ(ids(resolve(interface, {}).diagnostics), "");
}
TEST(UnsetUniform, IsNeverReportedForNamesOfTheTranslator) {
    EXPECT_EQ(
        ids(resolve(interfaceWith({{"glibra_somethingOfItsOwn", "float"}, {"gl_DepthRange.near", "float"}}),
                    {})
                .diagnostics),
        "");
}
TEST(UnsetUniform, WhoseTagWasIgnoredIsReportedToo) {
    EXPECT_EQ(
        ids(resolve(interfaceWith({{"uM", "mat4"}}), {spec("uM", UniformForm::truth, {1})}).diagnostics),
        "glib-W20 glib-W37");
}

TEST(Sampler, WithoutATagReadsUnitZeroAndIsReported) {
    const UniformResolution result = resolve(interfaceWith({{"uTex", "sampler2D"}}), {});
    ASSERT_EQ(result.samplers.size(), 1U);
    EXPECT_EQ(result.samplers[0].unit, 0);
    EXPECT_EQ(ids(result.diagnostics), "glib-W37");
}
TEST(Sampler, WithABindingReadsThatUnit) {
    ProgramInterface interface = interfaceWith({{"uTex", "sampler2D"}, {"uTexes", "sampler2D[2]"}});
    interface.facts.textureBindings = {{"uTex", 7}, {"uTexes", 10}};
    const UniformResolution result = resolve(interface, {});
    ASSERT_EQ(result.samplers.size(), 3U);
    EXPECT_EQ(result.samplers[0].unit, 7);
    EXPECT_EQ(result.samplers[1].unit, 10);
    EXPECT_EQ(result.samplers[2].unit, 11);
    EXPECT_EQ(ids(result.diagnostics), "");
}
TEST(Sampler, WithATagAndABindingReadsTheTagsUnit) {
    ProgramInterface interface = interfaceWith({{"uTex", "sampler2D"}});
    interface.facts.textureBindings = {{"uTex", 7}};
    EXPECT_EQ(resolve(interface, {number("uTex", 5)}).samplers.at(0).unit, 5);
}
TEST(Sampler, OfNoiseReadsTheNoiseUnits) {
    const auto result = resolve(interfaceWith({{"Noise2", "sampler2D"}, {"Noise3", "sampler3D"}}), {});
    ASSERT_EQ(result.samplers.size(), 2U);
    EXPECT_EQ(result.samplers[0].unit, 2);
    EXPECT_EQ(result.samplers[1].unit, 3);
}
TEST(Sampler, ArrayHasAnEntryForEachElement) {
    const auto result = resolve(interfaceWith({{"uTex", "sampler2D[3]"}}),
                                {spec("uTex", UniformForm::list, {5, 6, 7}), number("uTex[1]", 9)});
    ASSERT_EQ(result.samplers.size(), 3U);
    EXPECT_EQ(result.samplers[0].unit, 5);
    EXPECT_EQ(result.samplers[1].unit, 9);
    EXPECT_EQ(result.samplers[2].unit, 7);
}

// A driver may report an array up to the last element that is used.
TEST(Uniforms, ArraysInStructuresHaveTheirDeclaredLength) {
    ProgramInterface interface =
        interfaceWith({{"light.weights", "float[2]"}, {"lights[1].m[0].v", "vec2[1]"}});
    glsl::MemoryFacts& memory = interface.facts.memory;
    const auto member = [](std::string name, std::string type, glsl::ArraySizes sizes) {
        glsl::MemoryMember made;
        made.name = std::move(name);
        made.type = std::move(type);
        made.sizes = std::move(sizes);
        return made;
    };
    memory.structures["Inner"].members = {member("v", "vec2", {3})};
    memory.structures["Light"].members = {member("weights", "float", {4}), member("m", "Inner", {2}),
                                          member("power", "float", {})};
    memory.records.emplace("light", member("light", "Light", {}));
    memory.records.emplace("lights", member("lights", "Light", {2}));
    EXPECT_EQ(declaredElements(interface, interface.uniforms[0]), 4);
    EXPECT_EQ(declaredElements(interface, interface.uniforms[1]), 3);
    EXPECT_EQ(declaredElements(interface, test::uniform("light.power", "float")), 0);
    EXPECT_EQ(declaredElements(interface, test::uniform("other", "float")), 0);
}

}  // namespace
}  // namespace glibra::plan
