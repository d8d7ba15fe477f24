// Viewing directions of length zero, singular matrices, mirrored matrices, and deep matrix stacks (exercises'
// accuracy table 16; NM03, NM04).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <variant>

#include "scene/view.h"
#include "support.h"

namespace glibra::stress {
namespace {

const char* const kMatricesView =
    "WindowSize 64 64\nBackground 0\nOrtho -1.5 1.5 -1.5 1.5\nLookAt 0 0 5 0 0 0 0 1 0\n";

glm::dmat4 modelViewOf(const std::string& text) {
    const scene::Scene scene = interpreted(text + "\nSphere\n");
    EXPECT_FALSE(hasError(scene.diagnostics)) << stress::text(scene.diagnostics);
    if (scene.frame.passes.empty() || scene.frame.passes[0].steps.empty()) return glm::dmat4(0.);
    return std::get<scene::Draw>(scene.frame.passes[0].steps[0]).modelView;
}

double largest(const glm::dmat4& matrix) {
    double value = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) value = std::max(value, std::abs(matrix[i][j]));
    return value;
}

/// The largest deviation of the upper left 3 x 3 from a rotation.
double notRigid(const glm::dmat4& m) {
    const glm::dmat3 linear(m);
    const glm::dmat3 rest = glm::transpose(linear) * linear - glm::dmat3(1.);
    double value = std::abs(glm::determinant(linear) - 1);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) value = std::max(value, std::abs(rest[i][j]));
    return value;
}

TEST(LookAt, WithoutADirectionIsRefused) {
    for (const char* each :
         {"LookAt 0 0 0 0 0 0 0 1 0", "LookAt 1 2 3 1 2 3 0 1 0", "LookAt 1e30 0 0 1e30 0 0 0 1 0"}) {
        const scene::Scene scene = interpreted(std::string(each) + "\nSphere\n");
        EXPECT_TRUE(has(scene.diagnostics, "glib-E13")) << each;
    }
}

TEST(LookAt, WithUpAlongTheViewUsesAnotherUp) {
    // `up` is along, against or nearly along the view direction, or zero; the eye is far away or close.
    for (const char* each :
         {"LookAt 0 5 0 0 0 0 0 1 0", "LookAt 0 5 0 0 0 0 0 -1 0", "LookAt 0 0 5 0 0 0 0 0 1",
          "LookAt 3 3 3 0 0 0 1 1 1", "LookAt .1 .2 .3 .2 .4 .6 .7 1.4 2.1", "LookAt 5 0 0 0 0 0 0 0 0",
          "LookAt 0 5 0 0 0 0 0 0 0", "LookAt 0 5 0 0 0 0 0 1e-300 0", "LookAt 1e6 1e6 1e6 0 0 0 1 1 1"}) {
        const scene::Scene scene = interpreted(std::string(each) + "\nSphere\n");
        EXPECT_TRUE(has(scene.diagnostics, "glib-W30")) << each;
        EXPECT_LT(notRigid(modelViewOf(each)), 1e-14) << each;
    }
}

TEST(LookAt, IsRigidWhereverTheEyeIs) {
    for (const char* each :
         {"LookAt 0 0 1e-30 0 0 0 0 1 0", "LookAt 0 0 1e30 0 0 0 0 1 0", "LookAt 0 0 1 0 0 0 0 1e-30 0",
          "LookAt 0 0 1 0 0 0 0 1e30 0", "LookAt 1e7 0 1 1e7 0 0 0 1 0", "LookAt 0 0 5 0 0 0 0 1e-6 1",
          "LookAt 1e-20 1 1e-20 0 0 0 1e-20 0 1"}) {
        const glm::dmat4 matrix = modelViewOf(each);
        EXPECT_LT(notRigid(matrix), 1e-13) << each;
        EXPECT_TRUE(scene::isFinite(matrix)) << each;
    }
}

TEST(LookAt, AlmostAlongUpStillShowsTheObject) {
    // The angle between view and up is below the precision of floats, but not below that of doubles.
    const FloatPicture picture =
        draw("WindowSize 65 65\nBackground 0\nPerspective 40\nLookAt 0 5 0 0 0 0 1e-9 1 0\n" +
                 std::string(kProgram) + "Sphere 1 60 30\n",
             shaded("normalize(vN)"));
    EXPECT_EQ(picture.nonFinite(), 0U);
    const auto centre = picture.at(32, 32);
    EXPECT_NEAR(centre[2], 1, 1e-3);  // the normal faces the eye
}

