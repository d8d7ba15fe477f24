// A library that is loaded before those of glibra. It stands for a graphics device that hangs and is reset:
//
// - GLIBRA_DEVICE is a file that stands for the device. Each reset adds a byte to it, which all processes see
//   whose context was made before.
// - The device hangs in a draw or a dispatch whose program has a function `hang`, or in draw number
//   GLIBRA_HANGS_IN_DRAW of the process.
// - GLIBRA_RESET_AS: "known" (the default): the driver knows who is to blame; "unknown": it does not;
// "error":
//   it cannot tell at all, but every call fails with GL_CONTEXT_LOST; "other": another program is to blame.
//
// From the reset on nothing is drawn or read any more. As with a real driver a context learns of the reset
// only if it was made for that.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using Function = void (*)();

/// The dlsym of the system; looking up that name by dlsym would find the one below.
void* real(void* handle, const char* name) {
    using Dlsym = void* (*)(void*, const char*);
    static const auto found = [] {
        for (const char* version : {"GLIBC_2.34", "GLIBC_2.17", "GLIBC_2.2.5"})
            if (void* symbol = dlvsym(RTLD_NEXT, "dlsym", version)) return reinterpret_cast<Dlsym>(symbol);
        std::abort();
    }();
    return found(handle, name);
}

constexpr unsigned kGuilty = 0x8253, kInnocent = 0x8254, kUnknown = 0x8255, kContextLost = 0x0507;

bool resetsAs(const char* word) {
    const char* given = std::getenv("GLIBRA_RESET_AS");
    return std::strcmp(given != nullptr ? given : "known", word) == 0;
}

// What this process knows of its context.
bool isNotified = false, isGuilty = false;
long resetsBefore = 0;
std::set<unsigned> hangingShaders, hangingPrograms;
unsigned programInUse = 0;
int drawsSoFar = 0;

long resets() {
    const char* file = std::getenv("GLIBRA_DEVICE");
    struct stat found{};
    return file != nullptr && stat(file, &found) == 0 ? static_cast<long>(found.st_size) : 0;
}

bool isLost() {
    return isGuilty || resets() != resetsBefore;
}

void beginContext() {
    isGuilty = false;
    resetsBefore = resets();
    hangingShaders.clear();
    hangingPrograms.clear();
}

/// True if the draw or dispatch that begins must not be done.
bool hangs() {
    if (isLost()) return true;
    ++drawsSoFar;
    const char* number = std::getenv("GLIBRA_HANGS_IN_DRAW");
    // Only once for all processes.
    const bool isCounted = number != nullptr && drawsSoFar == std::atoi(number) && resets() == 0;
    const char* file = std::getenv("GLIBRA_DEVICE");
    if ((!isCounted && hangingPrograms.count(programInUse) == 0) || file == nullptr) return false;
    const int device = open(file, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600);
    if (device < 0 || write(device, "x", 1) != 1) std::abort();
    close(device);
    isGuilty = true;
    return true;
}

unsigned status() {
    if (!isNotified || !isLost()) return 0;
    if (resetsAs("unknown")) return kUnknown;
    return isGuilty && !resetsAs("other") ? kGuilty : kInnocent;
}

