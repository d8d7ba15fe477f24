// Preloaded into glibra-view: writes to the file that GLIBRA_ALLOCATIONS names, in one line per presented
// frame, how often the presenting thread called `new`.

#include <dlfcn.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace {
thread_local std::uint64_t allocations = 0;
}

void* operator new(std::size_t bytes) {
    ++allocations;
    if (void* memory = std::malloc(bytes > 0 ? bytes : 1)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

extern "C" void glfwSwapBuffers(void* window) {
    using Swap = void (*)(void*);
    static const auto swap = reinterpret_cast<Swap>(dlsym(RTLD_NEXT, "glfwSwapBuffers"));
    static const char* const name = std::getenv("GLIBRA_ALLOCATIONS");
    static std::FILE* const file = name != nullptr ? std::fopen(name, "w") : nullptr;
    static std::uint64_t before = 0;
    if (file != nullptr) {
        std::fprintf(file, "%llu\n", static_cast<unsigned long long>(allocations - before));
        std::fflush(file);
    }
    swap(window);
    before = allocations;
}
