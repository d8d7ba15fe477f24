#pragma once
// Reads pixels from the device into memory, top row first.

#include <glad/gl.h>
#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/format/pixel_format.h"
#include "gpu/object/buffer.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/name.h"

namespace glibra::gpu {

/// A rectangle of a framebuffer in window coordinates: (0, 0) is the lower left pixel.
struct PixelRectangle {
    int x = 0, y = 0, width = 0, height = 0;
};

using PixelLayout = TexelLayout;

/// Reverses the order of the rows.
void flipRows(std::span<std::byte> pixels, std::size_t rowBytes);

/// The bytes of such a rectangle with tightly packed rows.
std::size_t byteCount(const PixelRectangle& rectangle, const PixelLayout& layout);

/// glReadPixels from the framebuffer that is bound for reading. OpenGL ES gives few layouts, from which the
/// pixels are converted.
void readBound(const PixelRectangle& rectangle, GLenum format, GLenum type, std::byte* pixels);

/// Reads colour `index` of the framebuffer into `pixels`, which must have byteCount bytes. Rows are tightly
/// packed, from top to bottom; parts outside the framebuffer are undefined. Waits for pending draws. GL
/// rounds normalised formats to nearest (u8: 1/255); float formats read as u8 or u16 are first limited to
/// 0..1. Reports gpu-E03 if the sizes do not fit, draw-E05 or gpu-E02 for errors of the driver.
Diagnostics readPixels(const Capabilities& capabilities, const Framebuffer& framebuffer, int index,
                       const PixelRectangle& rectangle, const PixelLayout& layout,
                       std::span<std::byte> pixels);

/// The same, into newly allocated memory.
Result<std::vector<std::byte>> readPixels(const Capabilities& capabilities, const Framebuffer& framebuffer,
                                          int index, const PixelRectangle& rectangle,
                                          const PixelLayout& layout);

// Reads pixels from the device while it goes on drawing: what glReadPixels writes into a buffer is taken
// later.

/// Pictures of one size, of which kMost may be under way. Each has a buffer in memory that the processor
/// reads directly (GL 4.4: mapped while the stream lives), which costs four bytes per pixel, or its floats.
class PixelStream {
  public:
    static constexpr std::size_t kMost = 2;

    explicit PixelStream(const Capabilities& capabilities) : capabilities_(capabilities) {}
    PixelStream(const PixelStream&) = delete;
    PixelStream& operator=(const PixelStream&) = delete;
    ~PixelStream();

    /// Begins to read, after all that was drawn before. Fewer than kMost readings may be under way. The
    /// arguments and the errors are those of readPixels; draw-E05 also if there is no memory for the buffer.
    Diagnostics begin(const Framebuffer& framebuffer, int index, const PixelRectangle& rectangle,
                      const PixelLayout& layout);
    /// Waits until the reading that was begun first is done, and gives the bytes that readPixels would give.
    /// `pixels` has byteCount() bytes.
    Diagnostics take(std::span<std::byte> pixels);
    [[nodiscard]] std::size_t underWay() const { return begun_ - taken_; }

  private:
    struct Slot {
        Name<glDeleteBuffers> buffer;
        std::size_t bytes = 0;
        const std::byte* mapped = nullptr;  ///< null: it is mapped to be read
        GLsync done = nullptr;
        PixelRectangle rectangle;
        PixelLayout layout;
    };
    bool makeBuffer(Slot& slot, std::size_t bytes) const;

    const Capabilities& capabilities_;
    std::array<Slot, kMost> slots_;
    std::size_t begun_ = 0, taken_ = 0;
};

}  // namespace glibra::gpu