/// One function of GL: the driver's own, and ours in its place.
template <class Tag, class Type>
struct Hook;
template <class Tag, class Returned, class... Arguments>
struct Hook<Tag, Returned (*)(Arguments...)> {
    static inline Returned (*own)(Arguments...) = nullptr;
    static Returned call(Arguments... arguments) {
        if constexpr (Tag::kDraws) {
            if (hangs()) return Returned();
        } else if (isLost()) {
            return Returned();
        }
        return own(arguments...);
    }
};
struct Draws {
    static constexpr bool kDraws = true;
};
struct Reads {
    static constexpr bool kDraws = false;
};
#define HOOK(function, kind, ...)                                 \
    if (std::strcmp(name, #function) == 0) {                      \
        struct Tag : kind {};                                     \
        using Type = void (*)(__VA_ARGS__);                       \
        Hook<Tag, Type>::own = reinterpret_cast<Type>(got);       \
        return reinterpret_cast<Function>(Hook<Tag, Type>::call); \
    }

void (*ownShaderSource)(unsigned, int, const char* const*, const int*) = nullptr;
void (*ownAttachShader)(unsigned, unsigned) = nullptr;
void (*ownUseProgram)(unsigned) = nullptr;
unsigned (*ownGetError)() = nullptr;
unsigned (*ownCreateShader)(unsigned) = nullptr;
unsigned (*ownCreateProgram)() = nullptr;

// Drivers may give the number of a deleted shader or program to a new one.
unsigned createShader(unsigned stage) {
    const unsigned shader = ownCreateShader(stage);
    hangingShaders.erase(shader);
    return shader;
}
unsigned createProgram() {
    const unsigned program = ownCreateProgram();
    hangingPrograms.erase(program);
    return program;
}
void shaderSource(unsigned shader, int count, const char* const* texts, const int* lengths) {
    for (int i = 0; i < count; ++i) {
        const std::string text = lengths != nullptr && lengths[i] >= 0
                                     ? std::string(texts[i], static_cast<std::size_t>(lengths[i]))
                                     : std::string(texts[i]);
        if (text.find("hang(") != std::string::npos) hangingShaders.insert(shader);
    }
    ownShaderSource(shader, count, texts, lengths);
}
void attachShader(unsigned program, unsigned shader) {
    if (hangingShaders.count(shader) > 0) hangingPrograms.insert(program);
    ownAttachShader(program, shader);
}
void useProgram(unsigned program) {
    programInUse = program;
    ownUseProgram(program);
}
unsigned getError() {
    if (resetsAs("error") && isLost()) return kContextLost;
    return ownGetError();
}

template <class Own>
Function replace(Own& own, Function got, Own with) {
    own = reinterpret_cast<Own>(got);
    return reinterpret_cast<Function>(with);
}

Function hooked(const char* name, Function got) {
    if (got == nullptr) return got;
    HOOK(glDrawArrays, Draws, unsigned, int, int)
    HOOK(glDrawElements, Draws, unsigned, int, unsigned, const void*)
    HOOK(glDrawArraysInstanced, Draws, unsigned, int, int, int)
    HOOK(glDrawElementsInstanced, Draws, unsigned, int, unsigned, const void*, int)
    HOOK(glDrawArraysIndirect, Draws, unsigned, const void*)
    HOOK(glDrawElementsIndirect, Draws, unsigned, unsigned, const void*)
    HOOK(glDispatchCompute, Draws, unsigned, unsigned, unsigned)
    HOOK(glDispatchComputeIndirect, Draws, std::intptr_t)
    HOOK(glReadPixels, Reads, int, int, int, int, unsigned, unsigned, void*)
    HOOK(glGetTexImage, Reads, unsigned, int, unsigned, unsigned, void*)
    HOOK(glGetBufferSubData, Reads, unsigned, std::intptr_t, std::intptr_t, void*)
    HOOK(glGetQueryObjectui64v, Reads, unsigned, unsigned, std::uint64_t*)
    if (std::strcmp(name, "glCreateShader") == 0) return replace(ownCreateShader, got, &createShader);
    if (std::strcmp(name, "glCreateProgram") == 0) return replace(ownCreateProgram, got, &createProgram);
    if (std::strcmp(name, "glShaderSource") == 0) return replace(ownShaderSource, got, &shaderSource);
    if (std::strcmp(name, "glAttachShader") == 0) return replace(ownAttachShader, got, &attachShader);
    if (std::strcmp(name, "glUseProgram") == 0) return replace(ownUseProgram, got, &useProgram);
    if (std::strcmp(name, "glGetError") == 0) return replace(ownGetError, got, &getError);
    if (std::strncmp(name, "glGetGraphicsResetStatus", 24) == 0)
        return resetsAs("error") ? nullptr : reinterpret_cast<Function>(&status);
    return got;
}

/// True if the list, which 0 (of GLX) or EGL_NONE ends, asks for a context that is lost with a reset.
template <class Number>
bool asks(const Number* list, Number end, Number key, Number value) {
    for (; list != nullptr && list[0] != end; list += 2)
        if (list[0] == key) return list[1] == value;
    return false;
}

using CreateEgl = void* (*)(void*, void*, void*, const int*);
CreateEgl ownCreateEgl = nullptr;
void* createEgl(void* display, void* config, void* shared, const int* attributes) {
    isNotified = asks(attributes, 0x3038, 0x31BD, 0x31BF);
    void* context = ownCreateEgl(display, config, shared, attributes);
    if (context != nullptr) beginContext();
    return context;
}

// Not every driver for X can tell of a reset; ours can.
constexpr const char* kRobustness = "GLX_ARB_create_context_robustness";
bool isOwnRobust = false;
using QueryExtensions = const char* (*)(void*, int);
QueryExtensions ownExtensions = nullptr;
const char* extensions(void* display, int screen) {
    static std::string all;
    all = ownExtensions(display, screen);
    isOwnRobust = all.find(kRobustness) != std::string::npos;
    if (!isOwnRobust) all += std::string(" ") + kRobustness;
    return all.c_str();
}

using CreateGlx = void* (*)(void*, void*, void*, int, const int*);
CreateGlx ownCreateGlx = nullptr;
void* createGlx(void* display, void* config, void* shared, int direct, const int* attributes) {
    isNotified = asks(attributes, 0, 0x8256, 0x8252);
    std::vector<int> known;
    for (const int* each = attributes; each != nullptr && each[0] != 0; each += 2)
        if (isOwnRobust || each[0] != 0x8256) known.insert(known.end(), {each[0], each[1]});
    known.push_back(0);
    void* context = ownCreateGlx(display, config, shared, direct, known.data());
    if (context != nullptr) beginContext();
    return context;
}

using GetAddress = Function (*)(const char*);
GetAddress eglAddress = nullptr, osmesaAddress = nullptr, glxAddress = nullptr, glxAddressArb = nullptr;
Function getByEgl(const char* name) {
    return hooked(name, eglAddress(name));
}
Function getByOsmesa(const char* name) {
    return hooked(name, osmesaAddress(name));
}
Function getByGlx(const char* name, GetAddress own) {
    const Function found = own(name);
    if (std::strcmp(name, "glXCreateContextAttribsARB") != 0) return hooked(name, found);
    ownCreateGlx = reinterpret_cast<CreateGlx>(found);
    return reinterpret_cast<Function>(createGlx);
}
Function getByGlxPlain(const char* name) {
    return getByGlx(name, glxAddress);
}
Function getByGlxArb(const char* name) {
    return getByGlx(name, glxAddressArb);
}

}  // namespace

extern "C" void* dlsym(void* handle, const char* name) noexcept {
    void* found = real(handle, name);
    if (found == nullptr || std::getenv("GLIBRA_DEVICE") == nullptr) return found;
    const auto put = [&](auto& own, auto with) {
        own = reinterpret_cast<std::remove_reference_t<decltype(own)>>(found);
        return reinterpret_cast<void*>(with);
    };
    if (std::strcmp(name, "eglGetProcAddress") == 0) return put(eglAddress, &getByEgl);
    if (std::strcmp(name, "OSMesaGetProcAddress") == 0) return put(osmesaAddress, &getByOsmesa);
    if (std::strcmp(name, "glXGetProcAddress") == 0) return put(glxAddress, &getByGlxPlain);
    if (std::strcmp(name, "glXGetProcAddressARB") == 0) return put(glxAddressArb, &getByGlxArb);
    if (std::strcmp(name, "glXQueryExtensionsString") == 0) return put(ownExtensions, &extensions);
    if (std::strcmp(name, "eglCreateContext") == 0) return put(ownCreateEgl, &createEgl);
    return found;
}
