// Programs with one stage, and lights and materials of the fixed pipeline (language, 7.9 and 12.1).

#include <gtest/gtest.h>

#include <string>

#include "script_problems.h"

namespace glibra::test {
namespace {

const std::string kOneStageScene = "WindowSize 8 8\nBackground 0 0 0\nCamera eye (mat4(1)) (mat4(1))\n";
const std::string kWholeSquare =
    "glBegin quads\nglTexCoord .25 .75\nglVertex -1 -1 0\nglVertex 1 -1 0\nglVertex 1 1 0\nglVertex -1 1 0\n"
    "glEnd\n";

std::string vertexStage(const std::string& text) {
    return "Vertex inline\n" + text + "\nEndVertex\n";
}
std::string fragmentStage(const std::string& text) {
    return "Fragment inline\n" + text + "\nEndFragment\n";
}
std::string isAll(const std::string& color) {
    return "Expect count [" + color + "] 64 within .003\n";
}

TEST(OneStage, AVertexStageAloneDrawsItsFrontColorAtItsOwnPlace) {
    // The square reaches the left half only, which the built-in program would not do.
    const std::string stage =
        "#version 110\nvoid main() { gl_FrontColor = vec4(1., .5, 0., 1.);\n"
        "gl_Position = vec4(.5*gl_Vertex.x - .5, gl_Vertex.yz, 1.); }";
    EXPECT_EQ(problemsOf(kOneStageScene + vertexStage(stage) + "Program Red\n" + kWholeSquare +
                         "Expect count [1 .5 0] 32 within .003\nExpect pixel 1 1 [1 .5 0] within .003\n"),
              "");
}

TEST(OneStage, AVertexStageAloneDrawsAnOutputThatIsAColor) {
    const auto stage = [](const std::string& output, const std::string& value) {
        return vertexStage("#version 330 core\nin vec4 aVertex;\nout vec2 vColorPlace;\n" + output +
                           "void main() { vColorPlace = vec2(0.); " + value +
                           " gl_Position = vec4(aVertex.xyz, 1.); }") +
               "Program P\n" + kWholeSquare;
    };
    const auto reported = [](const std::string& name) {
        return "Program 'P' has no fragment stage; " + name + " is used";
    };
    const auto hasOnly = [](const std::string& problems, const std::string& warning) {
        EXPECT_NE(problems.find(warning), std::string::npos) << problems;
        EXPECT_EQ(problems.find('\n'), problems.size() - 1) << problems;
    };
    hasOnly(problemsOf(kOneStageScene + stage("out vec3 vColor;\n", "vColor = vec3(0., .5, 1.);") +
                       isAll("0 .5 1")),
            reported("its output 'vColor'"));
    hasOnly(problemsOf(kOneStageScene +
                       stage("flat out vec4 faceColour;\n", "faceColour = vec4(.5, 0., 0., 1.);") +
                       isAll(".5 0 0")),
            reported("its output 'faceColour'"));
    hasOnly(problemsOf(kOneStageScene + "Color 0 1 .5\n" + stage("", "") + isAll("0 1 .5")),
            reported("the current colour"));
}

TEST(OneStage, AGeometryStageMayEndThePipeline) {
    EXPECT_EQ(problemsOf(
                  kOneStageScene + vertexStage("#version 120\nvoid main() { gl_Position = gl_Vertex; }") +
                  "Geometry inline\n#version 410\nlayout(triangles) in;\n"
                  "layout(triangle_strip, max_vertices = 3) out;\nvoid main() { for (int i = 0; i < 3; ++i) "
                  "{ gl_FrontColor = vec4(0., 0., 1., 1.); gl_Position = gl_in[i].gl_Position; EmitVertex(); "
                  "} }\nEndGeometry\nProgram P\n" +
                  kWholeSquare + isAll("0 0 1")),
              "");
}

TEST(OneStage, AFragmentStageAloneGetsTheFixedVertexStage) {
    EXPECT_EQ(
        problemsOf(
            kOneStageScene + "Color 1 .5 0\n" +
            fragmentStage(
                "#version 110\nvoid main() { gl_FragColor = vec4(gl_Color.rg, gl_TexCoord[0].t, 1.); }") +
            "Program P\nScale .5 1 1\n" + kWholeSquare + "Expect count [1 .5 .75] 32 within .003\n"),
        "");
    EXPECT_EQ(
        problemsOf(kOneStageScene +
                   fragmentStage("#version 330\nin vec2 vST;\nout vec4 c;\nvoid main() { c = vec4(vST, 0., "
                                 "1.); }") +
                   "Program P\n" + kWholeSquare + isAll(".25 .75 0")),
        "");
}

TEST(OneStage, ScenesWithoutModernStatementsHaveThemToo) {
    EXPECT_EQ(problemsOf("WindowSize 8 8\nOrtho -1 1 -1 1\nVertex red.vert\nProgram Red\nQuadXY 0 2\n",
                         {{"red.vert",
                           "#version 110\nvoid main() { gl_FrontColor = vec4(1.,0.,0.,1.); gl_Position = "
                           "ftransform(); }"}}),
              "");
}

/// Lights the square by the first light, whose direction the shader reads.
const std::string kLit =
    vertexStage(
        "#version 120\nvoid main() { vec3 n = vec3(0., 0., 1.);\n"
        "vec3 l = normalize(gl_LightSource[1].position.xyz);\n"
        "gl_FrontColor = gl_FrontMaterial.emission + gl_LightModel.ambient*gl_FrontMaterial.ambient +\n"
        "gl_LightSource[1].diffuse*gl_FrontMaterial.diffuse*max(0., dot(n, l)); gl_Position = gl_Vertex; }") +
    "Program Lit\n";

TEST(Lights, HaveTheValuesOfTheScene) {
    EXPECT_EQ(problemsOf(kOneStageScene + kLit +
                         "Light 1 position 0 .6 .8 0 diffuse {1 .5 .25}\nLight ambient {.5 .5 .5}\n"
                         "Material ambient {.2 .2 .2} diffuse {.5 .5 1} emission {0 0 .1} shininess 30\n" +
                         kWholeSquare + isAll(".5 .3 .4")),
              "");
}

TEST(Lights, KeepTheInitialValuesOfOpenGl) {
    // Material: diffuse .8, ambient .2; light 1 is black; ambient of the model .2.
    EXPECT_EQ(
        problemsOf(kOneStageScene + kLit + "Light 0 diffuse {1 0 0}\n" + kWholeSquare + isAll(".04 .04 .04")),
        "");
    EXPECT_NE(problemsOf(kOneStageScene + kLit + kWholeSquare + isAll(".04 .04 .04")).find("glsl-W04"),
              std::string::npos);
}

TEST(Lights, EndWithTheirScope) {
    EXPECT_EQ(problemsOf(
                  kOneStageScene + kLit +
                  "Light 1 position 0 0 1 0 diffuse {1 1 1}\nMaterial diffuse {.5 .5 .5}\nLight ambient {0 0 "
                  "0}\nGroup\nMaterial diffuse {1 0 0}\nEndGroup\n" +
                  kWholeSquare + isAll(".5 .5 .5")),
              "");
}

TEST(Lights, StandInTheCoordinatesOfTheStatementAndReachTheEye) {
    const std::string show =
        fragmentStage(
            "#version 120\nvoid main() { gl_FragColor = vec4(gl_LightSource[2].position.xyz*.1, 1.); }") +
        "Program Show\n";
    const std::string camera = "Camera eye LookAt 0 0 5  0 0 0  0 1 0  Ortho -1 1 -1 1 .1 10\n";
    EXPECT_EQ(problemsOf("WindowSize 8 8\n" + camera + show +
                         "PushMatrix\nTranslate 1 2 8\nScale 2\nLight 2 position 1 0 0\nPopMatrix\n" +
                         kWholeSquare + isAll(".3 .2 .3")),
              "");
    EXPECT_EQ(problemsOf("WindowSize 8 8\n" + camera + show +
                         "Translate 1 2 8\nLight 2 position 3 2 1 0\nTranslate -1 -2 -8\n" + kWholeSquare +
                         isAll(".3 .2 .1")),
              "")
        << "a direction does not move";
}

TEST(Lights, ComputeWhatOpenGlComputes) {
    // Half of the way between (0, .6, .8) and the eye; the cosine of 60 degrees; products with the material.
    const std::string show = fragmentStage(
        "#version 120\nvoid main() { gl_FragColor = vec4(gl_LightSource[0].halfVector.y, "
        "gl_LightSource[0].spotCosCutoff, gl_FrontLightProduct[0].diffuse.r + "
        "gl_FrontLightModelProduct.sceneColor.g, 1.); }");
    EXPECT_EQ(
        problemsOf(
            kOneStageScene + show +
            "Program Show\nLight 0 position 0 .6 .8 0 cutoff 60 diffuse {.5 1 1} spot 0 0 -1 exponent 2 "
            "attenuation 1 0 .5\nMaterial diffuse {.5 1 1} ambient {1 .5 1}\nLight ambient {1 .5 1}\n" +
            kWholeSquare + isAll(".31623 .5 .5")),
        "");
}

TEST(Lights, AreSetByExpressionsAndPresets) {
    EXPECT_EQ(
        problemsOf(
            kOneStageScene + kLit +
            "Let up .6\nLight (2 - 1) position (vec4(0, up, .8, 0)) diffuse (vec3(1))\nMaterial gold\nSet "
            "gl_LightModel.ambient [0 0 0 0]\n" +
            kWholeSquare + isAll(".6013 .4852 .1812")),
        "");
}

TEST(Lights, WrongValuesAreReported) {
    const auto first = [](const std::string& statement) {
        const std::string all = problemsOf(kOneStageScene + statement + "\nBox\n");
        return all.substr(0, all.find('\n'));
    };
    EXPECT_NE(first("Light 8 position 0 0 1").find("glib-E05"), std::string::npos)
        << first("Light 8 position 0 0 1");
    EXPECT_NE(first("Light 0 position 0 1").find("3 numbers, or 4 with w"), std::string::npos);
    EXPECT_NE(first("Light 0 cutoff 120").find("0 to 90 degrees, or 180"), std::string::npos);
    EXPECT_NE(first("Light 0 diffuse (vec2(1))").find("3 or 4 components"), std::string::npos);
    EXPECT_NE(first("Material shinines 3").find("'shininess'"), std::string::npos)
        << first("Material shinines 3");
}

}  // namespace
}  // namespace glibra::test
