#include "gpu/context/errors.h"

#include <algorithm>
#include <array>
#include <utility>

namespace glibra::gpu {
namespace {

// A lost context reports an error for ever.
constexpr int kMostErrors = 32;

}  // namespace

std::string errorName(GLenum code) {
    static constexpr std::array<std::pair<GLenum, const char*>, 7> kNames{{
        {GL_NO_ERROR, "GL_NO_ERROR"},
        {GL_INVALID_ENUM, "GL_INVALID_ENUM"},
        {GL_INVALID_VALUE, "GL_INVALID_VALUE"},
        {GL_INVALID_OPERATION, "GL_INVALID_OPERATION"},
        {GL_INVALID_FRAMEBUFFER_OPERATION, "GL_INVALID_FRAMEBUFFER_OPERATION"},
        {GL_OUT_OF_MEMORY, "GL_OUT_OF_MEMORY"},
        {GL_CONTEXT_LOST, "GL_CONTEXT_LOST"},
    }};
    for (const auto& [value, name] : kNames)
        if (value == code) return name;
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

void WorkPlaces::set(const Place& place) {
    current_ = place;
    if (std::exchange(isFinished_, false) || unfinished_.first.file != place.file) {
        unfinished_.first = place;  // keeps its memory: a frame of a moving scene allocates nothing
        unfinished_.lastLine = place.line;
    } else if (place.line < unfinished_.first.line) {
        unfinished_.first = place;
    } else {
        unfinished_.lastLine = std::max(unfinished_.lastLine, place.line);
    }
}

}  // namespace glibra::gpu
