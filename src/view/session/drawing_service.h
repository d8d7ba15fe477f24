#pragma once
// Draws a scene in a process of its own, which can be ended when a shader of the scene does not end. The
// window starts its own program again for this. It starts with the first picture that is asked for.

#include <glibra/diagnostic.h>
#include <glibra/render.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/live/live_scene.h"
#include "system/child_process.h"

namespace glibra::view {

/// A picture that is wanted.
struct DrawingOrder {
    std::string text;  ///< orderText()
    int width = 0, height = 0;
    double time = 0;            ///< of the scene, seconds
    std::uint64_t loading = 0;  ///< another number: the scene is another one
    bool watchesLoops = false;  ///< Session::watchLoops()
    friend bool operator==(const DrawingOrder&, const DrawingOrder&) = default;
};

class DrawingProcess {
  public:
    enum class State {
        working,  ///< no new picture yet
        drawn,
        late,    ///< drawing took longer than the limit; the process was ended
        ended,   ///< the process has ended by itself: the driver crashed
        missing  ///< it cannot be started, or it has no driver
    };

    DrawingProcess() = default;
    DrawingProcess(const DrawingProcess&) = delete;
    DrawingProcess& operator=(const DrawingProcess&) = delete;
    ~DrawingProcess() { end(); }

    /// Asks for that picture, unless it is being drawn already, and waits a moment for it if it was not. A
    /// picture that is being drawn is finished first if it is of the same loading. `limit`: seconds that
    /// drawing may take.
    State draw(const DrawingOrder& wanted, double limit);
    /// After State::drawn: the order that was carried out, its diagnostics, and its pixels: 4 bytes each,
    /// bottom row first. They are valid until the next call of draw().
    [[nodiscard]] const DrawingOrder& order() const { return sent_; }
    [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }
    [[nodiscard]] std::span<const std::byte> pixels() const {
        return child_ ? child_->memory.bytes() : std::span<const std::byte>();
    }
    [[nodiscard]] double seconds() const { return seconds_; }  ///< that drawing them took, without loading
    /// Ends the process. The next picture starts another one.
    void end();

  private:
    bool send(const DrawingOrder& order);
    State wait(double seconds, double limit);
    [[nodiscard]] bool isLate(double limit) const;

    std::optional<system::ChildProcess> child_;
    std::string received_;
    DrawingOrder sent_;
    Diagnostics diagnostics_;
    bool isWorking_ = false, hasDrawn_ = false;
    std::chrono::steady_clock::time_point begun_;
    double processorSeconds_ = 0;  ///< that the process had used then
    double seconds_ = 0;
    bool isLoading_ = false;
};

/// What a frame of a live scene depends on, besides the scene's files.
struct DrawnState {
    std::filesystem::path scene;
    std::uint64_t loading = 0;        ///< another number: the scene is loaded again
    RenderOptions options;            ///< of loading: view policy, library roots, shim, texts
    std::vector<render::Knob> knobs;  ///< title, tag and current values
    ViewState view;
    std::string camera;
    double time = 0;
    bool axes = false, wireframe = false;
    struct Mouse {
        double x = .5, y = .5;
        bool isDown = false;
        friend bool operator==(const Mouse&, const Mouse&) = default;
    } mouse;
    bool watchesLoops = false;  ///< LiveScene::watchLoops() comes first
    int width = 1, height = 1, samples = 1;
};

/// As bytes, which serveDrawing() takes.
std::string orderText(const DrawnState& state);

/// The work of the process: draws what the messages of the window ask for into the shared memory, until
/// the channel is closed. Returns the exit status.
int serveDrawing();

}  // namespace glibra::view
