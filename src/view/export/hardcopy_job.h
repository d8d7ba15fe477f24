#pragma once
// Writes a hardcopy one frame at a time, so that the window stays usable meanwhile.

#include <glibra/result.h>

#include <memory>
#include <string>

#include "gpu/context/context.h"
#include "view/export/hardcopy.h"

namespace glibra::view {

class HardcopyJob {
  public:
    /// Loads the scene from its files, with the session's current values, view and time. Later changes of the
    /// session have no effect. PNG, EXR, TIFF and JPEG files and most videos carry the command line as their
    /// comment; BMP files cannot. Films are encoded by the program ffmpeg; without it the result is
    /// file-E10, as when there is not enough memory. The context must outlive the job.
    static Result<HardcopyJob> begin(gpu::Context& context, const Session& session, const Hardcopy& wanted);
    HardcopyJob(HardcopyJob&&) noexcept;
    HardcopyJob& operator=(HardcopyJob&&) noexcept;
    /// An incomplete film is removed; frames that are already written stay.
    ~HardcopyJob();

    /// Draws and writes the next frame; the last one completes a film. The job is done after an error.
    Diagnostics step();
    [[nodiscard]] bool isDone() const;
    [[nodiscard]] int framesWritten() const;
    /// Names the files that exist now: "/home/a/film_0000.png to film_0059.png: 60 files of 600 x 400
    /// pixels". Empty if there is none yet, as while a film is written.
    [[nodiscard]] std::string filesWritten() const;
    [[nodiscard]] const Hardcopy& wanted() const;

  private:
    struct State;
    explicit HardcopyJob(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace glibra::view
