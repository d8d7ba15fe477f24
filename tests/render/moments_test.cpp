// Scenes that change with time, and uniforms that draws set (language, 12): pictures that must be equal to
// those of classic scenes, bit for bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "scene_text.h"

namespace glibra::test {
namespace {

using Files = std::map<std::string, std::string>;

const Files kMomentFiles{
    {"a.vert",
     "#version 330 core\nout vec3 vN;\nvoid main() { vN = aNormal; gl_Position = "
     "uModelViewProjectionMatrix * "
     "aVertex; }\n"},
    {"a.frag",
     "#version 330 core\nin vec3 vN;\nout vec4 fColor;\nuniform vec3 uColor = vec3(.2, .4, "
     ".6);\nuniform float "
     "uScale;\nvoid main() { fColor = vec4(uColor * (.5 + uScale * abs(vN.z)), 1.); }\n"}};

const std::string kMomentStart =
    "WindowSize 64 64\nBackground 0 0 0\nVertex a.vert\nFragment a.frag\nProgram P uScale .5\n";

RenderOptions atTime(double time) {
    RenderOptions options;
    options.time = time;
    options.view = ViewPolicy::glman;
    return options;
}

TEST(Moments, AnExpressionGivesThePictureOfItsValue) {
    for (const double time : {0., .5, 2.}) {
        char classic[200];
        std::snprintf(classic, sizeof classic,
                      "LookAt 0 0 5 0 0 0 0 1 0\nTranslate %.17g 0 0\nSphere %.17g\n", .5 * time - .25,
                      .5 + .25 * time);
        const std::string modern =
            "LookAt 0 0 5 0 0 0 0 1 0\nTranslate (.5*time - .25) 0 0\nSphere (.5 + .25*time)\n";
        EXPECT_TRUE(isSame(picture(kMomentStart + classic, kMomentFiles, atTime(time)),
                           picture(kMomentStart + modern, kMomentFiles, atTime(time))))
            << time;
    }
}

TEST(Moments, TheCameraEyeGivesThePictureOfLookAtAndPerspective) {
    EXPECT_TRUE(
        isSame(picture(kMomentStart + "Perspective 40 .1 100\nLookAt 1 2 5 0 0 0 0 1 0\nBox 1\n",
                       kMomentFiles, atTime(0)),
               picture(kMomentStart + "Camera eye LookAt 1 2 5 0 0 0 0 1 0 Perspective 40 .1 100\nBox 1\n",
                       kMomentFiles, atTime(0))));
}

TEST(Moments, SetGivesThePictureOfSeveralPrograms) {
    const std::string view = "LookAt 0 0 5 0 0 0 0 1 0\n";
    const std::string boxes[] = {"Translate -1 0 0\nBox .8\n", "Translate 1 0 0\nBox .8\n",
                                 "Translate 0 1 0\nBox .8\n"};
    const std::string classic = kMomentStart + view + "Program A uScale .5 uColor {1 0 0}\n" + boxes[0] +
                                "Program B uScale .1 uColor {0 1 0}\n" + boxes[1] + "Program C uScale .5\n" +
                                boxes[2];
    // The third box has the initial value of uColor and the program's uScale again.
    const std::string modern = kMomentStart + view + "Group\nSet uColor {1 0 0}\n" + boxes[0] +
                               "Set uColor {0 1 0} uScale .1\n" + boxes[1] +
                               "EndGroup\nTranslate -1 0 0\nTranslate 1 0 0\n" + boxes[2];
    EXPECT_TRUE(isSame(picture(classic, kMomentFiles, atTime(0)), picture(modern, kMomentFiles, atTime(0))));
}

TEST(Moments, AVariableIsSetLikeAUniform) {
    const std::string scene = kMomentStart + "Let size <.1 .5 2>\nLookAt 0 0 5 0 0 0 0 1 0\nSphere (size)\n";
    RenderOptions options = atTime(0);
    options.set = {"size=1.25"};
    const Result<Picture> set = tryPicture(scene, kMomentFiles, options);
    ASSERT_TRUE(set) << text(set.diagnostics);
    EXPECT_FALSE(has(set.diagnostics, "glib-W23")) << "no uniform is missing";
    EXPECT_TRUE(isSame(*set.value, picture(kMomentStart + "LookAt 0 0 5 0 0 0 0 1 0\nSphere 1.25\n",
                                           kMomentFiles, atTime(0))));
}

TEST(Moments, AShaderInTheScriptIsReportedOnItsLine) {
    const Result<Picture> wrong = tryPicture(
        "Vertex a.vert\nFragment inline\n#version 330 core\nout vec4 fColor;\nvoid main() { fColor = "
        "missing; }\nEndFragment\nProgram P\nBox\n",
        kMomentFiles);
    ASSERT_FALSE(wrong);
    const auto error =
        std::ranges::find_if(wrong.diagnostics, [](const Diagnostic& each) { return each.id == "glsl-E01"; });
    ASSERT_NE(error, wrong.diagnostics.end()) << text(wrong.diagnostics);
    EXPECT_EQ(error->place.line, 5);
}

TEST(Moments, AProblemOfAnExpressionHasItsPlace) {
    const Result<Picture> wrong =
        tryPicture(kMomentStart + "Translate (1 / (time - 1)) 0 0\nBox\n", kMomentFiles, atTime(1));
    ASSERT_FALSE(wrong);
    EXPECT_TRUE(has(wrong.diagnostics, "expr-E06")) << text(wrong.diagnostics);
    EXPECT_EQ(wrong.diagnostics.front().place.line, 6);
}

}  // namespace
}  // namespace glibra::test
