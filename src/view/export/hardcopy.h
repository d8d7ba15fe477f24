#pragma once
// The picture of a session as files, drawn by the same code as `glibra render`.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <string>

#include "gpu/context.h"
#include "view/scene/session.h"

namespace glibra::view {

struct Hardcopy {
    std::filesystem::path file;
    int width = 0, height = 0;  ///< pixels; 0: as on the screen
    int frames = 1;             ///< from the present time on; several that are no video: NAME_0000.png ...
    double framesPerSecond = 30;
};

/// The command line that gives the same files: "glibra render scene.glib -o out.png --size 800x600 ...",
/// words quoted for a shell where they need it.
std::string renderCommand(const Session& session, const Hardcopy& wanted);

/// The command line's words from the scene's values on: "--set uKd=.5 --set ...".
std::string setArguments(const Session& session);

/// True if the ending is that of a video: .mp4, .webm, .mkv, .avi, .mov, .gif.
bool isVideo(const std::filesystem::path& file);

/// Draws and writes all of it. PNG files carry the command line under the keyword "Comment", EXR, TIFF, JPEG
/// and most videos as their comment or description; BMP has no place for it. A video is encoded by the
/// program ffmpeg, and file-E10 without it. For one frame after the other: HardcopyJob.
Diagnostics writeHardcopy(gpu::Context& context, const Session& session, const Hardcopy& wanted);

}  // namespace glibra::view
