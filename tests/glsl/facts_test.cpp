// What the stages of a program do, as far as their tokens show it.

#include <gtest/gtest.h>

#include "glsl/emit/emit.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

StageFacts factsOf(Stage stage, const std::string& text) {
    const TranslatedProgram translated = translateSingle(stage, text);
    EXPECT_EQ(translated.stages.size(), 1U) << ids(translated.diagnostics);
    return translated.stages.empty() ? StageFacts{} : translated.stages[0].facts;
}

bool callsFunctions(const std::string& statement) {
    return factsOf(Stage::vertex, "uniform vec4 uPlane;\nout float vD;\nvoid main() {\n" + statement +
                                      "\ngl_Position = ftransform(); }\n")
        .callsFunctions;
}

TEST(StageFacts, ConstructorsAndNormalizeAreNoFunctions) {
    EXPECT_FALSE(callsFunctions("if (uPlane.x > 0.) { vec3 n = normalize(vec3(uNormalMatrix * aNormal)); }"));
    EXPECT_FALSE(callsFunctions("for (float x = 0.; x < 3.; x += 1.) vD = float(x);"));
    EXPECT_FALSE(callsFunctions("vD = 1.; // pow(vD, 2.)"));
    EXPECT_FALSE(callsFunctions("#if 0\nvD = pow(vD, 2.);\n#endif"));
    EXPECT_TRUE(callsFunctions("vD = pow(uPlane.x, 2.);"));
    EXPECT_TRUE(callsFunctions("vD = float(int(aVertex.x));"));
    EXPECT_TRUE(callsFunctions("#define SQUARE(x) pow(x, 2.)\nvD = SQUARE(aVertex.x);"));
}

TEST(StageFacts, AFragmentStageThatOnlyAddsPaintsNoEdges) {
    const auto paints = [](const std::string& statement) {
        return factsOf(Stage::fragment, "#version 330\nin vec4 vA, vB;\nout vec4 fColor;\nvoid main() {\n" +
                                            statement + "\n}\n")
            .mayPaintEdges;
    };
    EXPECT_FALSE(paints("fColor = vec4(1.);"));
    EXPECT_FALSE(paints("vec3 c = vA.rgb + vB.rgb; fColor = vec4(c, 1.);"));
    for (const char* each :
         {"fColor = step(.5, vA);", "fColor = 1e4 * vA;", "fColor = vA; fColor *= 1e4;",
          "fColor = vA / 1e-4;", "if (vA.x > .5) discard; fColor = vB;", "fColor = vA.x > .5 ? vA : vB;",
          "fColor = vec4(int(vA.x));", "fColor = fract(vA);", "fColor = vec4(vA.x == vB.x);"})
        EXPECT_TRUE(paints(each)) << each;
    EXPECT_FALSE(
        factsOf(Stage::vertex, "void main() { gl_Position = step(.5, ftransform()); }").mayPaintEdges);
}

TEST(StageFacts, ColoursAreClampedByAFunction) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 120\nvoid main() { gl_FrontColor = gl_Color; gl_Position = ftransform(); }"},
         {Stage::fragment, "#version 120\nvoid main() { gl_FragColor = gl_Color; }"}});
    ASSERT_EQ(translated.stages.size(), 2U) << ids(translated.diagnostics);
    EXPECT_TRUE(translated.stages[0].facts.callsFunctions);
}

bool showsPrimitives(const std::string& text) {
    return factsOf(Stage::fragment, "#version 400\nout vec4 fColor;\n" + text).showsPrimitives;
}

TEST(StageFacts, FlatVariablesAndNumbersShowPrimitives) {
    EXPECT_TRUE(showsPrimitives("flat in vec3 vN; void main() { fColor = vec4(vN, 1.); }"));
    EXPECT_TRUE(showsPrimitives("in B { flat vec3 n; } b; void main() { fColor = vec4(b.n, 1.); }"));
    EXPECT_TRUE(showsPrimitives("flat in B { vec3 n; } b; void main() { fColor = vec4(b.n, 1.); }"));
    EXPECT_TRUE(showsPrimitives("void main() { fColor = vec4(gl_PrimitiveID); }"));
    EXPECT_TRUE(factsOf(Stage::fragment, "flat in vec4 gl_Color;\nvoid main() { gl_FragColor = gl_Color; }")
                    .showsPrimitives);
    EXPECT_TRUE(showsPrimitives("in vec3 p; void main() { fColor.xyz = cross(dFdx(p), dFdy(p)); }"));
    EXPECT_TRUE(factsOf(Stage::vertex, "void main() { gl_Position = vec4(gl_VertexID); }").showsPrimitives);
}

TEST(StageFacts, OtherUsesOfThoseWordsDoNotShowPrimitives) {
    EXPECT_FALSE(showsPrimitives("in vec3 vN; void main() { /* flat */ fColor = vec4(vN, 1.); }"));
    EXPECT_FALSE(showsPrimitives("in vec3 p; void main() { fColor.xyz = dFdx(p); }"));
    EXPECT_FALSE(showsPrimitives("in vec3 p; void main() { fColor.xyz = cross(p, p); }"));
}

