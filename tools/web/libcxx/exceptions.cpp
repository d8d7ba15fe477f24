// What code that throws calls (Itanium C++ ABI). WebAssembly's exceptions are not used: what throws ends the
// module, and the page makes a new one. So nothing after __cxa_allocate_exception() is ever reached, and the
// linker leaves it out.

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <new>

extern "C" {

void* __cxa_allocate_exception(std::size_t) noexcept {
    __builtin_trap();
}
void __cxa_free_exception(void*) noexcept {}
void __cxa_throw(void*, void*, void (*)(void*)) {
    __builtin_trap();
}
}
