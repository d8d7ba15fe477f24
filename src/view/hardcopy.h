#pragma once
// The picture of a session as files, drawn by the same code as `glibra render`.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <functional>
#include <string>

#include "gpu/context.h"
#include "view/session.h"

namespace glibra::view {

struct Hardcopy {
    std::filesystem::path file;
    int width = 0, height = 0;  ///< pixels; 0: as on the screen
    int frames = 1;             ///< several: NAME_0000.png ..., from the present time on
    double framesPerSecond = 30;
};

/// The command line that gives the same files: "glibra render scene.glib -o out.png --size 800x600 ...",
/// words quoted for a shell where they need it.
std::string renderCommand(const Session& session, const Hardcopy& wanted);

/// The command line's words from the scene's values on: "--set uKd=.5 --set ...".
std::string setArguments(const Session& session);

/// Draws and writes. PNG files carry the command line under the keyword "Comment". `progress` is told the
/// number of frames written and may end it by false.
Diagnostics writeHardcopy(gpu::Context& context, const Session& session, const Hardcopy& wanted,
                          const std::function<bool(int)>& progress = {});

/// The frames as a video, encoded by the program ffmpeg, which is told in what it finds wrong; the ending of
/// the file decides the format. file-E10 if there is no ffmpeg.
Diagnostics writeVideo(gpu::Context& context, const Session& session, const Hardcopy& wanted,
                       const std::function<bool(int)>& progress = {});

/// True if a program ffmpeg is found in PATH.
bool hasFfmpeg();

}  // namespace glibra::view
