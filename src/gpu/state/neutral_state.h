#pragma once
// The state that every picture starts from, also in contexts in which the code of others draws.

#include "gpu/context/context.h"

namespace glibra::gpu {

/// Sets that state whatever the code of others has set: everything of OpenGL 4.6 core, chapter 23, that
/// changes what is drawn, uploaded or read and that a draw, an upload or a readback does not set by itself.
/// A conditional rendering ends, transform feedback pauses, and errors that nobody has asked for are
/// discarded. What belongs to objects stays, as do queries that run.
void setNeutralState(const Capabilities& capabilities);

/// In an adopted context, which is current: sets that state, which others may have changed, and empties the
/// log. Does nothing in contexts that were opened here.
void takeBackState(const Context& context);

}  // namespace glibra::gpu
