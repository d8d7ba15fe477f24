// Which fragment stages are known to always write 1 for alpha.

#include <gtest/gtest.h>

#include "support.h"

namespace glibra::glsl::test {
namespace {

bool isOpaque(const std::string& fragment) {
    const TranslatedProgram translated =
        translateStages({{Stage::vertex, kPlainVertex}, {Stage::fragment, fragment}});
    EXPECT_FALSE(hasError(translated.diagnostics)) << fragment;
    return translated.isOpaque;
}
/// The opacity of a stage with these statements in main and this text before it.
bool isOpaqueMain(const std::string& statements, const std::string& before = "out vec4 fColor;\n") {
    return isOpaque("#version 330 compatibility\n" + before + "void main() {\n" + statements + "\n}\n");
}

TEST(Opacity, UsualAssignmentsAreOpaque) {
    for (const char* each : {
             "fColor = vec4(1., .5, 0., 1.);",
             "fColor = vec4(vec3(.5), 1);",
             "fColor = vec4(1.);",
             "vec3 c = vec3(.5); fColor = vec4(c * .5, 1.0);",
             "if (gl_FragCoord.x > 9.) discard; fColor = vec4(vec3(.2), 1.f);",
             "fColor = vec4(vec3(.2), 1.); if (gl_FragCoord.x > 9.) fColor = vec4(vec3(.5), 1.);",
             "fColor = vec4(vec3(.2), 1.); fColor.rgb *= .5; fColor.x = 1.; fColor.g += .1;",
             "fColor = vec4(vec3(.2), 1.); if (gl_FragCoord.x > 9.) return; fColor.b = 0.;",
             "fColor = vec4(min(vec3(.2), vec3(.1, .2, 1.)), 1.);",
         })
        EXPECT_TRUE(isOpaqueMain(each)) << each;
    EXPECT_TRUE(isOpaqueMain("gl_FragColor = vec4(gl_Color.rgb, 1.);", ""));
    EXPECT_TRUE(
        isOpaqueMain("fColor = OPAQUE(vec3(.5));", "out vec4 fColor;\n#define OPAQUE(c) vec4(c, 1.)\n"));
}

TEST(Opacity, OtherAssignmentsAreUnknown) {
    for (const char* each : {
             "fColor = vec4(.5);",
             "fColor = vec4(vec3(.5), .5);",
             "fColor = vec4(vec3(.5), -1.);",
             "fColor = vec4(vec3(.5), 0. + 1.);",
             "fColor = vec4(vec3(.5), 1.) * .5;",
             "fColor = .5 * vec4(vec3(.5), 1.);",
             "fColor = (vec4(vec3(.5), 1.));",
             "fColor = vec4(vec3(.5), 1.).wzyx;",
             "fColor += vec4(vec3(.5), 1.);",
             "fColor = vec4(vec3(.5), 1.); fColor *= .5;",
             "fColor = vec4(vec3(.5), 1.); fColor.a = .5;",
             "fColor = vec4(vec3(.5), 1.); fColor.rgba *= .5;",
             "fColor = vec4(vec3(.5), 1.); fColor[3] = .5;",
             "fColor = vec4(vec3(.5), 1.); fColor.w++;",
             "fColor = vec4(vec3(.5), 1.); modf(vec4(.5), fColor);",
             "fColor = vec4(vec3(.5), 1.); if (gl_FragCoord.x > 9.) fColor = vec4(vec3(.5), .5);",
             "if (gl_FragCoord.x > 9.) fColor = vec4(vec3(.5), 1.);",
             "if (gl_FragCoord.x > 9.) return; fColor = vec4(vec3(.5), 1.);",
             "for (int i = 0; i < 2; ++i) fColor = vec4(vec3(.5), 1.);",
             "vec4 c = vec4(vec3(.5), 1.); fColor = c;",
             "vec4 fColor = vec4(vec3(.5), 1.);",
         })
        EXPECT_FALSE(isOpaqueMain(each)) << each;
}

TEST(Opacity, OtherOutputsAreUnknown) {
    EXPECT_FALSE(isOpaqueMain("gl_FragData[0] = vec4(vec3(.5), 1.);", ""));
    EXPECT_FALSE(
        isOpaqueMain("fColor = vec4(vec3(.5), 1.); fOther = vec4(0.);", "out vec4 fColor, fOther;\n"));
    EXPECT_FALSE(isOpaqueMain("fColor[0] = vec4(vec3(.5), 1.);", "out vec4 fColor[1];\n"));
    EXPECT_FALSE(isOpaqueMain("fColor = vec3(1.);", "out vec3 fColor;\n"));
    EXPECT_FALSE(isOpaqueMain("fColor = vec4(vec3(.5), 1.); fade(fColor);",
                              "out vec4 fColor;\nvoid fade(inout vec4 c) { c.a = .5; }\n"));
    EXPECT_FALSE(isOpaqueMain("fColor = vec4(vec3(.5), 1.); fade();",
                              "out vec4 fColor;\nvoid fade() { fColor.a = .5; }\n"));
    EXPECT_FALSE(isOpaqueMain("paint();", "out vec4 fColor;\nvoid paint() { fColor = vec4(1.); }\n"))
        << "only main is known to run";
}

TEST(Opacity, UntranslatedProgramsAreUnknown) {
    ProgramRequest asIs = program({{Stage::vertex, kPlainVertex}, {Stage::fragment, kPlainFragment}});
    ASSERT_TRUE(translate(asIs).isOpaque);
    asIs.shim = false;
    EXPECT_FALSE(translate(asIs).isOpaque);
}

}  // namespace
}  // namespace glibra::glsl::test
