#pragma once
// Reads pixels from the device while it goes on drawing: what glReadPixels writes into a buffer is taken
// later.

#include <glad/gl.h>
#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <span>

#include "gpu/context/capabilities.h"
#include "gpu/object/buffer.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/name.h"
#include "gpu/object/readback.h"

namespace glibra::gpu {

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
