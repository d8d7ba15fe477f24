#include "gpu/context/fork.h"

#include <pthread.h>

namespace glibra::gpu {
namespace {

std::atomic<bool> isChild = false;

}  // namespace

void noteDriver() {
    static const int watched = ::pthread_atfork(nullptr, nullptr, [] { isChild = true; });
    static_cast<void>(watched);
}

bool isForked() {
    return isChild;
}

std::string forkedText() {
    return "a process that is forked after a renderer was opened cannot draw, because the driver's threads "
           "are "
           "not in it; fork before, or start the process anew (exec; in Python the start methods 'spawn' and "
           "'forkserver')";
}

}  // namespace glibra::gpu