TEST(StageFacts, RefractionsAndReflectionsInCubeMapsMagnifyNormals) {
    const auto magnifies = [](const std::string& text) {
        return factsOf(Stage::fragment, "in vec3 vN, vE;\nout vec4 fColor;\n" + text).magnifiesNormals;
    };
    EXPECT_TRUE(
        magnifies("uniform samplerCube uSky; void main() { fColor = texture(uSky, reflect(vE, vN)); }"));
    EXPECT_TRUE(magnifies("void main() { fColor.xyz = refract(vE, vN, .9); }"));
    EXPECT_FALSE(magnifies("void main() { fColor = vec4(pow(reflect(vE, vN).z, 9.)); }"));
    EXPECT_FALSE(magnifies("uniform samplerCube uSky; void main() { fColor = texture(uSky, vN); }"));
}

TEST(StageFacts, AnIntegerThatBecomesACubeMapCounts) {
    ProgramRequest request = single(Stage::fragment,
                                    "in vec3 vN, vE;\nout vec4 fColor;\nuniform int uSky;\n"
                                    "void main() { fColor = texture(uSky, reflect(vE, vN)); }\n");
    request.samplerKindsOfTag = [](std::string_view) { return std::vector{SamplerKind::samplerCube}; };
    const TranslatedProgram translated = translate(request);
    ASSERT_EQ(translated.stages.size(), 1U) << ids(translated.diagnostics);
    EXPECT_TRUE(translated.stages[0].facts.magnifiesNormals);
}

TEST(StageFacts, DepthMayBeWrittenUnderACondition) {
    const std::string start = "in float vZ;\nout vec4 fColor;\nvoid main() { fColor = vec4(1.); ";
    EXPECT_TRUE(factsOf(Stage::fragment, start + "if (vZ > 0.) gl_FragDepth = vZ; }").mayWriteDepth);
    EXPECT_FALSE(factsOf(Stage::fragment, start + "/* gl_FragDepth */ }").mayWriteDepth);
}

TEST(StageFacts, AreKnownWithoutTranslation) {
    ProgramRequest request =
        single(Stage::fragment, "flat in float vZ;\nout vec4 fColor;\nvoid main() { fColor = vec4(vZ); }");
    request.shim = false;
    const TranslatedProgram translated = translate(request);
    ASSERT_EQ(translated.stages.size(), 1U);
    EXPECT_TRUE(translated.stages[0].facts.showsPrimitives);
}

TEST(Tangents, MayBeReadByTheVertexStageThatNamesThem) {
    const auto mayRead = [](const std::string& vertex, const std::string& fragment = kPlainFragment) {
        return translateStages({{Stage::vertex, "#version 330\n" + vertex}, {Stage::fragment, fragment}})
            .mayReadTangents;
    };
    EXPECT_TRUE(mayRead("out vec3 vT;\nvoid main() { vT = aTangent; gl_Position = aVertex; }"));
    EXPECT_TRUE(mayRead("in vec3 Tangent;\nvoid main() { gl_Position = vec4(Tangent, 1.); }"));
    EXPECT_FALSE(mayRead("out vec3 vTangent;\nvoid main() { vTangent = aNormal; gl_Position = aVertex; }"));
    EXPECT_FALSE(mayRead("void main() { gl_Position = aVertex; } // Tangent"));
}

TEST(WrappedMain, CallsTheStagesOwn) {
    TranslatedStage stage;
    stage.source = "#version 450 core\nvoid main() { work(); }\n";
    EXPECT_EQ(versionLine(stage), "#version 450 core\n");
    EXPECT_EQ(wrappedMain(stage, {"out vec4 o;\n", "    first();\n", "    last();\n"}),
              "#version 450 core\n#define main glibra_sceneMain\nvoid main() { work(); }\n\n#undef main\n"
              "out vec4 o;\nvoid main() {\n    first();\n    glibra_sceneMain();\n    last();\n}\n");
}

TEST(WrappedMain, NeedsNoVersionLine) {
    TranslatedStage stage;
    stage.source = "void main() {}";
    EXPECT_EQ(versionLine(stage), "#version 410 core\n");
    EXPECT_EQ(wrappedMain(stage, {"", "", ""}),
              "#define main glibra_sceneMain\nvoid main() {}\n#undef main\nvoid main() {\n"
              "    glibra_sceneMain();\n}\n");
    stage.source = "#version 450";
    EXPECT_EQ(versionLine(stage), "#version 450");
}

TEST(WrappedMain, OfATranslatedStageCompiles) {
    TranslatedProgram translated = translateStages(
        {{Stage::vertex, kPlainVertex}, {Stage::fragment, "void main() { gl_FragColor = vec4(1.); }"}});
    ASSERT_EQ(translated.stages.size(), 2U);
    for (TranslatedStage& each : translated.stages)
        each.source =
            wrappedMain(each, {"float observed;\n", "    observed = 1.;\n", "    observed = 2.;\n"});
    EXPECT_EQ(glslangErrors(translated), "");
}

}  // namespace
}  // namespace glibra::glsl::test
