#pragma once
// What a session shows, as files: hardcopies and shots of a suite.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <filesystem>
#include <memory>
#include <string>

#include "gpu/context/context.h"
#include "view/session/session.h"

namespace glibra::view {

// Hardcopies: the picture of a session as files, drawn by the same code as `glibra render`.

struct Hardcopy {
    std::filesystem::path file;
    int width = 0, height = 0;  ///< pixels; 0: the size on the screen
    int frames = 1;             ///< from the current time on; several become NAME_0000.png ... or one film
    double framesPerSecond = 30;
    int samples = 1;  ///< per pixel, limited to what the driver has
};

/// The command line that writes the same files: "glibra render scene.glib -o out.png --size 800x600 ...".
/// Words are quoted for a shell where necessary.
std::string renderCommand(const Session& session, const Hardcopy& wanted);

/// The arguments for the changed values: "--set uKd=0.5 --set ...".
std::string setArguments(const Session& session);

/// True if the frames go into one file: several frames to a .gif, or any number to an .mp4, .webm, ...
bool isFilm(const Hardcopy& wanted);

/// The first file that a hardcopy writes: with several frames of pictures it is NAME_0000.png.
std::filesystem::path firstFile(const Hardcopy& wanted);

/// True if a file of that name exists which the hardcopy would replace.
bool replacesFile(const Hardcopy& wanted);

/// The name of a hardcopy that replaces nothing: `wanted.file` itself, or else NAME-2, NAME-3, ... A number
/// that the name has already is counted on.
std::filesystem::path freeName(Hardcopy wanted);

// Writes a hardcopy one frame at a time, so that the window stays usable meanwhile.

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

// Writes what a session shows as a shot of a suite, from which `glibra test` renders the same picture.

/// Returns the text of a [[shot]] with the scene and all options that differ from their defaults: size,
/// changed values, time (if a program reads it), view, axes and so on. A comment names what else the screen
/// shows (Session::onlyOnScreen). Paths are relative to `folder`, the folder of the suite file.
std::string shotText(const Session& session, const std::string& name, const std::filesystem::path& folder);

/// Appends the shot to a suite file, which is made if it does not exist. The earlier content stays byte for
/// byte. Nothing is written if the file is not a suite, has a shot of that name, or the name is not valid;
/// the diagnostics are those of suite::readSuiteText.
Diagnostics appendShot(const std::filesystem::path& suite, const std::string& name, const Session& session);

/// Returns a name that the suite does not have yet: that of the scene, with a number if necessary.
std::string freeShotName(const std::filesystem::path& suite, const Session& session);

}  // namespace glibra::view
