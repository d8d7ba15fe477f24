#pragma once
// Drawing in an adopted context, beside the code of others: into their framebuffers and textures, and from a
// state that does not depend on theirs.

#include <glad/gl.h>
#include <glibra/result.h>

#include "gpu/context/context.h"
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

// The state that every picture starts from, also in contexts in which the code of others draws.

/// In an adopted context, which is current: sets that state, which others may have changed, and empties the
/// log. Does nothing in contexts that were opened here.
void takeBackState(const Context& context);

}  // namespace glibra::gpu
