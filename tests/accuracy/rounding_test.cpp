// Transforms, curves, fractals, rays and spheres: the effects of rounding where theory predicts them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/core/device.h"
#include "bench/core/figure.h"
#include "bench/reference/exact.h"
#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

using Transforms = FiguresOf<measureTransforms>;

TEST_F(Transforms, AreSound) {
    expectSound(figures);
    EXPECT_EQ(figures.size(), 4U);
}

TEST_F(Transforms, FloatMatricesLoseADigitForEachDecadeOfDistance) {
    EXPECT_NEAR(fittedOrder(curve("distance", "CPU, float matrices"), 100), 1, .1);
    EXPECT_NEAR(fittedOrder(curve("distance", "shader, model then view"), 100), 1, .1);
    for (const char* name :
         {"CPU, product in double, rounded once", "shader, product in double, rounded once"})
        for (const Point& point : curve("distance", name).points)
            EXPECT_LT(point.error, 2e-6) << name << ", " << point.label;
}

TEST_F(Transforms, DoubleIsNineDigitsBetterThanFloat) {
    for (const char* name : {"distance", "size"}) {
        const Curve &single = curve(name, "CPU, float matrices"), &twice = curve(name, "CPU, double");
        for (std::size_t i = 0; i < single.points.size(); ++i) {
            // 2^-24 against 2^-53, within one or two orders of magnitude, depending on the roundings.
            const double ratio = single.points[i].error / twice.points[i].error;
            EXPECT_GT(ratio, 1e7) << name << ", " << single.points[i].label;
            EXPECT_LT(ratio, 1e11) << name << ", " << single.points[i].label;
        }
    }
    for (const Point& point : curve("distance", "shader, double").points) EXPECT_LT(point.error, 1e-7);
}

TEST_F(Transforms, ChainsDriftAndOneAngleDoesNot) {
    const auto last = [](const char* name) { return curve("chain", name).points.back().error; };
    EXPECT_GT(last("float matrices multiplied"), 1e-5);
    EXPECT_LT(last("angle in double, matrix rounded once"), 6e-8) << "half a unit in the last place of 1";
    EXPECT_LT(last("double matrices multiplied"), 1e-11);
    EXPECT_GT(last("shader, float matrices multiplied"), 1e-6);
}

TEST_F(Transforms, OnlyTheModelMatrixItselfIsWrongForNormals) {
    for (const Curve& curve : figure("normal-matrix").curves) {
        EXPECT_LT(curve.points.front().error, 1e-4) << curve.name << ": a rotation alone is right either way";
        if (curve.name == "the model matrix itself")
            EXPECT_GT(curve.points.back().error, 45);
        else
            EXPECT_LT(curve.points.back().error, .01) << curve.name;
    }
}

TEST(Exact, KnowsPiAndRightAngles) {
    const ExactVector x = exact(glm::dvec3(1, 0, 0));
    EXPECT_DOUBLE_EQ(degreesBetween(x, {0, 3, 0}), 90);
    EXPECT_NEAR(degreesBetween(x, {1, 1e-12, 0}), 1e-12 * 180 / 3.14159265358979, 1e-24);
    EXPECT_EQ(distance(x, {1, 0, 0}), 0);
    EXPECT_NEAR(distance(x, {1, 1e-30, 0}), 1e-30, 1e-44);
}

TEST(ShaderValues, ComeBackInTheirOrder) {
    Bench bench({.quick = true});
    std::vector<Four> inputs;
    for (int i = 0; i < 300; ++i) {
        const auto value = static_cast<float>(i);
        inputs.push_back({value, 1, 2, 3});
        inputs.push_back({2 * value, 0, 0, 0});
    }
    const ShaderValues shader(bench, "vec4 value() { return vec4(given(0).x, given(1).x, given(0).w, 7.); }",
                              inputs, 2);
    const std::vector<Four> values = shader.values();
    ASSERT_EQ(values.size(), 300U);
    for (std::size_t i = 0; i < 300; ++i)
        EXPECT_EQ(values[i], (Four{static_cast<float>(i), 2 * static_cast<float>(i), 3, 7})) << i;
    EXPECT_THROW(ShaderValues(bench, "vec4 value() { return 1; }", inputs), Failed);
}

