#pragma once
// Zink records a clear and carries it out with the next draw into the same framebuffer. Until then
// glReadPixels into memory gives what was there before (Mesa 22 and 25), and the clear wipes out what a
// dispatch stores (Mesa 25).

#include <glad/gl.h>

#include "gpu/context/capabilities.h"

namespace glibra::gpu {

/// Carries out all clears so far. Call it after a clear that no draw into the framebuffer follows.
inline void settleClears(const Capabilities& capabilities) {
    if (capabilities.defersClears) glFlush();
}

}  // namespace glibra::gpu
