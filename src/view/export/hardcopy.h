#pragma once
// Hardcopies: the picture of a session as files, drawn by the same code as `glibra render`.

#include <filesystem>
#include <string>

#include "view/session/session.h"

namespace glibra::view {

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

}  // namespace glibra::view
