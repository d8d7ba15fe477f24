#pragma once
// Zink records a clear and carries it out with the next draw into the same framebuffer. Until then
// glReadPixels into memory gives what was there before (Mesa 22 and 25), and the clear wipes out what a
// dispatch stores (Mesa 25).

#include <glad/gl.h>
#include <cstddef>
#include <optional>

#include "gpu/context/capabilities.h"
#include "gpu/object/buffer.h"
#include "gpu/object/program.h"

namespace glibra::gpu {

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