TEST(SingularMatrices, GiveFiniteValuesToShaders) {
    for (const char* transforms :
         {"Scale 1 1 0", "Scale 0 1 1", "Scale 0", "Scale 1 0 0", "Scale 1e-20 1 1", "Scale 1e-30",
          "Scale 1e-38", "Scale 1e-40", "Scale 1e-44", "Scale 1e30", "Scale 1e38", "Scale 3e38",
          "Scale 1e-30 1e-30 0", "Scale 1e-38 1 1e38", "Rotate 30 1 2 3\nScale 1 0 1\nRotate 50 3 2 1",
          "Scale 1e-8 1 1\nRotate 45 0 0 1\nScale 1e8 1 1", "Translate 1e30 0 0\nScale 1e-30"}) {
        // The picture also has a visible quad, so that the matrices are evaluated.
        const auto values = [&](const std::string& expression) {
            return Files{{"v.vert", "#version 330 core\nout vec3 vValue;\nvoid main() {\n  vValue = " +
                                        expression + ";\n  gl_Position = vec4(aVertex.xy, 0., 1.);\n}\n"},
                         {"f.frag",
                          "#version 330 core\nin vec3 vValue;\nout vec4 fColor;\n"
                          "void main() { fColor = vec4(vValue, 1.); }\n"}};
        };
        for (const char* expression :
             {"uNormalMatrix[0]", "uNormalMatrix[1]", "uNormalMatrix[2]", "uModelViewMatrixInverse[0].xyz",
              "uModelViewMatrixInverse[1].xyz", "uModelViewMatrixInverse[2].xyz",
              "uModelViewMatrixInverse[3].xyz", "gl_ModelViewProjectionMatrixInverse[0].xyz",
              "gl_ModelViewProjectionMatrixInverse[3].xyz", "gl_ModelViewMatrixInverseTranspose[0].xyz",
              "uModelViewProjectionMatrix[3].xyz"}) {
            const FloatPicture picture =
                draw(std::string(kMatricesView) + transforms + "\n" + kProgram + "QuadXY 0 1 1 1\n",
                     values(expression));
            EXPECT_EQ(picture.nonFinite(), 0U) << transforms << " " << expression;
        }
    }
}

TEST(SingularMatrices, FlattenWithTheRightNormal) {
    // A sphere that is flattened along z is a disk that faces z. In a shader the square of a length must fit
    // into a float, which is possible down to scales of about 1e-19.
    for (const char* transforms : {"Scale 1 1 0", "Scale 1 1 1e-15", "Scale 1e-10 1e-10 0\nScale 1e10"}) {
        const FloatPicture picture =
            draw(kMatricesView + std::string(transforms) + "\n" + kProgram + "Sphere 1 41 20\n",
                 shaded("vec3(abs(normalize(vN).z), vEC.xy)"));
        EXPECT_EQ(picture.nonFinite(), 0U) << transforms;
        EXPECT_NEAR(picture.at(20, 27)[0], 1, 1e-5) << transforms;
    }
}

TEST(SingularMatrices, KeepNormalsWhateverTheScale) {
    // The normal matrix keeps directions even where its elements would not fit into floats.
    for (const double scale : {1e-300, 1e-200, 1e-45, 1e-40, 1e-38, 1e-20, 1., 1e20, 1e38, 3e38})
        for (const glm::dvec3& shape : {glm::dvec3(1, 1, 1), glm::dvec3(1, .5, .25), glm::dvec3(1, 1, 0)}) {
            const glm::dmat4 turned = scene::rotation(33, {1, 2, 3}) * scene::scaling(shape);
            const glm::dmat3 expected = scene::normalMatrix(turned);
            const glm::dmat3 seen = scene::normalMatrix(scene::scaling(glm::dvec3(scale)) * turned);
            double most = 0;
            for (int i = 0; i < 3; ++i)
                for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(seen[i][k]));
            EXPECT_LE(most, 3.4e38) << scale;
            EXPECT_GE(most, 1.1e-38) << scale;
            const glm::dvec3 n = glm::normalize(glm::dvec3(.1, .2, .9));
            EXPECT_LT(glm::length(glm::normalize(seen / most * n) - glm::normalize(expected * n)), 1e-14)
                << scale;
        }
}

TEST(SingularMatrices, AreInvertedToTheConditionOfTheMatrix) {
    // M * M^-1 for scales that approach a singular matrix. Rotations make all elements irregular.
    for (int digits = 0; digits <= 12; ++digits) {
        const double factor = std::pow(10., -digits);
        const glm::dmat4 matrix =
            scene::rotation(33, {1, 2, 3}) * scene::scaling({1, factor, 1}) * scene::rotation(71, {3, -1, 2});
        const glm::dmat4 inverse = scene::inverseOrZero(matrix);
        ASSERT_GT(largest(inverse), 0) << factor;
        EXPECT_LT(largest(matrix * inverse - glm::dmat4(1.)), 8 * 2.3e-16 / factor) << factor;
        // The error of the flattened direction is also limited by the condition number.
        const glm::dvec3 flat = glm::dmat3(scene::rotation(33, {1, 2, 3})) * glm::dvec3(0, 1, 0);
        const glm::dvec3 normal =
            scene::normalMatrix(matrix) *
            (glm::transpose(glm::dmat3(scene::rotation(71, {3, -1, 2}))) * glm::dvec3(0, 1, 0));
        EXPECT_LT(glm::length(glm::cross(glm::normalize(normal), flat)), 1e-15 / factor) << factor;
    }
}

