#pragma once
// Collects the driver's messages about glibra's own calls. With GL 4.3 or KHR_debug the driver calls back
// inside the faulty call; below that, check points call glGetError.

#include <glad/gl.h>
#include <glibra/diagnostic.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glibra::gpu {

struct DebugMessage {
    Severity severity = Severity::note;  ///< GL errors and messages of high severity are errors
    GLenum source = 0;
    GLenum type = 0;
    GLuint id = 0;
    std::string text{};
    bool outOfMemory = false;
    Place place{};  ///< in the scene, where the call was made
};

class DebugLog {
  public:
    /// The number of messages kept; later ones are only counted.
    static constexpr std::size_t kMost = 256;

    /// Sets the place in the scene that later messages belong to.
    void setPlace(const Place& place);
    [[nodiscard]] const Place& place() const { return place_; }
    /// The places since the device was known to be idle.
    struct Unfinished {
        Place first;       ///< without a file: none
        int lastLine = 0;  ///< the last one in the same file
    };
    [[nodiscard]] Unfinished unfinished() const { return isFinished_ ? Unfinished{} : unfinished_; }
    /// The device has done all that it was given.
    void finishPlaces() { isFinished_ = true; }

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
    [[nodiscard]] std::size_t dropped() const { return dropped_; }
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
    std::size_t dropped_ = 0;
    bool callsBack_ = false;
    Place place_;
    Unfinished unfinished_;
    bool isFinished_ = true;  ///< the next place is the first unfinished one
};

}  // namespace glibra::gpu
