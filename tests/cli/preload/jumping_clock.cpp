// A library that is loaded before those of glibra. Its wall clock jumps by years at every call, forwards and
// backwards; the monotonic clock is left alone.

#include <dlfcn.h>
#include <sys/time.h>

#include <atomic>
#include <ctime>

namespace {

std::time_t jump() {
    static std::atomic<unsigned> calls{0};
    constexpr std::time_t kYear = 31'556'952;
    const unsigned call = ++calls;
    return (call % 2 == 0 ? -1 : 1) * kYear * static_cast<std::time_t>(call % 9 + 1);
}

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* now) noexcept {
    static const auto real = next<int (*)(clockid_t, timespec*)>("clock_gettime");
    const int status = real(clock, now);
    if (status == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE)) now->tv_sec += jump();
    return status;
}

extern "C" int gettimeofday(timeval* __restrict now, void* __restrict zone) noexcept {
    static const auto real = next<int (*)(timeval*, void*)>("gettimeofday");
    const int status = real(now, zone);
    if (status == 0) now->tv_sec += jump();
    return status;
}

extern "C" std::time_t time(std::time_t* to) noexcept {
    static const auto real = next<std::time_t (*)(std::time_t*)>("time");
    const std::time_t now = real(nullptr) + jump();
    if (to != nullptr) *to = now;
    return now;
}
