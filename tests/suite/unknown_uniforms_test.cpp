#include "suite/run/shot_renderer.h"

#include <gtest/gtest.h>

#include <utility>

namespace glibra::suite {
namespace {

Shot shotThatNames(std::initializer_list<const char*> uniforms) {
    Shot shot;
    int line = 3;
    for (const char* each : uniforms) shot.ownUniforms.push_back({each, {"s.toml", line++, 9}});
    return shot;
}

/// The message about a uniform that no program has.
Diagnostic unknown(std::string uniform, std::string text) {
    Diagnostic message = diagnose("glib-W23", std::move(text));
    message.subject = std::move(uniform);
    return message;
}

TEST(UnknownUniforms, OfTheShotAreErrorsWithTheirPlaceInTheSuite) {
    Diagnostics all{unknown("uKe", "no program of the scene has a uniform 'uKe'; did you mean 'uKd'?"),
                    unknown("uA", "no program 'Dots' has a uniform 'uA'")};
    reportUnknownUniforms(shotThatNames({"uK", "uKe", "Dots:uA"}), all);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(
        toString(all[0]),
        "s.toml:4:9: error: no program of the scene has a uniform 'uKe'; did you mean 'uKd'? [suite-E19]");
    EXPECT_EQ(toString(all[1]), "s.toml:5:9: error: no program 'Dots' has a uniform 'uA' [suite-E19]");
}

TEST(UnknownUniforms, OfDefaultsAndOfTheSceneStayWarnings) {
    const Diagnostics before{
        unknown("uDefault", "no program of the scene has a uniform 'uDefault'"),
        diagnose("glib-W23", "no shader of 'P' has a uniform 'uKe'", {"a.glib", 4, 1}),
        diagnose("glib-W24", "uniform 'uKe' is declared but unused, so setting it has no effect")};
    Diagnostics all = before;
    reportUnknownUniforms(shotThatNames({"uKe"}), all);
    ASSERT_EQ(all.size(), before.size());
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(toString(all[i]), toString(before[i]));
}

}  // namespace
}  // namespace glibra::suite
