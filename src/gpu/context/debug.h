#pragma once
// Collects the driver's messages about glibra's own calls. With GL 4.3 or KHR_debug the driver calls back
// inside the faulty call; below that, check points call glGetError.

#include <glad/gl.h>
#include <glibra/diagnostic.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/context/work_places.h"

namespace glibra::gpu {

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

}  // namespace glibra::gpu
