#pragma once
// The files of a hardcopy, a frame at a time, so that a window stays usable while they are made.

#include <glibra/result.h>

#include <memory>

#include "gpu/context.h"
#include "view/export/hardcopy.h"

namespace glibra::view {

class HardcopyJob {
  public:
    /// The scene as its files are now, with the session's present values, view and time; what happens to the
    /// session afterwards changes nothing. file-E10 for a video without ffmpeg. The context must outlive it.
    static Result<HardcopyJob> begin(gpu::Context& context, const Session& session, const Hardcopy& wanted);
    HardcopyJob(HardcopyJob&&) noexcept;
    HardcopyJob& operator=(HardcopyJob&&) noexcept;
    /// A video that is not whole leaves no file; frames that are written stay.
    ~HardcopyJob();

    /// Draws and writes the next frame; the last one completes a video. After an error nothing follows.
    Diagnostics step();
    [[nodiscard]] bool isDone() const;
    [[nodiscard]] int framesWritten() const;
    [[nodiscard]] const Hardcopy& wanted() const;

  private:
    struct State;
    explicit HardcopyJob(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace glibra::view
