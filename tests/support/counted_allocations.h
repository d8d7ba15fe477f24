#pragma once
// Counts the heap allocations of the thread by replacing operator new, except where the address sanitizer
// does that. Exactly one file of a program includes this.

#include <cstdint>
#include <cstdlib>
#include <new>

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
