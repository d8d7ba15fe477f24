#pragma once
// Measures the GPU time of the objects of a frame: its draws and dispatches, without clears, panels, and the
// exchange of the window's buffers. This is what glman's frame rate counts.

#include <array>
#include <cstddef>
#include <deque>
#include <optional>

#include "gpu/object/timer.h"
#include "render/draw/frame.h"

namespace glibra::view {

/// The times of a frame are read when the device has done it, a few frames later, so that nothing waits.
class ObjectTimer {
  public:
    explicit ObjectTimer(const gpu::Capabilities& capabilities);
    ObjectTimer(const ObjectTimer&) = delete;
    ObjectTimer& operator=(const ObjectTimer&) = delete;

    /// False if the driver has no timer.
    [[nodiscard]] bool measures() const { return timer_.measures(); }
    /// Measures the frame that `drawer` draws next. `plan` is the drawer's.
    void begin(render::FrameDrawer& drawer, const plan::FramePlan& plan);
    /// Ends the measurement of that frame.
    void end(render::FrameDrawer& drawer);
    /// Waits for the frames that are not read yet.
    void finish();
    /// Forgets the frames so far.
    void forget();
    /// GPU time per frame, mean of the last frames. Nothing before the first is known.
    [[nodiscard]] std::optional<double> milliseconds() const;

    static constexpr std::size_t kFrames = 16;  ///< that the mean is taken of

  private:
    struct Frame {
        double milliseconds = 0;
        std::size_t begun = 0, known = 0;  ///< pieces: draws of a pass, or a dispatch
        bool isForgotten = false;
    };
    void beginPiece();
    void settle();

    gpu::Timer timer_;          ///< its pieces are numbers of frames
    std::deque<Frame> frames_;  ///< that are not known yet
    std::size_t first_ = 0;     ///< number of the first of them
    bool isDrawing_ = false;    ///< the last of them
    bool isInPiece_ = false;
    std::array<double, kFrames> known_{};
    std::size_t measured_ = 0;
};

}  // namespace glibra::view
