// Evaluations allocate nothing on the heap.

#include <gtest/gtest.h>

#include "../support/counted_allocations.h"
#include "support.h"

namespace glibra::expression::test {
namespace {

TEST(ExpressionAllocations, AnEvaluationAllocatesNothing) {
    if (GLIBRA_COUNTS_ALLOCATIONS == 0) GTEST_SKIP() << "the sanitizer replaces operator new";
    const NameTable table = sceneTable();
    for (const char* text :
         {"a", "yes ? v * sin(time) : v", "inverse(m4) * translate(v) * rotate(30, v)",
          "pose[a + 1] + bounce(0, 1, 2) + rand(a, b) + noise(v)", "slice[a].far * slice.count"}) {
        const std::uint64_t beforeReading = allocations;
        const Expression expression = parsed(text);
        EXPECT_GT(allocations, beforeReading) << "the counter works";
        const std::uint64_t before = allocations;
        const auto value = expression.evaluate(table);
        const Expression copy = expression;  // NOLINT(performance-unnecessary-copy-initialization)
        EXPECT_EQ(allocations, before) << text;
        EXPECT_TRUE(value) << text;
        EXPECT_EQ(copy, expression);
    }
}

}  // namespace
}  // namespace glibra::expression::test
