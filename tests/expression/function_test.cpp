// Every function against the standard library, glm, or its definition.

#include "expression/functions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <set>
#include <string>
#include <vector>

#include "base/matrices.h"
#include "support.h"

namespace glibra::expression::test {
namespace {

struct Case {
    std::string text;
    std::vector<double> expected;
    double tolerance = 0;
};

std::vector<double> numbers(const glm::dmat4& matrix) {
    return {glm::value_ptr(matrix), glm::value_ptr(matrix) + 16};
}
std::vector<double> numbers(const glm::dmat3& matrix) {
    return {glm::value_ptr(matrix), glm::value_ptr(matrix) + 9};
}
std::vector<double> numbers(const glm::dvec3& vector) {
    return {vector.x, vector.y, vector.z};
}

const glm::dmat3 kM3(2, 0, 1, 1, 3, 0, 0, 1, 4);
const glm::dmat4 kM4(2, 0, 1, 0, 1, 3, 0, 0, 0, 1, 4, 0, 5, 6, 7, 1);
const glm::dvec3 kV(1, 2, 3);

std::vector<Case> cases() {
    const double rounding = 4e-16;
    return {
        // Constructors
        {"float(true)", {1}},
        {"float(v)", {1}},
        {"int(-2.7)", {-2}},
        {"int(2.7)", {2}},
        {"bool(a)", {1}},
        {"bool(0)", {0}},
        {"vec2(a, b)", {2, 3}},
        {"vec2(v)", {1, 2}},
        {"vec3(a)", {2, 2, 2}},
        {"vec3(u, b)", {1, 2, 3}},
        {"vec3(a, w)", {2, 1, 2}},
        {"vec4(v, 1)", {1, 2, 3, 1}},
        {"vec4(u, u)", {1, 2, 1, 2}},
        {"vec3(bvec3(true, false, true))", {1, 0, 1}},
        {"bvec2(yes, no)", {1, 0}},
        {"bvec3(v - 1)", {0, 1, 1}},
        {"bvec4(a)", {1, 1, 1, 1}},
        {"mat2(a)", {2, 0, 0, 2}},
        {"mat2(1, 2, 3, 4)", {1, 2, 3, 4}},
        {"mat2(m3)", {2, 0, 1, 3}},
        {"mat3(v, v * 2, v * 3)", {1, 2, 3, 2, 4, 6, 3, 6, 9}},
        {"mat3(m4)", numbers(glm::dmat3(kM4))},
        {"mat4(m3)", numbers(glm::dmat4(kM3))},
        {"mat4(1)", numbers(glm::dmat4(1))},
        {"mat4(w, w, w, u, u)", {1, 2, 3, 4, 1, 2, 3, 4, 1, 2, 3, 4, 1, 2, 1, 2}},
        // Numbers
        {"radians(180 * a)", {2 * std::acos(-1.)}, rounding},
        {"degrees(pi * a)", {360}, 1e-13},
        {"sin(a)", {std::sin(2.)}},
        {"sin(v)", {std::sin(1.), std::sin(2.), std::sin(3.)}},
        {"cos(a)", {std::cos(2.)}},
        {"tan(a)", {std::tan(2.)}},
        {"asin(x)", {std::asin(-.5)}},
        {"acos(x)", {std::acos(-.5)}},
        {"atan(a)", {std::atan(2.)}},
        {"atan(x, a)", {std::atan2(-.5, 2.)}},
        {"atan(u, u * 2)", {std::atan2(1., 2.), std::atan2(2., 4.)}},
        {"sinh(a)", {std::sinh(2.)}, rounding * 2},
        {"cosh(a)", {std::cosh(2.)}, rounding * 2},
        {"tanh(a)", {std::tanh(2.)}, rounding * 2},
        {"asinh(a)", {std::asinh(2.)}, rounding * 2},
        {"acosh(a)", {std::acosh(2.)}, rounding * 2},
        {"atanh(x)", {std::atanh(-.5)}, rounding * 2},
        {"pow(a, b)", {8}},
        {"pow(v, v)", {1, 4, 27}},
        {"exp(a)", {std::exp(2.)}},
        {"log(a)", {std::log(2.)}},
        {"exp2(b)", {8}},
        {"log2(a * 4)", {3}},
        {"sqrt(a)", {std::sqrt(2.)}},
        {"inversesqrt(a + 2)", {.5}},
        {"abs(x)", {.5}},
        {"sign(vec3(x, 0, a))", {-1, 0, 1}},
        {"floor(x)", {-1}},
        {"trunc(x * 3)", {-1}},
        {"round(vec4(.5, 1.5, 2.5, -.5) * (a / 2))", {1, 2, 3, -1}},
        {"roundEven(vec4(.5, 1.5, 2.5, -2.5) * (a / 2))", {0, 2, 2, -2}},
        {"roundEven(2.4) + roundEven(2.6)", {5}},
        {"ceil(x)", {0}},
        {"fract(x * 3)", {.5}},
        {"mod(x, a)", {1.5}},
        {"mod(v, 2)", {1, 0, 1}},
        {"mod(v, vec3(2, 3, -2))", {1, 2, -1}},
        {"mod(-1e-20 * a, 1)", {0}},
        {"min(a, b)", {2}},
        {"min(v, 2)", {1, 2, 2}},
        {"min(v, v.zyx)", {1, 2, 1}},
        {"max(a, b)", {3}},
        {"max(v, 2)", {2, 2, 3}},
        {"max(v, v.zyx)", {3, 2, 3}},
        {"clamp(c, a, b)", {3}},
        {"clamp(v, 1.5, 2.5)", {1.5, 2, 2.5}},
        {"clamp(v, v.zyx - 3, v)", {1, 2, 3}},
        {"mix(a, c, .5)", {3.5}},
        {"mix(v, v * 3, .5)", {2, 4, 6}},
        {"mix(v, v * 3, vec3(0, .5, 1))", {1, 4, 9}},
        {"mix(a, c, yes)", {5}},
        {"mix(v, v * 3, bvec3(false, true, false))", {1, 6, 3}},
        {"step(a, b)", {1}},
        {"step(2, v)", {0, 1, 1}},
        {"step(v, vec3(2))", {1, 1, 0}},
        {"smoothstep(a, c, b)", {7. / 27}, rounding},
        {"smoothstep(1, 3, v)", {0, .5, 1}},
        {"smoothstep(vec2(0), vec2(2), u)", {.5, 1}},
        {"isnan(a)", {0}},
        {"isnan(sqrt(x))", {1}},
        {"isnan(vec2(a, 0 / (a - a)))", {0, 1}},
        {"isinf(a / (a - a))", {1}},
        {"isinf(log(u - 1))", {1, 0}},
        {"isnan(normalize(v - v)).x", {1}},
        // Vectors
        {"length(v)", {std::sqrt(14.)}, rounding * 2},
        {"length(x)", {.5}},
        {"length(vec2(3e200, 4e200))", {5e200}, 1e185},
        {"distance(v, v.zyx)", {std::sqrt(8.)}, rounding * 2},
        {"dot(v, v.zyx)", {10}},
        {"dot(a, b)", {6}},
        {"cross(v, v.yzx)", numbers(glm::cross(kV, glm::dvec3(2, 3, 1)))},
        {"normalize(v)", numbers(glm::normalize(kV)), rounding},
        {"normalize(x)", {-1}},
        {"reflect(v, vec3(0, 1, 0))", {1, -2, 3}},
        {"refract(normalize(v), vec3(0, 0, -1), .7)",
         numbers(glm::refract(glm::normalize(kV), glm::dvec3(0, 0, -1), .7)), rounding},
        {"refract(normalize(vec3(9, 0, -1)), vec3(0, 0, 1), 1.5)", {0, 0, 0}},
        {"faceforward(v, v, v)", {-1, -2, -3}},
        {"faceforward(v, -v, v)", {1, 2, 3}},
        // Comparisons
        {"lessThan(v, v.zyx)", {1, 0, 0}},
        {"lessThanEqual(v, v.zyx)", {1, 1, 0}},
        {"greaterThan(v, v.zyx)", {0, 0, 1}},
        {"greaterThanEqual(v, v.zyx)", {0, 1, 1}},
        {"equal(v, v.zyx)", {0, 1, 0}},
        {"equal(bvec2(yes, no), bvec2(yes))", {1, 0}},
        {"notEqual(v, v.zyx)", {1, 0, 1}},
        {"notEqual(bvec2(yes, no), bvec2(yes))", {0, 1}},
        {"any(bvec2(yes, no))", {1}},
        {"any(bvec2(no, no))", {0}},
        {"all(bvec2(yes, no))", {0}},
        {"all(bvec2(yes, yes))", {1}},
        {"not(bvec2(yes, no))", {0, 1}},
        {"v == v", {1}},
        {"v != v.xyy", {1}},
        {"m3 == m3", {1}},
        {"yes == no", {0}},
        // Matrices
        {"matrixCompMult(m3, m3)", numbers(glm::matrixCompMult(kM3, kM3))},
        {"outerProduct(v, v.zyx)", numbers(glm::outerProduct(kV, glm::dvec3(3, 2, 1)))},
        {"transpose(m4)", numbers(glm::transpose(kM4))},
        {"determinant(m3)", {glm::determinant(kM3)}},
        {"determinant(mat2(1, 2, 3, 4))", {-2}},
        {"determinant(m4)", {glm::determinant(kM4)}},
        {"inverse(m4)", numbers(glm::inverse(kM4)), 1e-15},
        {"inverse(m4)", numbers(base::inverseOrZero(kM4))},
        {"inverse(m3) * m3", numbers(glm::dmat3(1)), 1e-15},
        {"inverse(mat2(1, 2, 3, 4)) * mat2(1, 2, 3, 4)", {1, 0, 0, 1}, 1e-15},
        {"m3 * m3", numbers(kM3 * kM3)},
        {"m4 * transpose(m4)", numbers(kM4 * glm::transpose(kM4))},
        {"m3 * v", numbers(kM3 * kV)},
        {"v * m3", numbers(kV * kM3)},
        {"m3 * a", numbers(kM3 * 2.)},
        {"a * m3", numbers(kM3 * 2.)},
        {"m3 + m3", numbers(kM3 + kM3)},
        {"m3 / a - 1", numbers(kM3 / 2. - 1.)},
        {"(m4 * vec4(v, 1)).xyz", numbers(glm::dvec3(kM4 * glm::dvec4(kV, 1)))},
        {"-v", {-1, -2, -3}},
        {"1 - v", {0, -1, -2}},
        {"6 / v", {6, 3, 2}},
        // Transforms: the same functions as the commands have, bit for bit
        {"translate(v)", numbers(base::translation(kV))},
        {"translate(a, b, c)", numbers(base::translation({2, 3, 5}))},
        {"rotate(30, v)", numbers(base::rotation(30, kV))},
        {"rotate(a, 0, 0, 1)", numbers(base::rotation(2, {0, 0, 1}))},
        {"rotate(90, 0, 0, 1) * vec4(1, 0, 0, 1)", {0, 1, 0, 1}},
        {"scale(v)", numbers(base::scaling(kV))},
        {"scale(a, b, c)", numbers(base::scaling({2, 3, 5}))},
        {"scale(a)", numbers(base::scaling({2, 2, 2}))},
        {"perspective(50, 1.5, .1, 100)", numbers(base::perspectiveProjection(50, 1.5, .1, 100))},
        {"perspective(50, 1.5, .1, 100)", numbers(glm::perspective(glm::radians(50.), 1.5, .1, 100.)), 1e-15},
        {"ortho(-1, 2, -3, 4, -5, 6)", numbers(glm::ortho(-1., 2., -3., 4., -5., 6.)), rounding},
        {"frustum(-1, 2, -3, 4, .5, 6)", numbers(glm::frustum(-1., 2., -3., 4., .5, 6.)), rounding * 4},
        {"lookAt(v, vec3(0), vec3(0, 1, 0))", numbers(*base::viewingMatrix(kV, glm::dvec3(0), {0, 1, 0}))},
        {"lookAt(v, vec3(0), vec3(0, 1, 0))", numbers(glm::lookAt(kV, glm::dvec3(0), glm::dvec3(0, 1, 0))),
         1e-15},
        // Motion: time is 2.5
        {"bounce(0, 2, 1)", {1.5}},
        {"bounce(0, 2, 2)", {1}},
        {"bounce(2, 0, 1)", {.5}},
        {"bounce(0, 2, -1)", {1.5}},
        {"bounce(3, 3, 1)", {3}},
        {"bounce(-1, 4, 2)", {4}},
        {"wrap(1, 2, 1)", {1.5}},
        {"wrap(0, 2.5, 1)", {0}},
        {"wrap(1, 3, -1)", {2.5}},
        {"wrap(3, 3, 1)", {3}},
        // Whole numbers
        {"6 & 3", {2}},
        {"6 | 3", {7}},
        {"6 ^ 3", {5}},
        {"~0", {-1}},
        {"-1.9 & 7", {7}},
        {"3 << 4", {48}},
        {"-5 >> 1", {-3}},
        {"48.9 >> 4", {3}},
        {"1 >> 63", {0}},
    };
}

TEST(ExpressionFunctions, GiveTheValuesOfAnotherImplementation) {
    for (const Case& each : cases()) {
        const Value value = valueOf(each.text);
        ASSERT_EQ(value.type.size(), each.expected.size()) << each.text;
        for (std::size_t k = 0; k < each.expected.size(); ++k)
            EXPECT_NEAR(value.components[k], each.expected[k], each.tolerance)
                << each.text << " [" << k << "]";
    }
}

TEST(ExpressionFunctions, EachFormOfEachFunctionIsAmongTheCases) {
    std::string all;
    for (const Case& each : cases()) all += each.text + "\n";
    std::set<std::string_view> missing;
    for (const FunctionRow& row : functionTable())
        if (row.group != FunctionGroup::data &&  // measures_test.cpp
            all.find(std::string(row.name()) + "(") == std::string::npos)
            missing.insert(row.name());
    EXPECT_EQ(missing, (std::set<std::string_view>{"rand", "noise"}))
        << "add a case for each other function; these two have a file of their own";
}

TEST(ExpressionFunctions, ConstantsAndVariablesGiveTheSameBits) {
    // The first is computed when it is read, the second when it is evaluated.
    for (const auto& [constant, variable] : std::vector<std::pair<std::string, std::string>>{
             {"sin(2) * vec3(1, 2, 3)", "sin(a) * v"},
             {"inverse(rotate(30, 1, 2, 3))", "inverse(rotate(30, v))"},
             {"pow(2, 3) / 5 - -.5", "pow(a, b) / c - x"}})
        EXPECT_EQ(valueOf(constant), valueOf(variable)) << constant;
}

TEST(ExpressionFunctions, ReportWhatHasNoValue) {
    const std::vector<std::pair<std::string, std::string>> reported{
        {"1 + a / (b - 3)", "expr-E06 'a / (b - 3)': 'a / (b - 3)': division by zero"},
        {"1 / 0", "expr-E06 '1 / 0': '1 / 0': division by zero"},
        {"v / vec3(1, 0, 2)", "expr-E06 'v / vec3(1, 0, 2)': 'v / vec3(1, 0, 2)': division by zero"},
        {"a % (b - 3)", "expr-E06 'a % (b - 3)': 'a % (b - 3)': division by zero"},
        {"mod(a, 0)", "expr-E06 'mod(a, 0)': 'mod(a, 0)': division by zero"},
        {"2 * sqrt(x)", "expr-E06 'sqrt(x)': 'sqrt(x)': the result is not a number"},
        {"asin(a)", "expr-E06 'asin(a)': 'asin(a)': the result is not a number"},
        {"log(a - a)", "expr-E06 'log(a - a)': 'log(a - a)': the result is infinite"},
        {"exp(1000 * a)", "expr-E06 'exp(1000 * a)': 'exp(1000 * a)': the result is infinite"},
        {"1e308 * 10 * a", "expr-E06 '1e308 * 10': '1e308 * 10': the result is infinite"},
        {"(1e308 + 1e308 > 0) ? 1 : 2", "expr-E06 '1e308 + 1e308': '1e308 + 1e308': the result is infinite"},
        {"normalize(v - v)",
         "expr-E06 'normalize(v - v)': 'normalize(v - v)': a vector of length 0 has no direction"},
        {"inverse(mat3(0))",
         "expr-E06 'inverse(mat3(0))': 'inverse(mat3(0))': the matrix is singular, so it has no inverse"},
        {"inverse(outerProduct(w, w))",
         "expr-E06 'inverse(outerProduct(w, w))': 'inverse(outerProduct(w, w))': the matrix is singular, so "
         "it has "
         "no inverse"},
        {"rotate(30, v - v)", "expr-E06 'rotate(30, v - v)': 'rotate(30, v - v)': the axis has length 0"},
        {"lookAt(v, v, v)",
         "expr-E06 'lookAt(v, v, v)': 'lookAt(v, v, v)': eye and centre are the same point, or the view is "
         "along "
         "the up vector"},
        {"perspective(180, 1, 1, 2)",
         "expr-E06 'perspective(180, 1, 1, 2)': 'perspective(180, 1, 1, 2)': the angle is not between 0 and "
         "180 "
         "degrees"},
        {"perspective(50, 0, 1, 2)",
         "expr-E06 'perspective(50, 0, 1, 2)': 'perspective(50, 0, 1, 2)': the aspect is not positive"},
        {"perspective(50, 1, 0, 2)",
         "expr-E06 'perspective(50, 1, 0, 2)': 'perspective(50, 1, 0, 2)': near and far are not positive"},
        {"perspective(50, 1, 2, 2)",
         "expr-E06 'perspective(50, 1, 2, 2)': 'perspective(50, 1, 2, 2)': near and far are equal"},
        {"ortho(1, 1, 0, 1, 0, 1)",
         "expr-E06 'ortho(1, 1, 0, 1, 0, 1)': 'ortho(1, 1, 0, 1, 0, 1)': left and right are equal"},
        {"frustum(0, 1, 1, 1, 1, 2)",
         "expr-E06 'frustum(0, 1, 1, 1, 1, 2)': 'frustum(0, 1, 1, 1, 1, 2)': bottom and top are equal"},
        {"1 << 60",
         "expr-E06 '1 << 60': '1 << 60': bits are defined for whole numbers between -2^53 and 2^53"},
        {"1 << 64", "expr-E06 '1 << 64': '1 << 64': a shift is between 0 and 63 bits"},
        {"1 >> -1", "expr-E06 '1 >> -1': '1 >> -1': a shift is between 0 and 63 bits"},
        {"1e20 & 1",
         "expr-E06 '1e20 & 1': '1e20 & 1': bits are defined for whole numbers between -2^53 and 2^53"},
        {"v[c]", "expr-E06 'v[c]': 'v[c]': subscript 5 is not between 0 and 2"},
        {"v[-1]", "expr-E06 '-1': subscript -1 is not between 0 and 2"},
        {"m3[3]", "expr-E06 '3': subscript 3 is not between 0 and 2"},
        {"pose[6]", "expr-E06 '6': subscript 6 is not between 0 and 5"},
        {"pose[a - 3]", "expr-E06 'pose[a - 3]': 'pose[a - 3]': subscript -1 is not between 0 and 5"},
    };
    for (const auto& [text, expected] : reported) EXPECT_EQ(problemText(text), expected) << text;
}

TEST(ExpressionFunctions, ReportWrongTypesAndCounts) {
    const std::vector<std::pair<std::string, std::string>> reported{
        {"v + u", "expr-E03 'v + u': '+' does not combine vec3 and vec2"},
        {"a + (m3 * w)", "expr-E03 'm3 * w': '*' does not combine mat3 and vec4"},
        {"m4 % 2", "expr-E03 'm4 % 2': '%' does not combine mat4 and number"},
        {"v & 1", "expr-E03 'v & 1': '&' does not combine vec3 and number"},
        {"yes + 1", "expr-E03 'yes + 1': '+' does not combine bool and number"},
        {"v < v",
         "expr-E03 'v < v': '<' does not combine vec3 and vec3; lessThan() and greaterThan() compare "
         "vectors"},
        {"a == yes", "expr-E03 'a == yes': '==' does not combine number and bool"},
        {"a && yes", "expr-E03 'a': '&&' combines bools, found number"},
        {"yes || v", "expr-E03 'v': '||' combines bools, found vec3"},
        {"yes ^^ a", "expr-E03 'yes ^^ a': '^^' does not combine bool and number"},
        {"!a", "expr-E03 '!a': '!' does not apply to a number"},
        {"!bvec2(yes)", "expr-E03 '!bvec2(yes)': '!' does not apply to a bvec2; use not()"},
        {"-yes", "expr-E03 '-yes': '-' does not apply to a bool"},
        {"a ? 1 : 2", "expr-E03 'a': a condition is a bool, found number"},
        {"yes ? 1 : v",
         "expr-E03 'yes ? 1 : v': both cases of '?' have the same type, found number and vec3"},
        {"v[yes]", "expr-E03 'yes': a subscript is a number, found bool"},
        {"a[0]", "expr-E08 'a': a number has no elements"},
        {"sin(yes)", "expr-E03 'sin(yes)': there is no sin(bool), only T sin(T angle)"},
        {"dot(v, u)", "expr-E03 'dot(v, u)': there is no dot(vec3, vec2), only number dot(T a, T b)"},
        {"min(u, v)",
         "expr-E03 'min(u, v)': there is no min(vec2, vec3), only T min(T x, T y) and T min(T x, number y)"},
        {"noise(w)", "expr-E03 'noise(w)': there is no noise(vec4), only number noise(T p)"},
        {"sin(1, 2)", "expr-E04 'sin(1, 2)': sin takes 1 argument, found 2"},
        {"atan(1, 2, 3)", "expr-E04 'atan(1, 2, 3)': atan takes 1 or 2 arguments, found 3"},
        {"sin()", "expr-E04 'sin()': sin needs arguments, found none"},
        {"vec3(1, 2)", "expr-E04 'vec3(1, 2)': vec3 needs 3 components, found 2"},
        {"vec2(1, 2, 3)", "expr-E04 'vec2(1, 2, 3)': vec2 needs 2 components, found 3"},
        {"mat2(1, 2, 3)", "expr-E04 'mat2(1, 2, 3)': mat2 needs 4 components, found 3"},
        {"mat2(v, v)", "expr-E04 'mat2(v, v)': mat2 needs 4 components, found 6"},
        {"float(1, 2)", "expr-E04 'float(1, 2)': float takes 1 argument, found 2"},
        {"vec3(m3)", "expr-E03 'vec3(m3)': vec3 is not made of a matrix; use its columns, such as m[0]"},
        {"vec2(1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1)",
         "expr-E04 'vec2(1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1': vec2 has more than 16 arguments"},
    };
    for (const auto& [text, expected] : reported) EXPECT_EQ(problemText(text), expected) << text;
}

TEST(ExpressionFunctions, MotionFollowsItsFormulaAtAllTimes) {
    NameTable table;
    table.addSceneNames();
    const auto bounce = parse("bounce(-1, 2, .75)", {}, table);
    const auto wrap = parse("wrap(-1, 2, .75)", {}, table);
    ASSERT_TRUE(bounce && wrap);
    EXPECT_EQ(bounce->depends(), Depends::time);
    double before = -1;
    for (int k = 0; k <= 4000; ++k) {
        const double time = k / 256.;
        table.set("time", time);
        const double turns = .75 * time / 3;
        const double triangle = 1 - std::abs(1 - (turns / 2 - std::floor(turns / 2)) * 2);
        const double value = bounce->evaluate(table)->number();
        EXPECT_NEAR(value, -1 + 3 * triangle, 1e-13) << time;
        EXPECT_LE(std::abs(value - before), .75 / 256 + 1e-15) << "it does not jump";
        before = value;
        EXPECT_NEAR(wrap->evaluate(table)->number(), -1 + 3 * (turns - std::floor(turns)), 1e-13) << time;
    }
    table.set("time", 1e15);
    EXPECT_GE(bounce->evaluate(table)->number(), -1);
    EXPECT_LE(bounce->evaluate(table)->number(), 2);
    EXPECT_EQ(toString(parse("bounce(0, 1, 1)", {}, NameTable()).problem.message),
              "error: bounce needs 'time', which has no value here [expr-E07]");
}

}  // namespace
}  // namespace glibra::expression::test
