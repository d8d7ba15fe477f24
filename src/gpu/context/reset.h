#pragma once
// Whether the graphics device still does what this process asks of it. After a reset a driver goes on to
// accept calls, and all that it delivers is empty: pictures are black. Therefore every function of GL that
// delivers something asks for a reset before its caller sees the result. They are replaced in the table of GL
// functions, so that no caller can forget it.

#include <glad/gl.h>

#include "gpu/context/work_places.h"

namespace glibra::gpu {

/// Begins to watch the context that is current, after its functions have been loaded. `places`: the
/// statements of a scene that are being drawn; it must live as long as the context is used.
void watchDevice(WorkPlaces& places);
/// Call it when the context ends.
void unwatchDevice(const WorkPlaces& places);

/// Throws base::DeviceLost if the driver has reset the device since the context was made. Every function of
/// GL that delivers content, counts, logs or errors calls it afterwards, as does glFinish. Without the
/// extension KHR_robustness a reset is noticed by the error GL_CONTEXT_LOST alone.
void expectDevice();
/// True if the driver of the watched context tells of a reset by that error alone.
bool resetIsOnlyAnError();

/// While one lives, nothing is finished by functions that usually wait for all work: pixels go into a buffer.
class NothingFinished {
  public:
    NothingFinished();
    NothingFinished(const NothingFinished&) = delete;
    NothingFinished& operator=(const NothingFinished&) = delete;
    ~NothingFinished();
};

}  // namespace glibra::gpu
