#pragma once
// Framebuffers and textures that belong to the code of others, in an adopted context.

#include <glad/gl.h>
#include <glibra/result.h>

#include "gpu/object/framebuffer.h"
#include "gpu/object/readback.h"

namespace glibra::gpu {

/// Where a picture goes: a framebuffer by its name, 0 for the window's own, or level 0 of a 2D texture, if
/// its name is not 0. The rectangle has the picture's size; what lies outside of the framebuffer is cut off.
struct ForeignTarget {
    GLuint framebuffer = 0;
    GLuint texture = 0;
    PixelRectangle rectangle{};
};

/// The width and height of a 2D texture; library-E08 if there is none of this name, or it has no level 0.
Result<TextureSize> sizeOfForeign(GLuint texture);

/// Copies the first colour of the target, resolved, into all colours that the framebuffer has for drawing.
/// Values become those of its format without any encoding. `isOpaque`: alpha becomes 1. Leaves the target's
/// framebuffer bound. Reports library-E08 for what cannot be drawn into, and draw-E05 or gpu-E02 for errors
/// of the driver.
Diagnostics copyInto(const ForeignTarget& to, const Target& from, bool isOpaque);

}  // namespace glibra::gpu
