#include "gpu/object/foreign_target.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>

#include "gpu/context/errors.h"
#include "gpu/object/name.h"

namespace glibra::gpu {
namespace {

Diagnostic refused(std::string text) {
    return diagnose("library-E08", std::move(text));
}

/// Why the framebuffer that is bound for drawing takes no picture.
std::optional<Diagnostic> problemOfBound(const std::string& name) {
    if (const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
        status != GL_FRAMEBUFFER_COMPLETE)
        return refused(status == GL_FRAMEBUFFER_UNDEFINED
                           ? fmt::format("{} does not exist: the current context has no window", name)
                           : fmt::format("{} is not complete (0x{:x})", name, status));
    GLint outputs = 0;
    bool hasColor = false;
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &outputs);
    for (int i = 0; i < outputs; ++i) {
        GLint buffer = GL_NONE, kind = GL_NONE, type = GL_NONE;
        glGetIntegerv(static_cast<GLenum>(GL_DRAW_BUFFER0 + i), &buffer);
        if (buffer == GL_NONE) continue;
        hasColor = true;
        // A window's own has no integers, and its colours have other names.
        if (buffer < GL_COLOR_ATTACHMENT0 || buffer > GL_COLOR_ATTACHMENT31) continue;
        const auto point = static_cast<GLenum>(buffer);
        glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, point,
                                              GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &kind);
        if (kind == GL_NONE) continue;
        glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, point,
                                              GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
        if (type == GL_INT || type == GL_UNSIGNED_INT)
            return refused(fmt::format("{} holds integers, and a picture has none", name));
    }
    if (hasColor) return {};
    return refused(fmt::format("{} has no colour that is drawn into (glDrawBuffers)", name));
}

void makeOpaque(const PixelRectangle& part) {
    GLint outputs = 0;
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &outputs);
    constexpr std::array<GLfloat, 4> kOnes{1, 1, 1, 1};
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.x, part.y, part.width, part.height);
    for (int i = 0; i < outputs; ++i) {
        GLint buffer = GL_NONE;
        glGetIntegerv(static_cast<GLenum>(GL_DRAW_BUFFER0 + i), &buffer);
        if (buffer != GL_NONE) glClearBufferfv(GL_COLOR, i, kOnes.data());
    }
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace

Result<TextureSize> sizeOfForeign(GLuint texture) {
    GLint width = 0, height = 0;
    if (glIsTexture(texture) == GL_TRUE) {
        clearErrors();
        glBindTexture(GL_TEXTURE_2D, texture);
        if (takeError() != GL_NO_ERROR)
            return refused(fmt::format("texture {} is not a GL_TEXTURE_2D", texture));
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &height);
        glBindTexture(GL_TEXTURE_2D, 0);
    } else {
        return refused(fmt::format("the current context has no texture {}", texture));
    }
    if (width > 0 && height > 0) return TextureSize{width, height};
    return refused(fmt::format("texture {} has no level 0", texture));
}

Diagnostics copyInto(const ForeignTarget& to, const Target& from, bool isOpaque) {
    if (const GLenum before = takeError(); before != GL_NO_ERROR)
        return {allocationError(before, "what was drawn")};
    Name<glDeleteFramebuffers> own;
    std::string name = "the window's framebuffer";
    if (to.texture != 0) {
        name = fmt::format("texture {}", to.texture);
        GLuint made = 0;
        glGenFramebuffers(1, &made);
        own = Name<glDeleteFramebuffers>(made);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, made);
        glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, to.texture, 0);
    } else {
        if (to.framebuffer != 0) {
            name = fmt::format("framebuffer {}", to.framebuffer);
            if (glIsFramebuffer(to.framebuffer) != GL_TRUE)
                return {refused(fmt::format("the current context has no {}", name))};
        }
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer);
    }
    const std::optional<Diagnostic> problem = problemOfBound(name);
    if (!problem) {
        from.readable().bindForReading();
        glReadBuffer(GL_COLOR_ATTACHMENT0);
        glDisable(GL_FRAMEBUFFER_SRGB);
        const auto& [x, y, width, height] = to.rectangle;
        glBlitFramebuffer(0, 0, from.width(), from.height(), x, y, x + width, y + height, GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
        if (isOpaque) makeOpaque(to.rectangle);
    }
    const GLenum failed = takeError();
    from.bind();
    if (problem) return {*problem};
    if (failed != GL_NO_ERROR) return {allocationError(failed, "the picture in " + name)};
    return {};
}

}  // namespace glibra::gpu
