// A library that is loaded before those of glibra. Folders whose name begins with "locked" cannot be listed,
// as if they belonged to somebody else, even for root.

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>

#include <cerrno>
#include <cstdarg>
#include <cstring>

namespace {

bool isRefused(const char* path) {
    const char* slash = std::strrchr(path, '/');
    if (std::strncmp(slash != nullptr ? slash + 1 : path, "locked", 6) != 0) return false;
    errno = EACCES;
    return true;
}

int openAt(const char* symbol, int folder, const char* path, int flags, mode_t mode) {
    if ((flags & O_DIRECTORY) != 0 && isRefused(path)) return -1;
    using OpenAt = int (*)(int, const char*, int, ...);
    return reinterpret_cast<OpenAt>(dlsym(RTLD_NEXT, symbol))(folder, path, flags, mode);
}

mode_t modeOf(int flags, va_list& rest) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
}

}  // namespace

extern "C" DIR* opendir(const char* path) {
    if (isRefused(path)) return nullptr;
    using OpenFolder = DIR* (*)(const char*);
    return reinterpret_cast<OpenFolder>(dlsym(RTLD_NEXT, "opendir"))(path);
}

extern "C" int openat(int folder, const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = modeOf(flags, rest);
    va_end(rest);
    return openAt("openat", folder, path, flags, mode);
}

extern "C" int openat64(int folder, const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = modeOf(flags, rest);
    va_end(rest);
    return openAt("openat64", folder, path, flags, mode);
}