TEST(MirroredMatrices, ShowTheMirroredPictureAndTurnTheFaces) {
    // The mirrored picture shows at x what the original shows at -x, with front and back faces exchanged.
    const std::string shape = "Translate .3 .1 0\nRotate 20 1 1 0\nTorus .6 .25 12 20\n";
    const Files files = shaded("vec3(gl_FrontFacing ? 1. : 0., vMC.x, vMC.y)");
    const std::string view = std::string(kMatricesView) + kProgram;
    const FloatPicture straight = draw(view + shape, files);
    const FloatPicture mirrored = draw(view + "Scale -1 1 1\n" + shape, files);
    ASSERT_EQ(mirrored.width, 64);
    std::size_t differing = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const auto a = straight.at(x, y);
            const auto b = mirrored.at(63 - x, y);
            const bool background = a[0] == 0 && a[1] == 0 && b[1] == 0;
            if (background) continue;
            const bool same =
                b[0] == 1 - a[0] && std::abs(b[1] - a[1]) < 1e-5F && std::abs(b[2] - a[2]) < 1e-5F;
            differing += same ? 0 : 1;
        }
    // The fill rule, which decides about edges exactly through the centre of a pixel, is not mirrored.
    EXPECT_LE(differing, 4U);
    EXPECT_GT(straight.count([](const auto& rgb) { return rgb[0] == 1; }), 500U);
}

TEST(MirroredMatrices, KeepNormalsOnTheirSide) {
    for (std::uint32_t i = 0; i < 300; ++i) {
        const glm::dvec3 factors(spread(3 * i) < 0 ? -.3 : 2., spread(3 * i + 1) < 0 ? -1000. : 1.,
                                 spread(3 * i + 2) < 0 ? -1. : .001);
        const glm::dmat4 matrix = scene::rotation(180 * spread(i + 900), {1, .5, -2}) *
                                  scene::scaling(factors) *
                                  scene::rotation(180 * spread(i + 1900), {spread(i), 1, 2});
        // A point on the side of a plane to which its normal points stays on that side.
        const glm::dvec3 u(spread(i + 50), spread(i + 60), 1);
        const glm::dvec3 v(1, spread(i + 70), spread(i + 80));
        const glm::dvec3 n = glm::cross(u, v);
        const glm::dvec3 moved = scene::normalMatrix(matrix) * n;
        const glm::dmat3 linear(matrix);
        EXPECT_GT(glm::dot(moved, linear * n), 0) << i;
        EXPECT_LT(std::abs(glm::dot(moved, linear * u)), 1e-11 * glm::length(moved) * glm::length(linear * u))
            << i;
        EXPECT_LT(std::abs(glm::dot(moved, linear * v)), 1e-11 * glm::length(moved) * glm::length(linear * v))
            << i;
    }
}

TEST(MatrixStack, ReturnsEveryMatrixFromItsFullDepth) {
    std::string text;
    for (int i = 0; i < 256; ++i) text += "PushMatrix\nRotate 1.40625 0 0 1\nTranslate 1 0 0\n";
    const glm::dmat4 deepest = modelViewOf(text);
    // 256 turns by 360/256 degrees with a step after each form a closed polygon.
    EXPECT_LT(largest(deepest - glm::dmat4(1.)), 1e-11);
    std::string back = text;
    for (int i = 0; i < 255; ++i) back += "PopMatrix\n";
    EXPECT_EQ(modelViewOf(back + "PopMatrix"), glm::dmat4(1.));
    const scene::Scene tooDeep = interpreted(text + "PushMatrix\nSphere\n");
    EXPECT_TRUE(has(tooDeep.diagnostics, "glib-E15"));
    const scene::Scene tooMany = interpreted(back + "PopMatrix\nPopMatrix\nSphere\n");
    EXPECT_TRUE(has(tooMany.diagnostics, "glib-E06"));
}

TEST(MatrixStack, TenThousandRotationsAddUp) {
    std::string text;
    for (int i = 0; i < 10'000; ++i) text += "Rotate .0361 1 2 3\n";
    const glm::dmat4 once = scene::rotation(361, {1, 2, 3});
    const glm::dmat4 chained = modelViewOf(text);
    EXPECT_LT(largest(chained - once), 1e-12);
    EXPECT_LT(notRigid(chained), 1e-11);
}

TEST(MatrixStack, ScalesThatLeaveTheRangeAreRefusedAndThoseThatReturnAreExact) {
    std::string text;
    for (int i = 0; i < 100; ++i) text += "Scale 4\n";
    const scene::Scene scene = interpreted(text + "Sphere\n");
    EXPECT_TRUE(has(scene.diagnostics, "glib-E31"));
    std::string there;
    for (int i = 0; i < 60; ++i) there += "Scale 4\n";
    for (int i = 0; i < 60; ++i) there += "Scale .25\n";
    EXPECT_EQ(modelViewOf(there), glm::dmat4(1.));
    std::string vanishing;
    for (int i = 0; i < 400; ++i) vanishing += "Scale .125\n";
    for (int i = 0; i < 400; ++i) vanishing += "Scale 8\n";
    EXPECT_LE(largest(modelViewOf(vanishing)), 1);
}

}  // namespace
}  // namespace glibra::stress
