// A library that is loaded before those of a program. Each process writes to a file in the folder
// GLIBRA_CALLS how often it called each GL function, and the texels of textures and bytes of buffers that it
// had copied; calls.py reads the files. Functions that are asked for by eglGetProcAddress are counted, on
// x86-64.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

using Function = void (*)();

/// The dlsym of the system; looking up that name by dlsym would find the one below.
void* real(void* handle, const char* name) {
    using Dlsym = void* (*)(void*, const char*);
    static const auto found = [] {
        for (const char* version : {"GLIBC_2.34", "GLIBC_2.2.5"})
            if (void* symbol = dlvsym(RTLD_NEXT, "dlsym", version)) return reinterpret_cast<Dlsym>(symbol);
        std::abort();
    }();
    return found(handle, name);
}

/// A line of the file, which is shared memory: workers of glibra end without running destructors.
struct Counter {
    char name[56];
    std::uint64_t count;
};

Counter& counterNamed(const char* name) {
    constexpr std::size_t kMost = 4096;
    static Counter* const all = [] {
        const char* folder = std::getenv("GLIBRA_CALLS");
        const std::string path =
            std::string(folder != nullptr ? folder : ".") + "/" + std::to_string(getpid());
        const int file = open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC, 0600);
        constexpr std::size_t kBytes = kMost * sizeof(Counter);
        if (file < 0 || ftruncate(file, kBytes) != 0) std::abort();
        void* memory = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        if (memory == MAP_FAILED) std::abort();
        return static_cast<Counter*>(memory);
    }();
    for (std::size_t i = 0; i < kMost; ++i) {
        if (all[i].name[0] == 0) std::strncpy(all[i].name, name, sizeof all[i].name - 1);
        if (std::strcmp(all[i].name, name) == 0) return all[i];
    }
    std::abort();
}

using CopyImage = void (*)(unsigned, unsigned, int, int, int, int, unsigned, unsigned, int, int, int, int,
                           int, int, int);
CopyImage copyImage = nullptr;
void countedCopyImage(unsigned from, unsigned fromTarget, int fromLevel, int fromX, int fromY, int fromZ,
                      unsigned to, unsigned toTarget, int toLevel, int toX, int toY, int toZ, int width,
                      int height, int depth) {
    static std::uint64_t& texels = counterNamed("texels copied").count;
    texels += static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
              static_cast<std::uint64_t>(depth);
    copyImage(from, fromTarget, fromLevel, fromX, fromY, fromZ, to, toTarget, toLevel, toX, toY, toZ, width,
              height, depth);
}
using CopyBuffer = void (*)(unsigned, unsigned, std::intptr_t, std::intptr_t, std::intptr_t);
CopyBuffer copyBuffer = nullptr;
void countedCopyBuffer(unsigned from, unsigned to, std::intptr_t fromOffset, std::intptr_t toOffset,
                       std::intptr_t bytes) {
    static std::uint64_t& all = counterNamed("buffer bytes copied").count;
    all += static_cast<std::uint64_t>(bytes);
    copyBuffer(from, to, fromOffset, toOffset, bytes);
}

/// A few bytes of code that add one to the counter and go on with the function.
Function counted(const char* name, Function function) {
    static unsigned char* page = nullptr;
    static std::size_t used = 0;
    constexpr std::size_t kPage = 1 << 16, kCode = 32;
    if (page == nullptr || used + kCode > kPage) {
        page = static_cast<unsigned char*>(
            mmap(nullptr, kPage, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
        used = 0;
        if (page == MAP_FAILED) std::abort();
    }
    unsigned char* code = page + used;
    used += kCode;
    const auto address = [&](std::size_t at, const void* pointer) { std::memcpy(code + at, &pointer, 8); };
    std::memcpy(code, "\x48\xb8", 2);  // mov rax, counter
    address(2, &counterNamed(name).count);
    std::memcpy(code + 10, "\xf0\x48\xff\x00\x48\xb8", 6);  // lock inc qword [rax]; mov rax, function
    address(16, reinterpret_cast<const void*>(function));
    std::memcpy(code + 24, "\xff\xe0", 2);  // jmp rax
    return reinterpret_cast<Function>(code);
}

Function replaced(const char* name, Function function) {
    if (function == nullptr || std::strncmp(name, "gl", 2) != 0) return function;
    if (std::strcmp(name, "glCopyImageSubData") == 0) {
        copyImage = reinterpret_cast<CopyImage>(function);
        function = reinterpret_cast<Function>(countedCopyImage);
    }
    if (std::strcmp(name, "glCopyBufferSubData") == 0) {
        copyBuffer = reinterpret_cast<CopyBuffer>(function);
        function = reinterpret_cast<Function>(countedCopyBuffer);
    }
    return counted(name, function);
}

using GetProcAddress = Function (*)(const char*);
GetProcAddress getProcAddress = nullptr;
Function countingGetProcAddress(const char* name) {
    return replaced(name, getProcAddress(name));
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) Function eglGetProcAddress(const char* name) {
    if (getProcAddress == nullptr)
        getProcAddress = reinterpret_cast<GetProcAddress>(real(RTLD_NEXT, "eglGetProcAddress"));
    return countingGetProcAddress(name);
}

__attribute__((visibility("default"))) void* dlsym(void* handle, const char* name) {
    void* found = real(handle, name);
    if (found == nullptr || std::strcmp(name, "eglGetProcAddress") != 0) return found;
    if (found == reinterpret_cast<void*>(eglGetProcAddress)) return found;
    getProcAddress = reinterpret_cast<GetProcAddress>(found);
    return reinterpret_cast<void*>(countingGetProcAddress);
}
}
