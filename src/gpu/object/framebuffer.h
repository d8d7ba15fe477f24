#pragma once
// Renderbuffers, which are drawn into but never sampled, and framebuffers made of renderbuffers and textures.

#include <glad/gl.h>
#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/format/pixel_format.h"
#include "gpu/object/buffer.h"
#include "gpu/object/name.h"
#include "gpu/object/program.h"
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

// What a pass is drawn into: colours and depth of one size, with any number of samples, readable after
// resolve().

/// A depth buffer that several targets may share.
using SharedDepth = std::shared_ptr<const Renderbuffer>;

class Target {
  public:
    /// Makes a substitute for a window: one colour of that format and a depth buffer.
    static Result<Target> window(const Capabilities& capabilities, int width, int height, TexelFormat format,
                                 int samples = 1, TexelFormat depthFormat = TexelFormat::depth24);
    /// Makes a target of 2D textures of one size, which must outlive the target: colour output i goes to
    /// textures[i]. With several samples, the textures get their content at resolve(). Without `depth` the
    /// target makes a depth buffer; a given one must have the same size and number of samples.
    static Result<Target> textures(const Capabilities& capabilities, std::span<const Texture* const> textures,
                                   int samples = 1, SharedDepth depth = {});

    /// Makes a target of parts of textures, which must outlive it: colour output i goes to colors[i], depth
    /// and stencil to `depth`. All have the same size and number of samples; layered and other parts do not
    /// go together. With colours only, the target makes a depth buffer of `implicitFormat`, if that is one; a
    /// given one must fit, and only targets without layers use it. Nothing is resolved. Reports gpu-E05 if
    /// they do not fit together.
    static Result<Target> parts(const Capabilities& capabilities, std::span<const TexturePart> colors,
                                const std::optional<TexturePart>& depth, SharedDepth implicitDepth = {},
                                std::optional<TexelFormat> implicitFormat = TexelFormat::depth24);

    /// Binds the target for drawing and sets the viewport to the whole of it.
    void bind() const;
    /// Clears a colour of the bound target, all samples. Only float formats keep values outside 0..1.
    void clearColor(int index, const std::array<float, 4>& rgba) const;
    /// The same for any format: integers get the truncated values.
    void clearColorOfAnyFormat(int index, const std::array<double, 4>& rgba) const;
    /// Clears the depth of the bound target, by default to the far plane.
    void clearDepth(float depth = 1) const;
    void clearStencil(int value = 0) const;
    /// Averages the samples into what readable() reads; does nothing for one sample. Call bind() again before
    /// drawing more.
    void resolve() const;

    /// The framebuffer that pixels are read from, after resolve().
    [[nodiscard]] const Framebuffer& readable() const { return resolved_ ? *resolved_ : drawn_; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] int samples() const { return samples_; }
    [[nodiscard]] TexelFormat format() const { return format_; }
    /// True if a colour is sRGB: colours are encoded where GL_FRAMEBUFFER_SRGB is on.
    [[nodiscard]] bool hasSrgb() const;
    /// The depth buffer that the target made or was given; null for a depth texture and with layers.
    [[nodiscard]] const SharedDepth& depth() const { return depth_; }

  private:
    // Storage is declared before the framebuffers that refer to it, so that it is destroyed after them.
    // Framebuffers refer to renderbuffers by address, hence the pointers.
    std::vector<std::unique_ptr<const Renderbuffer>> storage_;
    SharedDepth depth_;
    std::unique_ptr<const Texture> layeredDepth_;
    std::vector<TexelFormat> formats_;  ///< of the colours
    Framebuffer drawn_;
    std::optional<Framebuffer> resolved_;
    int width_ = 0, height_ = 0, samples_ = 1;
    TexelFormat format_ = TexelFormat::rgba8;
};

// Zink records a clear and carries it out with the next draw into the same framebuffer. Until then
// glReadPixels into memory gives what was there before (Mesa 22 and 25), and the clear wipes out what a
// dispatch stores (Mesa 25).

// Sets buffers to zero by what the driver does fastest.

/// Drivers of graphics cards keep a new buffer in the processor's memory until a shader uses it, and their
/// glClearBufferSubData fills it there: 256 MB take 131 ms, and by a compute shader 13 ms (NVIDIA H100,
/// driver 580). The state of GL is as before.
class BufferClearer {
  public:
    void clear(const Capabilities& capabilities, Buffer& buffer);

    /// By a compute shader, whatever the size; false if the driver cannot.
    bool clearByShader(const Capabilities& capabilities, Buffer& buffer);

  private:
    static constexpr std::size_t kLarge = std::size_t{1} << 20;

    std::optional<Program> program_;
};

/// Carries out all clears so far. Call it after a clear that no draw into the framebuffer follows.
inline void settleClears(const Capabilities& capabilities) {
    if (capabilities.defersClears) glFlush();
}

}  // namespace glibra::gpu
