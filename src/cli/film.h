#pragma once
// `glibra render --frames N -o film.mp4`: the frames of an animation as one file.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <functional>
#include <optional>

namespace glibra::cli {

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

}  // namespace glibra::cli
