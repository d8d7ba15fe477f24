// What libc++ declares for threads, and Debian's libc++.a for WebAssembly, which is built without threads,
// lacks. A page has one thread: nothing waits for a lock.

#include <mutex>
#include <thread>

extern "C" int __cxa_thread_atexit(void (*)(void*), void*, void*) noexcept {
    return 0;  // the thread ends with the page
}

_LIBCPP_BEGIN_NAMESPACE_STD

mutex::~mutex() noexcept = default;
void mutex::lock() {}
void mutex::unlock() noexcept {}
unsigned thread::hardware_concurrency() noexcept {
    return 1;
}

_LIBCPP_END_NAMESPACE_STD