TEST(Curves, ConvergeWithTheOrdersOfTheirMethods) {
    const std::vector<Figure> figures = quickFigures(measureCurves);
    expectSound(figures);
    const Figure& parameter = figureOf(figures, "parameter");
    for (const Point& point : curveOf(parameter, "float, t = i / n").points)
        EXPECT_LE(point.error, std::ldexp(1., -25)) << "half a unit in the last place below 1";
    EXPECT_GT(curveOf(parameter, "float, t += dt").points.back().error, 1e-4);
    EXPECT_LT(curveOf(parameter, "float, t += dt with compensation").points.back().error, 1e-6);
    // How a driver rounds decides how much is lost: 1e-4 on llvmpipe, 5e-5 on zink of Mesa 25.
    EXPECT_GT(curveOf(parameter, "shader, t += dt (at the end)").points.back().error, 2e-5);

    for (const char* name : {"chords", "chords-step"}) {
        const Figure& chords = figureOf(figures, name);
        const Curve &fixed = curveOf(chords, "fixed steps of t"),
                    &adaptive = curveOf(chords, "halved until flat");
        EXPECT_NEAR(fittedOrder(fixed, 250), -2, .1) << name;
        EXPECT_NEAR(fittedOrder(adaptive, 30), -2, .5) << name;
        for (const Point& point : adaptive.points) {
            const double tolerance = std::ldexp(1., std::stoi(point.label.substr(point.label.find('^') + 1)));
            EXPECT_LT(point.error, 1.5 * tolerance) << name << ", " << point.label;
        }
    }
    const Figure& step = figureOf(figures, "chords-step");
    EXPECT_LT(3 * curveOf(step, "halved until flat").points.back().setting,
              curveOf(step, "fixed steps of t").points.back().setting);
    EXPECT_LT(curveOf(step, "halved until flat").points.back().error,
              4 * curveOf(step, "fixed steps of t").points.back().error);

    const Figure& streamlines = figureOf(figures, "streamlines");
    EXPECT_NEAR(fittedOrder(curveOf(streamlines, "midpoint"), 2000), -2, .2);
    EXPECT_NEAR(fittedOrder(curveOf(streamlines, "Runge-Kutta 4"), 2000), -4, .4);
    const Curve& adaptive = curveOf(streamlines, "Dormand-Prince, adaptive");
    EXPECT_LT(adaptive.points.back().error, 1e-3 * adaptive.points.front().error);
    EXPECT_TRUE(std::ranges::is_sorted(adaptive.points, std::greater<>(), &Point::error));
}

TEST(Fractals, LoseTheirPixelsWhereTheMantissaEnds) {
    const std::vector<Figure> figures = quickFigures(measureFractals);
    expectSound(figures);
    const Figure& figure = figures.front();
    const auto wrong = [&](const char* curve, std::size_t point) {
        return curveOf(figure, curve).points.at(point).error;
    };
    // Zooms 1, 1e5, 1e10 and 1e15, at 32 pixels per side: a pixel is 1e-1, 1e-6, 1e-11, 1e-16 wide.
    for (const char* name : {"CPU, float", "shader, float"}) {
        EXPECT_LT(wrong(name, 0), .05) << name;
        EXPECT_GT(wrong(name, 2), .5) << name;
    }
    for (const char* name : {"CPU, double", "shader, double"}) {
        EXPECT_LT(wrong(name, 2), .05) << name;
        EXPECT_GT(wrong(name, 3), .1) << name;
    }
    for (const char* name : {"CPU, float by perturbation", "shader, float by perturbation"})
        for (std::size_t i = 1; i < 4; ++i) EXPECT_LT(wrong(name, i), .05) << name << ", " << i;
}

TEST(RaySphere, StableFormStaysWithinTheRoundingOfTheDistance) {
    const std::vector<Figure> figures = quickFigures(measureRaySphere);
    expectSound(figures);
    const Figure& hit = figureOf(figures, "hit");
    for (const char* name : {"CPU, float, stable", "shader, stable"})
        for (const Point& point : curveOf(hit, name).points)
            EXPECT_LT(point.error, 4 * std::ldexp(1., -23) * point.setting) << name << ", " << point.label;
    EXPECT_GT(curveOf(hit, "CPU, float, textbook").points.back().error, 1) << "the whole sphere is lost";
    EXPECT_LT(curveOf(hit, "CPU, double, stable").points.back().error, 1e-8);
    const Figure& decision = figureOf(figures, "decision");
    const Curve &textbook = curveOf(decision, "CPU, float, textbook"),
                &stable = curveOf(decision, "CPU, float, stable");
    for (std::size_t i = 0; i < stable.points.size(); ++i)
        EXPECT_LE(stable.points[i].error, textbook.points[i].error) << stable.points[i].label;
}

}  // namespace
}  // namespace glibra::bench::test
