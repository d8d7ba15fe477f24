#include "gpu/object/framebuffer.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "gpu/context/errors.h"

namespace glibra::gpu {
namespace {

const char* incompleteness(GLenum status) {
    switch (status) {
        case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
            return "one of them cannot be drawn into";
        case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
            return "it has neither colour nor depth";
        case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
            return "their numbers of samples differ";
        case GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS:
            return "some have layers and others have none";
        case GL_FRAMEBUFFER_UNSUPPORTED:
            return "the driver does not support this combination of formats";
        default:
            break;
    }
    return "it is incomplete";
}

struct Attach {
    std::size_t index = 0;  ///< of the colour
    void operator()(const TexturePart& part) const {
        attachTexture(GL_DRAW_FRAMEBUFFER, attachmentPoint(part.texture->format(), index), part);
    }
    void operator()(const Texture* texture) const {
        if (texture) (*this)(TexturePart{texture});
    }
    void operator()(const Renderbuffer* buffer) const {
        if (buffer)
            glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, attachmentPoint(buffer->format(), index),
                                      GL_RENDERBUFFER, buffer->id());
    }
};

}  // namespace

GLenum attachmentPoint(TexelFormat format, std::size_t index) {
    if (hasStencil(format)) return GL_DEPTH_STENCIL_ATTACHMENT;
    return hasDepth(format) ? GL_DEPTH_ATTACHMENT : static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + index);
}

void attachTexture(GLenum framebufferTarget, GLenum point, const TexturePart& part) {
    const Texture& texture = *part.texture;
    const int layer = part.layer.value_or(0);
    if (part.isLayered()) return glFramebufferTexture(framebufferTarget, point, texture.id(), part.level);
    if (texture.shape() == TextureShape::texture3D || isArray(texture.shape()))
        return glFramebufferTextureLayer(framebufferTarget, point, texture.id(), part.level, layer);
    if (texture.shape() == TextureShape::texture1D)
        return glFramebufferTexture1D(framebufferTarget, point, GL_TEXTURE_1D, texture.id(), part.level);
    const GLenum target = texture.shape() == TextureShape::cube
                              ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(layer)
                              : glTarget(texture.shape());
    glFramebufferTexture2D(framebufferTarget, point, target, texture.id(), part.level);
}

Result<Renderbuffer> Renderbuffer::create(const Capabilities& capabilities, int width, int height,
                                          TexelFormat format, int samples) {
    const int most = isInteger(format) ? capabilities.maxIntegerSamples : capabilities.maxSamples;
    const int used = std::clamp(samples, 1, std::max(1, most));
    std::string what = "a " + std::to_string(width) + " x " + std::to_string(height) + " target";
    if (used > 1) what += " of " + std::to_string(used) + " samples";
    const int widest = std::min(capabilities.maxRenderbufferSide, capabilities.maxViewportWidth);
    const int highest = std::min(capabilities.maxRenderbufferSide, capabilities.maxViewportHeight);
    if (width < 1 || height < 1) return diagnose("gpu-E04", what + " has no pixels");
    if (width > widest || height > highest)
        return diagnose("gpu-E04", what + " is too large; this driver's limit is " + std::to_string(widest) +
                                       " x " + std::to_string(highest));
    const auto bytes = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
                       bytesPerTexel(format) * static_cast<std::uint64_t>(used);
    what += " (" + readableBytes(bytes) + ")";

    Renderbuffer made;
    made.name_ = Name<glDeleteRenderbuffers>(glGenRenderbuffers);
    made.format_ = format;
    made.width_ = width;
    made.height_ = height;
    clearErrors();
    glBindRenderbuffer(GL_RENDERBUFFER, made.id());
    // 0 samples means not multisampled; some drivers make a multisampled buffer for 1.
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, used > 1 ? used : 0, internalFormat(format), width,
                                     height);
    if (const GLenum code = takeError(); code != GL_NO_ERROR) return allocationError(code, what);
    GLint given = 0;
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &given);
    made.samples_ = std::max(1, given);
    return made;
}

Result<Framebuffer> Framebuffer::create(std::span<const Attachment> colors, const Attachment& depth) {
    Framebuffer made;
    made.name_ = Name<glDeleteFramebuffers>(glGenFramebuffers);
    made.colorCount_ = static_cast<int>(colors.size());
    made.bindForDrawing();
    std::vector<GLenum> outputs;
    for (const Attachment& each : colors) {
        std::visit(Attach{outputs.size()}, each);
        outputs.push_back(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + outputs.size()));
    }
    std::visit(Attach{}, depth);
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
