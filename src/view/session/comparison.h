#pragma once
// Another scene beside the shown one, as the solution of an exercise beside a student's work: it gets the
// size, samples, time, values and view of the shown scene, and both pictures are compared.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "suite/file/sweep.h"
#include "view/session/session.h"

namespace glibra::view {

class Comparison {
  public:
    /// The context must outlive the object. Of the options those count that Session takes.
    Comparison(gpu::Context& context, const RenderOptions& options)
        : context_(context), other_(context, options) {}

    /// Shows that scene. Returns why it cannot be read; empty on success.
    std::string open(const std::filesystem::path& scene);
    [[nodiscard]] const std::filesystem::path& path() const { return other_.path(); }
    /// Session::setContained for the other scene, and Session::isDrawing.
    void setContained(bool on) { other_.setContained(on); }
    [[nodiscard]] bool isDrawing() const { return other_.isDrawing(); }

    /// Draws the other scene like the last picture of `own` (Session::showLike), and keeps both pictures.
    /// They are always of one moment: another process may draw the other scene, and until its picture is
    /// there the earlier two stay. Returns true if the pictures are new.
    bool follow(const Session& own);
    /// RGBA in bytes, top row first; null before both are drawn.
    [[nodiscard]] const image::Image* own() const { return own_ ? &*own_ : nullptr; }
    [[nodiscard]] const image::Image* other() const { return picture_ ? &*picture_ : nullptr; }
    /// The first error of the other scene; empty without one.
    [[nodiscard]] std::string problem() const;

    /// How the pictures differ, as `glibra class` measures it; 0 is no difference.
    struct Score {
        double flip = 0, structure = 0;
    };
    /// Computes the score of the two pictures if it is not known. Nothing without pictures of one size.
    std::optional<Score> score();
    /// The same if it was computed for the present pictures.
    [[nodiscard]] const std::optional<Score>& known() const { return score_; }

    /// Forgets what is on the device, because it is lost; restoreDevice() loads the scene again.
    void releaseDevice() {
        other_.releaseDevice();
        forgetPictures();
    }
    void restoreDevice() { other_.restoreDevice(); }

  private:
    void forgetPictures() {
        own_.reset();
        waiting_.reset();
        picture_.reset();
        score_.reset();
    }

    gpu::Context& context_;
    Session other_;
    std::optional<image::Image> own_, picture_;
    std::optional<image::Image> waiting_;  ///< the next own_, until the other scene is drawn like it
    std::optional<Score> score_;
    std::uint64_t ownFrames_ = 0;
};

/// The scene that solves the exercise: the file beside the scene names it (suite/file/sweep.h). Empty
/// if there is none.
std::filesystem::path solutionOf(const std::filesystem::path& scene);

/// Writes the file of an exercise beside the copy of its scene, with the whole path of the solution.
/// Does nothing without an exercise, or if the copy has such a file. Errors: file-E10.
Diagnostics copyExercise(const std::filesystem::path& scene, const std::filesystem::path& copy);

// Whether the exercise of the shown scene is solved, with the texts that are being edited: both scenes are
// drawn at every moment of the exercise's file, one moment per frame (suite/run/exercise_check.h).

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
