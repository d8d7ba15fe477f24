#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/text.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/file_access.h"
#include "cli/picture_options.h"
#include "suite/options/option_table.h"
#include "system/terminal.h"
#include "view/browse/example_scenes.h"
#include "view/session/drawing_service.h"
#include "view/window/window.h"

namespace {

using glibra::cli::kNoDriver;
using glibra::cli::kSceneIsWrong;
using glibra::cli::kWrongUsage;

/// file-E13 for files that would replace a scene or the recorded input.
glibra::Diagnostics overwritten(const glibra::view::WindowArguments& arguments) {
    glibra::cli::ReadFiles read;
    for (const std::filesystem::path& each : arguments.scenes) read.add(each, "the window shows it");
    read.add(arguments.replayFile, "it is replayed");
    glibra::Diagnostics problems = read.overwrittenBy(arguments.stateFile, "--state");
    append(problems, read.overwrittenBy(arguments.recordFile, "--record"));
    return problems;
}

int run(glibra::view::WindowArguments& arguments, const std::string& size) {
    if (const glibra::Diagnostics problems = overwritten(arguments); !problems.empty()) {
        for (const glibra::Diagnostic& each : problems) glibra::cli::printLine(glibra::toString(each));
        return kSceneIsWrong;
    }
    if (!size.empty()) {
        char rest = 0;
        // NOLINTNEXTLINE(cert-err34-c): the count of matched fields is checked, and the width of the numbers
        // is bounded
        const int fields = std::sscanf(size.c_str(), "%5dx%5d%c", &arguments.options.width,
                                       &arguments.options.height, &rest);
        if (fields != 2 || arguments.options.width < 1 || arguments.options.height < 1) {
            std::fprintf(stderr, "glibra: error: --size %s: expected WIDTHxHEIGHT, for example 800x600\n",
                         size.c_str());
            return kWrongUsage;
        }
    }
    arguments.options.libraryRoots = glibra::cli::libraryRoots();
    int status = 0;
    for (const glibra::Diagnostic& each : glibra::view::runWindow(arguments)) {
        glibra::cli::printLine(glibra::toString(each));
        if (each.severity != glibra::Severity::error) continue;
        status = each.id == "view-E02" || each.id == "gpu-E01" ? kNoDriver : kWrongUsage;
    }
    return status;
}

int start(int argc, char** argv) {
    glibra::cli::Program program("shows a scene in a window, with a slider for every range",
                                 "glibra view teapot.glib\n"
                                 "glibra view a.glib b.glib --paused           # two tabs\n"
                                 "glibra view teapot.glib --set uShininess=20 --size 800x600",
                                 "glibra view");
    glibra::cli::CommandLine line = program.line();
    glibra::view::WindowArguments arguments;
    std::vector<std::string> scenes;
    std::string size;
    std::string thumbnails;
    line.list("SCENE", scenes, "scene files (.glib), one tab each");
    // The window starts this program with --thumbnails to make pictures of scenes; see example_scenes.h.
    line.option("--thumbnails", thumbnails, "").hidden();
    // The window starts this program with --draw-for-window to draw shaders that may not end; see
    // drawing_service.h.
    bool drawsForWindow = false;
    line.flag("--draw-for-window", drawsForWindow, "").hidden();
    line.repeated("--set", arguments.set,
                  "value of a uniform: NAME=VALUE, or PROGRAM:NAME=VALUE for one program");
    line.option("--size", size, "size of the picture in pixels: WIDTHxHEIGHT");
    int samples = -1;
    line.option("--samples", samples,
                "smooth edges on the screen: samples per pixel (the setting, at first 4; 0 or 1: none)")
        .within(0, 32);
    glibra::suite::Shot given;
    line.option("--time", given.options.time, "time at the start, in seconds").within(0.0, 1e9);
    line.flag("--paused", arguments.paused, "start with the time paused");
    for (const glibra::suite::OptionRow& row : glibra::suite::optionTable())
        if (row.inWindow) glibra::cli::addPictureOption(line, row.name, given);
    line.option("--state", arguments.stateFile,
                "write the window's state to this file as JSON whenever it changes")
        .written();
    line.option("--record", arguments.recordFile, "record the input of every frame in this file").written();
    line.option("--replay", arguments.replayFile, "play the recorded input of this file, then quit")
        .existingFile();
    if (const std::optional<int> status = program.parse(argc, argv)) return *status;
    if (drawsForWindow) return glibra::view::serveDrawing();
    arguments.options = given.options;
    if (samples >= 0) arguments.samples = samples;
    arguments.scenes.assign(scenes.begin(), scenes.end());
    if (!thumbnails.empty())
        return glibra::view::makeThumbnails(thumbnails, arguments.scenes, glibra::cli::libraryRoots());
    return run(arguments, size);
}

}  // namespace

int main(int argc, char** argv) {
    if (!glibra::system::openStandardFiles()) return kNoDriver;
    try {
        return glibra::cli::endProgram(start(argc, argv));
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "glibra: error: %s\n", glibra::base::reasonOf(failure).c_str());
        return kNoDriver;
    }
}
