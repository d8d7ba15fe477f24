// Counts the heap allocations of evaluations by replacing operator new.

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "support.h"

#if defined(__SANITIZE_ADDRESS__)
#define GLIBRA_COUNTS_ALLOCATIONS 0
#else
#define GLIBRA_COUNTS_ALLOCATIONS 1
#endif

namespace {
thread_local std::uint64_t allocations = 0;
}

#if GLIBRA_COUNTS_ALLOCATIONS
// The array and nothrow forms of the standard library call these. If GCC inlines only one of a pair, it warns
// of a mismatch; hence noinline.
[[gnu::noinline]] void* operator new(std::size_t bytes) {
    ++allocations;
    if (void* memory = std::malloc(bytes > 0 ? bytes : 1)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
#endif

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
