#pragma once
// Whether the exercise of the shown scene is solved, with the texts that are being edited: both scenes are
// drawn at every moment of the exercise's file, one moment per frame (suite/run/exercise_check.h).

#include <cstdint>
#include <string>
#include <vector>

#include "suite/file/sweep.h"
#include "view/session/session.h"

namespace glibra::view {

class SolutionCheck {
  public:
    /// The context must outlive the object. Of the options those count that Session takes.
    SolutionCheck(gpu::Context& context, const RenderOptions& options);

    /// Draws the next moment; begins anew when the shown scene has been loaded again. Returns true if more is
    /// to be drawn.
    bool follow(const Session& shown);

    enum class State { none, drawing, solved, unsolved };
    [[nodiscard]] State state() const { return state_; }
    /// "solved, with 8 sets of values"; "not solved yet: at aim=2 its picture differs ..."; empty without an
    /// exercise.
    [[nodiscard]] std::string text() const;

    /// Forgets what is on the device, because it is lost; restoreDevice() loads the scenes again.
    void releaseDevice();
    void restoreDevice();

  private:
    void begin(const Session& shown);
    void drawMoment();
    void refuse(std::string why);

    gpu::Context& context_;
    Session solution_, own_;
    std::vector<suite::Moment> moments_;
    std::size_t next_ = 0;  ///< moment
    State state_ = State::none;
    std::string why_;
    std::filesystem::path path_;
    std::uint64_t loads_ = 0;  ///< of the shown scene
    bool isSet_ = false;       ///< both scenes have the values of the moment
};

}  // namespace glibra::view
