#pragma once
// What the driver says about our own calls, collected instead of printed. With GL 4.3 or KHR_debug the driver
// calls back at the faulty call; below that, glGetError is asked at check points.

#include <glad/gl.h>
#include <glibra/diagnostic.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glibra::gpu {

struct DebugMessage {
    Severity severity = Severity::note;  ///< GL errors and what the driver calls severe are errors
    GLenum source = 0;
    GLenum type = 0;
    GLuint id = 0;
    std::string text{};
    bool outOfMemory = false;
    Place place{};  ///< where in the scene we were
};

class DebugLog {
  public:
    /// Most messages kept; later ones are only counted.
    static constexpr std::size_t kMost = 256;

    /// The scene's place that following messages belong to.
    void setPlace(const Place& place) { place_ = place; }

    /// Below GL 4.3 asks for errors that are pending; `what` names the call ("glTexImage2D"). Nothing to do
    /// otherwise.
    void check(std::string_view what);

    /// Messages so far, oldest first; forgets them.
    std::vector<DebugMessage> take();
    /// The errors among them as diagnostics, each at its place: draw-E05 for lack of memory, gpu-E02 for
    /// every other error of ours or the driver's. Forgets all messages. What a compiler says is left out:
    /// logs of stages and programs have it. A create() that failed for lack of memory has left its message
    /// here too.
    Diagnostics takeDiagnostics();
    [[nodiscard]] bool hasError() const;
    [[nodiscard]] std::size_t dropped() const { return dropped_; }
    /// True if the driver calls back by itself.
    [[nodiscard]] bool callsBack() const { return callsBack_; }

    /// Adds one message; what the driver's callback does.
    void add(DebugMessage message);
    /// Switches the callback on for the current context, if it has one. The log must stay where it is.
    void attach(bool hasDebugOutput);
    /// Switches it off again for a context that lives on.
    void detach();

  private:
    std::vector<DebugMessage> messages_;
    std::size_t dropped_ = 0;
    bool callsBack_ = false;
    Place place_;
};

}  // namespace glibra::gpu
