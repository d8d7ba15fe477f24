#pragma once
// What the command line of `glibra render` states.

#include <glibra/diagnostic.h>
#include <glibra/render.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/suite_options.h"
#include "image/file.h"
#include "render/file/job.h"
#include "suite/suite.h"

namespace glibra::cli {

struct RenderArguments : render::JobOptions {
    std::vector<std::string> scenes;
    /// The text of the scene kStandardInput, if it is one of them.
    std::optional<std::string> standardInput;
    std::string output;           ///< file or folder; empty: the scenes' names in the current folder
    bool outputIsFolder = false;  ///< `output` is a folder, whether it exists or not
    std::string statsFile;        ///< --stats; "-" is standard output
    suite::Shot picture;          ///< what the options of a picture state
    Driver driver = Driver::automatic;
    int jobs = 0;  ///< 0: gpu::usualWorkers()
    SuiteArguments suite;
    std::vector<std::string> saves;  ///< --save, each NAME=FILE
    bool untrusted = false;
};

// The files of `glibra render`.

/// Who chose the names of the pictures: the user with -o FILE, and this command otherwise, also for frames.
image::NamedBy namedBy(const RenderArguments& arguments);
/// True if all frames go into one file.
bool isFilm(const RenderArguments& arguments);
/// The file, or the first of the files, that a worker writes for a film.
std::filesystem::path framesOf(std::filesystem::path film);

// `glibra render --frames N -o film.mp4`: the frames of an animation as one file.

/// Where an animation goes, and how fast it runs.
struct Film {
    std::filesystem::path file;
    int frames = 1;
    double framesPerSecond = 30;
};

/// Joins frames that are PNG files to one file. `frameFile` gives the file of a frame, or nothing if it was
/// not drawn, because of an error that is reported elsewhere; then no film is written. `stop` ends the work
/// without a film. Errors: file-E10.
Diagnostics writeFilm(const Film& film,
                      const std::function<std::optional<std::filesystem::path>(int frame)>& frameFile,
                      const std::function<bool()>& stop);

// `glibra render SCENE...`: scenes to pictures, in worker processes.

/// The texture and the file of a --save; nothing if it is not NAME=FILE.
std::optional<render::Job::Save> readSave(const std::string& text);

/// Renders the scenes and prints what went wrong. Returns the exit status: the worst of all scenes.
int renderScenes(const RenderArguments& arguments);

}  // namespace glibra::cli
