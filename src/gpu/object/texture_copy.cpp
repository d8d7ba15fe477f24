// Textures are cleared, copied and resolved by framebuffers that they are attached to.

#include <array>
#include <utility>

#include "gpu/context/errors.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/texture.h"
#include "gpu/object/texture_storage.h"

namespace glibra::gpu {
namespace {

/// Calls `with` for a framebuffer with that layer of that texture attached, for drawing or reading.
template <class Use>
void withAttached(GLenum framebufferTarget, const Texture& texture, int level, int layer, Use&& use) {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    const Name<deleteFramebuffer> framebuffer(name);
    glBindFramebuffer(framebufferTarget, name);
    attachTexture(framebufferTarget, attachmentPoint(texture.format(), 0), {&texture, level, layer});
    use();
}

/// Puts back the framebuffers that were bound.
class FramebufferBindings {
  public:
    FramebufferBindings() {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn_);
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    }
    FramebufferBindings(const FramebufferBindings&) = delete;
    FramebufferBindings& operator=(const FramebufferBindings&) = delete;
    ~FramebufferBindings() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawn_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
    }

  private:
    GLint drawn_ = 0, read_ = 0;
};

/// Clears colour 0, or depth and stencil, of the bound framebuffer to zero.
void clearAttached(TexelFormat format) {
    constexpr std::array<GLfloat, 4> kZeros{};
    constexpr std::array<GLint, 4> kIntegers{};
    constexpr std::array<GLuint, 4> kUnsigned{};
    switch (rowOf(format).kind) {
        case base::TexelClass::integer:
            return glClearBufferiv(GL_COLOR, 0, kIntegers.data());
        case base::TexelClass::unsignedInteger:
            return glClearBufferuiv(GL_COLOR, 0, kUnsigned.data());
        case base::TexelClass::depth:
            return glClearBufferfv(GL_DEPTH, 0, kZeros.data());
        case base::TexelClass::depthStencil:
            return glClearBufferfi(GL_DEPTH_STENCIL, 0, 0, 0);
        default:
            return glClearBufferfv(GL_COLOR, 0, kZeros.data());
    }
}

GLbitfield maskOf(TexelFormat format) {
    if (hasStencil(format)) return GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
    return hasDepth(format) ? GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT;
}

}  // namespace

void Texture::clear(const Capabilities& capabilities) {
    const FormatUse use = useOf(capabilities, format_);
    if (use.color || use.depth) {
        // A framebuffer clears layer by layer in every version, and reads no memory.
        const FramebufferBindings bindings;
        for (int level = 0; level < levels_; ++level)
            for (int layer = 0; layer < layers(level); ++layer)
                withAttached(GL_DRAW_FRAMEBUFFER, *this, level, layer, [&] {
                    glDrawBuffer(hasDepth(format_) ? GL_NONE : GL_COLOR_ATTACHMENT0);
                    clearAttached(format_);
                });
        return;
    }
    if (isMultisampled(shape_)) return;
    glActiveTexture(kWorkUnit);
    glBindTexture(glTarget(shape_), id());
    for (int level = 0; level < levels_; ++level) {
        const TextureSize size = sizeOfLevel(shape_, size_, level);
        const std::vector<std::byte> zeros(texelCount(shape_, size) * bytesPerTexel(format_));
        fillLevel(shape_, size, level, nativeTransfer(format_), zeros.data(), zeros.size() / 6);
    }
}

Diagnostics copyTexture(const Capabilities& capabilities, const Texture& from, Texture& to) {
    if (from.shape() != to.shape() || from.format() != to.format() || from.size() != to.size() ||
        from.levels() != to.levels() || from.samples() != to.samples())
        return {diagnose("gpu-E03", describe(from.shape(), from.format(), from.size()) +
                                        " cannot be copied to " +
                                        describe(to.shape(), to.format(), to.size()))};
    clearErrors();
    const FramebufferBindings bindings;
    for (int level = 0; level < from.levels(); ++level) {
        const TextureSize size = sizeOfLevel(from.shape(), from.size(), level);
        if (capabilities.atLeast(4, 3)) {
            const GLenum target = glTarget(from.shape());
            glCopyImageSubData(from.id(), target, level, 0, 0, 0, to.id(), target, level, 0, 0, 0, size.width,
                               size.height, from.layers(level));
            continue;
        }
        for (int layer = 0; layer < from.layers(level); ++layer)
            withAttached(GL_READ_FRAMEBUFFER, from, level, layer, [&] {
                withAttached(GL_DRAW_FRAMEBUFFER, to, level, layer, [&] {
                    glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height,
                                      maskOf(from.format()), GL_NEAREST);
                });
            });
    }
    if (const GLenum code = takeError(); code != GL_NO_ERROR)
        return {allocationError(code, "copying " + describe(from.shape(), from.format(), from.size()))};
    return {};
}

void resolveSamples(const Texture& from, const Texture& to) {
    const FramebufferBindings bindings;
    const TextureSize size = from.size();
    for (int layer = 0; layer < from.layers(); ++layer)
        withAttached(GL_READ_FRAMEBUFFER, from, 0, layer, [&] {
            withAttached(GL_DRAW_FRAMEBUFFER, to, 0, layer, [&] {
                glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height,
                                  GL_COLOR_BUFFER_BIT, GL_NEAREST);
            });
        });
}

}  // namespace glibra::gpu
