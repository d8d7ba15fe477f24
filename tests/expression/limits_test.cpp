// Long, deep and large expressions, and the time that one takes.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

#include "support.h"

namespace glibra::expression::test {
namespace {

std::string repeated(std::string_view text, std::size_t count) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
}

TEST(ExpressionLimits, NestingOfTenThousandLevelsIsReported) {
    constexpr std::size_t kDeep = 10'000;
    const Limits limits{.bytes = 1U << 20U};
    const auto idOf = [&](const std::string& text) {
        const auto expression = parse(text, {}, sceneTable(), {}, limits);
        return expression ? std::string() : expression.problem.message.id;
    };
    EXPECT_EQ(idOf(repeated("(", kDeep) + "1" + repeated(")", kDeep)), "expr-E05");
    EXPECT_EQ(idOf(repeated("sin(", kDeep) + "1" + repeated(")", kDeep)), "expr-E05");
    EXPECT_EQ(idOf(repeated("-", kDeep) + "1"), "expr-E05");
    EXPECT_EQ(idOf(repeated("!", kDeep) + "yes"), "expr-E05");
    EXPECT_EQ(idOf(repeated("yes ? 1 : ", kDeep) + "1"), "expr-E05");
    EXPECT_EQ(idOf(repeated("yes ? ", kDeep) + "1"), "expr-E05");
    EXPECT_EQ(idOf(repeated("pose[", kDeep) + "1" + repeated("]", kDeep)), "expr-E05");
    EXPECT_EQ(idOf(repeated("(1 + ", 90) + "1" + repeated(")", 90)), "");
    EXPECT_EQ(idOf(repeated("(1 + 1 * yes ? 1 : (", 90)), "expr-E03");
}

TEST(ExpressionLimits, LongChainsAreFine) {
    std::string sum = "a";
    for (int k = 0; k < 3000; ++k) sum += " + a";
    EXPECT_EQ(numberOf(sum), 6002);
    EXPECT_EQ(numberOf("1" + repeated(" + 1", 3000)), 3001);
    EXPECT_EQ(numberOf("v" + repeated(".xyz", 3000) + ".y"), 2);
    EXPECT_TRUE(valueOf("yes" + repeated(" && yes", 1500)).truth());
}

TEST(ExpressionLimits, TheTextAndTheCodeAreBounded) {
    EXPECT_EQ(problemOf(repeated(" ", (16U << 10U) + 1)).message.text,
              "expression of 16385 bytes; the limit is 16384");
    const auto expression = parse(repeated("a+", 100) + "a", {}, sceneTable(), {}, {.steps = 100});
    ASSERT_FALSE(expression);
    EXPECT_EQ(toString(expression.problem.message),
              "error: the expression is too long, or holds too many values at once [expr-E05]");
}

TEST(ExpressionLimits, ValuesOnTheStackAreBounded) {
    // 40 matrices wait for the innermost one.
    const std::string products = repeated("m4 * (", 40) + "m4" + repeated(")", 40);
    EXPECT_EQ(problemOf(products).message.id, "expr-E05");
    EXPECT_EQ(problemOf(repeated("mat4(1) * (", 40) + "mat4(1)" + repeated(")", 40)).message.id, "expr-E05");
    EXPECT_TRUE(parse(repeated("m4 * (", 20) + "m4" + repeated(")", 20), {}, sceneTable()));
}

TEST(ExpressionLimits, EvaluationsTakeFractionsOfAMicrosecond) {
    // Printed, and bounded generously: a slow machine must not fail here.
    NameTable table = sceneTable();
    const std::array<double, 16> identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    table.set("light.shadow", identity);
    table.set("model", identity);
    constexpr int kRounds = 100'000;
    for (const char* text : {"a", "2 * a + b", "2 * sin(.35 * time)", "a > b ? c : vec3(a, b, c).y * 2",
                             "light.shadow * model", "noise(v * time)", "inverse(m4)"}) {
        const Expression expression = *parse(text, {}, table);
        double sum = 0;
        const auto begin = std::chrono::steady_clock::now();
        for (int k = 0; k < kRounds; ++k) sum += expression.evaluate(table)->number();
        const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
        std::printf("%8.3f us  %s\n", time.count() / kRounds, text);
        EXPECT_TRUE(std::isfinite(sum));
    }
    const auto begin = std::chrono::steady_clock::now();
    for (int k = 0; k < kRounds / 10; ++k)
        ASSERT_TRUE(parse("vec3(2 * sin(.35 * time), a / b, -1).zyx", {}, table));
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
    std::printf("%8.3f us  to read vec3(2 * sin(.35 * time), a / b, -1).zyx\n", time.count() * 10 / kRounds);
}

}  // namespace
}  // namespace glibra::expression::test
