#pragma once
// Hardcopies: the picture of a session as files, drawn by the same code as `glibra render`.

#include <filesystem>
#include <string>

#include "view/session/session.h"

namespace glibra::view {

struct Hardcopy {
    std::filesystem::path file;
    int width = 0, height = 0;  ///< pixels; 0: the size on the screen
    int frames = 1;             ///< from the current time on; several become NAME_0000.png ... or one video
    double framesPerSecond = 30;
};

/// The command line that writes the same files: "glibra render scene.glib -o out.png --size 800x600 ...".
/// Words are quoted for a shell where necessary.
std::string renderCommand(const Session& session, const Hardcopy& wanted);

/// The arguments for the changed values: "--set uKd=0.5 --set ...".
std::string setArguments(const Session& session);

/// True if the file's extension is that of a video: .mp4, .webm, .mkv, .avi, .mov, .gif.
bool isVideo(const std::filesystem::path& file);

}  // namespace glibra::view
