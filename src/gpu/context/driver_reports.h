#pragma once
// What a driver reports: messages about calls, and resets of the device.

#include <glad/gl.h>
#include <glibra/diagnostic.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/context/errors.h"

namespace glibra::gpu {

// Collects the driver's messages about glibra's own calls. With GL 4.3 or KHR_debug the driver calls back
// inside the faulty call; below that, check points call glGetError.

struct DebugMessage {
    Severity severity = Severity::note;  ///< GL errors and messages of high severity are errors
    std::string text{};
    bool outOfMemory = false;
    Place place{};  ///< in the scene, where the call was made
};

class DebugLog {
  public:
    /// The number of messages kept; later ones are lost.
    static constexpr std::size_t kMost = 256;

    /// The places in the scene that the device works for. Messages belong to the current one.
    [[nodiscard]] WorkPlaces& places() { return places_; }
    /// Sets the place in the scene that later messages belong to.
    void setPlace(const Place& place) { places_.set(place); }

    /// Below GL 4.3, collects pending errors; `what` names the call ("glTexImage2D"). Otherwise it does
    /// nothing.
    void check(std::string_view what);

    /// Returns the messages so far, oldest first, and empties the log.
    std::vector<DebugMessage> take();
    /// Returns the errors as diagnostics, each at its place, and empties the log: draw-E05 for lack of
    /// memory, gpu-E02 for every other error. Compiler messages are omitted, because the logs of stages and
    /// programs contain them. A create() that failed for lack of memory has left its message here as well.
    Diagnostics takeDiagnostics();
    [[nodiscard]] bool hasError() const;
    /// True if the driver calls back.
    [[nodiscard]] bool callsBack() const { return callsBack_; }

    /// Adds one message. The driver's callback calls this.
    void add(DebugMessage message);
    /// Enables the callback for the current context, if it supports one. The log must keep its address.
    void attach(bool hasDebugOutput);
    /// Disables the callback, for a context that outlives the log.
    void detach();

  private:
    std::vector<DebugMessage> messages_;
    bool callsBack_ = false;
    WorkPlaces places_;
};

// Whether the graphics device still does what this process asks of it. After a reset a driver goes on to
// accept calls, and all that it delivers is empty: pictures are black. Therefore every function of GL that
// delivers something asks for a reset before its caller sees the result. They are replaced in the table of GL
// functions, so that no caller can forget it.

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
