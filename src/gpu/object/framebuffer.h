#pragma once
// Renderbuffers, which are drawn into but never sampled, and framebuffers made of renderbuffers and textures.

#include <glad/gl.h>
#include <glibra/result.h>

#include <span>
#include <variant>

#include "gpu/context/capabilities.h"
#include "gpu/format/pixel_format.h"
#include "gpu/object/name.h"
#include "gpu/object/texture.h"

namespace glibra::gpu {

inline void deleteRenderbuffer(GLuint name) {
    glDeleteRenderbuffers(1, &name);
}
inline void deleteFramebuffer(GLuint name) {
    glDeleteFramebuffers(1, &name);
}

/// Colour or depth of every pixel, with one or more samples.
class Renderbuffer {
  public:
    /// Makes colour storage. `samples` is limited to what the driver supports. Reports gpu-E04 for a size
    /// beyond the driver's limit and draw-E05 for lack of memory.
    static Result<Renderbuffer> color(const Capabilities& capabilities, int width, int height,
                                      TexelFormat format, int samples = 1);
    /// Makes depth storage of 24 bits or more.
    static Result<Renderbuffer> depth(const Capabilities& capabilities, int width, int height,
                                      int samples = 1);

    [[nodiscard]] GLuint id() const { return name_.get(); }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    /// As the driver gave it; 1: not multisampled.
    [[nodiscard]] int samples() const { return samples_; }

  private:
    static Result<Renderbuffer> create(const Capabilities& capabilities, int width, int height, GLenum format,
                                       std::size_t bytesPerPixel, int samples);
    Name<deleteRenderbuffer> name_;
    int width_ = 0, height_ = 0, samples_ = 1;
};

/// One colour of a framebuffer: a 2D texture or a renderbuffer, which must outlive the framebuffer.
using ColorAttachment = std::variant<const Texture*, const Renderbuffer*>;

class Framebuffer {
  public:
    /// Colour output i goes to colors[i]. `depth` may be null. Reports gpu-E05 if the driver cannot draw into
    /// that combination.
    static Result<Framebuffer> create(std::span<const ColorAttachment> colors, const Renderbuffer* depth);

    void bindForDrawing() const { glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name_.get()); }
    void bindForReading() const { glBindFramebuffer(GL_READ_FRAMEBUFFER, name_.get()); }
    [[nodiscard]] GLuint id() const { return name_.get(); }
    [[nodiscard]] int colorCount() const { return colorCount_; }

  private:
    Name<deleteFramebuffer> name_;
    int colorCount_ = 0;
};

}  // namespace glibra::gpu
