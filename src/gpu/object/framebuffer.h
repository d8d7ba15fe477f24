#pragma once
// Renderbuffers, which are drawn into but never sampled, and framebuffers made of renderbuffers and textures.

#include <glad/gl.h>
#include <glibra/result.h>

#include <optional>
#include <span>
#include <variant>

#include "gpu/context/capabilities.h"
#include "gpu/format/pixel_format.h"
#include "gpu/object/name.h"
#include "gpu/object/texture.h"

namespace glibra::gpu {

/// Colour or depth of every pixel, with one or more samples.
class Renderbuffer {
  public:
    /// Makes storage for colours or depth. `samples` is limited to what the driver supports. Reports gpu-E04
    /// for a size beyond the driver's limit and draw-E05 for lack of memory.
    static Result<Renderbuffer> create(const Capabilities& capabilities, int width, int height,
                                       TexelFormat format, int samples = 1);

    [[nodiscard]] TexelFormat format() const { return format_; }
    [[nodiscard]] GLuint id() const { return name_.get(); }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    /// As the driver gave it; 1: not multisampled.
    [[nodiscard]] int samples() const { return samples_; }

  private:
    Name<glDeleteRenderbuffers> name_;
    TexelFormat format_ = TexelFormat::rgba8;
    int width_ = 0, height_ = 0, samples_ = 1;
};

/// A level of a texture: one layer or face of it, or all of them, between which the geometry stage chooses by
/// gl_Layer.
struct TexturePart {
    const Texture* texture = nullptr;
    int level = 0;
    std::optional<int> layer{};

    [[nodiscard]] TextureSize size() const { return sizeOfLevel(texture->shape(), texture->size(), level); }
    [[nodiscard]] bool isLayered() const { return !layer && texture->layers(level) > 1; }
};

/// GL_COLOR_ATTACHMENT0 + index, GL_DEPTH_ATTACHMENT or GL_DEPTH_STENCIL_ATTACHMENT.
GLenum attachmentPoint(TexelFormat format, std::size_t index);
/// Attaches it to the framebuffer bound to GL_DRAW_FRAMEBUFFER or GL_READ_FRAMEBUFFER.
void attachTexture(GLenum framebufferTarget, GLenum point, const TexturePart& part);

/// A colour or the depth of a framebuffer: a 2D texture, a part of any texture, or a renderbuffer. It must
/// outlive the framebuffer.
using Attachment = std::variant<const Texture*, const Renderbuffer*, TexturePart>;
inline constexpr Attachment kNothing{static_cast<const Renderbuffer*>(nullptr)};

class Framebuffer {
  public:
    /// Colour output i goes to colors[i]. `depth` may hold a null pointer. Reports gpu-E05 if the driver
    /// cannot draw into that combination.
    static Result<Framebuffer> create(std::span<const Attachment> colors, const Attachment& depth = kNothing);

    void bindForDrawing() const { glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name_.get()); }
    void bindForReading() const { glBindFramebuffer(GL_READ_FRAMEBUFFER, name_.get()); }
    [[nodiscard]] GLuint id() const { return name_.get(); }
    [[nodiscard]] int colorCount() const { return colorCount_; }

  private:
    Name<glDeleteFramebuffers> name_;
    int colorCount_ = 0;
};

}  // namespace glibra::gpu
