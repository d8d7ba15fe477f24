#include "gpu/context/errors.h"

#include <array>
#include <cstdio>

namespace glibra::gpu {
namespace {

// A lost context reports an error for ever.
constexpr int kMostErrors = 32;

}  // namespace

std::string errorName(GLenum code) {
    switch (code) {
        case GL_NO_ERROR:
            return "GL_NO_ERROR";
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "GL_INVALID_FRAMEBUFFER_OPERATION";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        case GL_CONTEXT_LOST:
            return "GL_CONTEXT_LOST";
        default:
            break;
    }
    return "error " + std::to_string(code);
}

void clearErrors() {
    for (int i = 0; i < kMostErrors && glGetError() != GL_NO_ERROR; ++i) {
    }
}

GLenum takeError() {
    const GLenum first = glGetError();
    if (first != GL_NO_ERROR) clearErrors();
    return first;
}

Diagnostic allocationError(GLenum code, std::string_view what) {
    if (code == GL_OUT_OF_MEMORY)
        return diagnose("draw-E05", "out of memory on the graphics device for " + std::string(what));
    return diagnose("gpu-E02", "OpenGL refuses " + std::string(what) + ": " + errorName(code));
}

std::string readableBytes(std::uint64_t bytes) {
    static constexpr std::array<const char*, 7> kUnits{"bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
    auto value = static_cast<double>(bytes);
    std::size_t unit = 0;
    while (value >= 1024 && unit + 1 < kUnits.size()) {
        value /= 1024;
        ++unit;
    }
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), unit == 0 || value >= 100 ? "%.0f %s" : "%.1f %s", value,
                        kUnits[unit]);
    return text.data();
}

}  // namespace glibra::gpu
