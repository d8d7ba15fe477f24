#include "gpu/object/framebuffer.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "gpu/context/errors.h"

namespace glibra::gpu {
namespace {

constexpr GLenum kDepthFormat = GL_DEPTH_COMPONENT24;

const char* incompleteness(GLenum status) {
    switch (status) {
        case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
            return "one of them cannot be drawn into";
        case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
            return "it has neither colour nor depth";
        case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
            return "their numbers of samples differ";
        case GL_FRAMEBUFFER_UNSUPPORTED:
            return "the driver does not support this combination of formats";
        default:
            break;
    }
    return "it is incomplete";
}

void attach(GLenum point, const ColorAttachment& attachment) {
    if (const auto* texture = std::get_if<const Texture*>(&attachment))
        glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, point, GL_TEXTURE_2D, *texture ? (*texture)->id() : 0, 0);
    else if (const Renderbuffer* buffer = std::get<const Renderbuffer*>(attachment))
        glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, point, GL_RENDERBUFFER, buffer->id());
}

}  // namespace

Result<Renderbuffer> Renderbuffer::create(const Capabilities& capabilities, int width, int height,
                                          GLenum format, std::size_t bytesPerPixel, int samples) {
    const int used = std::clamp(samples, 1, std::max(1, capabilities.maxSamples));
    std::string what = "a " + std::to_string(width) + " x " + std::to_string(height) + " target";
    if (used > 1) what += " of " + std::to_string(used) + " samples";
    const int widest = std::min(capabilities.maxRenderbufferSide, capabilities.maxViewportWidth);
    const int highest = std::min(capabilities.maxRenderbufferSide, capabilities.maxViewportHeight);
    if (width < 1 || height < 1) return diagnose("gpu-E04", what + " has no pixels");
    if (width > widest || height > highest)
        return diagnose("gpu-E04", what + " is too large; this driver's limit is " + std::to_string(widest) +
                                       " x " + std::to_string(highest));
    const auto bytes = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
                       bytesPerPixel * static_cast<std::uint64_t>(used);
    what += " (" + readableBytes(bytes) + ")";

    Renderbuffer made;
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    made.name_ = Name<deleteRenderbuffer>(name);
    made.width_ = width;
    made.height_ = height;
    clearErrors();
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    // 0 samples means not multisampled; some drivers make a multisampled buffer for 1.
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, used > 1 ? used : 0, format, width, height);
    if (const GLenum code = takeError(); code != GL_NO_ERROR) return allocationError(code, what);
    GLint given = 0;
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &given);
    made.samples_ = std::max(1, given);
    return made;
}

Result<Renderbuffer> Renderbuffer::color(const Capabilities& capabilities, int width, int height,
                                         TexelFormat format, int samples) {
    return create(capabilities, width, height, internalFormat(format), bytesPerTexel(format), samples);
}

Result<Renderbuffer> Renderbuffer::depth(const Capabilities& capabilities, int width, int height,
                                         int samples) {
    return create(capabilities, width, height, kDepthFormat, 4, samples);
}

Result<Framebuffer> Framebuffer::create(std::span<const ColorAttachment> colors, const Renderbuffer* depth) {
    Framebuffer made;
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    made.name_ = Name<deleteFramebuffer>(name);
    made.colorCount_ = static_cast<int>(colors.size());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name);
    std::vector<GLenum> outputs;
    for (const ColorAttachment& each : colors) {
        const auto point = static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + outputs.size());
        attach(point, each);
        outputs.push_back(point);
    }
    if (depth)
        glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth->id());
    if (outputs.empty())
        glDrawBuffer(GL_NONE);
    else
        glDrawBuffers(static_cast<GLsizei>(outputs.size()), outputs.data());
    const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        return diagnose("gpu-E05", "cannot draw into these " + std::to_string(colors.size()) +
                                       " colour targets together: " + incompleteness(status));
    return made;
}

}  // namespace glibra::gpu
