#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/file_access.h"
#include "cli/picture_options.h"
#include "cli/render_arguments.h"
#include "cli/scene_arguments.h"
#include "cli/suite_options.h"
#include "cli/suite_progress.h"
#include "image/video/video_file.h"
#include "suite/golden/golden_store.h"
#include "suite/run/fingerprint.h"
#include "system/interruption.h"

namespace glibra::cli {

namespace fs = std::filesystem;
namespace {

/// file-E13 for each picture that would replace a suite, a golden, or a file that a scene reads.
Diagnostics overwrittenByPictures(const Selection& selection, std::span<const suite::ShotReference> shots,
                                  const suite::RunOptions& options, const SuiteArguments& arguments,
                                  const std::function<bool()>& stop) {
    std::vector<fs::path> pictures;
    for (const suite::ShotReference& each : shots) {
        const suite::Suite& suite = selection.suites[each.suite];
        pictures.push_back(suite::pictureFile(options.onlyRender, suite, suite.shots[each.shot],
                                              selection.suites.size() > 1));
    }
    if (!anyExists(pictures)) return {};
    ReadFiles read;
    read.add(selection, suite::inputsOf(selection.suites, selection.shots,
                                        inputWorkers(arguments, shots.size(), options.sandbox, stop),
                                        arguments.run.timeout));
    for (const suite::Suite& suite : selection.suites)
        for (const suite::Shot& shot : suite.shots)
            if (shot.golden)
                read.add(suite::goldenFolder(suite) / suite::goldenName(shot), "it is a golden of the suite");
    Diagnostics problems;
    for (const fs::path& each : pictures) append(problems, read.overwrittenBy(each, "-o"));
    return problems;
}

/// Writes OUTPUT/SHOT.png (.exr for float pixels); with several suites OUTPUT/SUITE/SHOT.png. Without an
/// output folder, it is SUITE/SHOT.png. With `resume`, shots whose picture exists are left out. Returns the
/// exit status.
int renderSuites(const SuiteArguments& arguments, const std::string& output) {
    int status = kDone;
    const std::optional<Selection> selection = readSelection(arguments, status);
    if (!selection) return status;
    const bool several = selection->suites.size() > 1;
    suite::RunOptions options = arguments.run;
    options.onlyRender = output;
    if (output.empty()) options.onlyRender = several ? "." : selection->suites.front().name;

    // Without -o, the names of all folders are this program's.
    for (const suite::Suite& each : selection->suites) {
        const fs::path folder = several ? options.onlyRender / each.name : options.onlyRender;
        std::error_code failure;
        if ((several || output.empty()) && fs::is_symlink(folder, failure)) {
            print({linkedFolder(folder, "-o")});
            return kSceneIsWrong;
        }
    }
    std::optional<system::Sandbox> sandbox;
    if (arguments.untrusted) {
        std::vector<system::Reach> folders;
        for (const suite::Suite& each : selection->suites)
            folders.push_back(several ? system::Reach(options.onlyRender, each.name)
                                      : system::Reach(options.onlyRender));
        sandbox = sandboxOf(*selection, options.driver, {}, folders);
        if (!sandbox) return kSceneIsWrong;
        options.sandbox = &*sandbox;
        makeWritableFolders(*sandbox);
    }

    std::vector<suite::ShotReference> open;
    for (const suite::ShotReference& each : selection->shots) {
        const suite::Suite& suite = selection->suites[each.suite];
        std::error_code failure;
        if (!arguments.resume ||
            !fs::exists(suite::pictureFile(options.onlyRender, suite, suite.shots[each.shot], several),
                        failure))
            open.push_back(each);
    }

    const system::Interruption interruption;
    const auto isStopped = [&] { return interruption.signal() != 0; };
    if (printErrors(overwrittenByPictures(*selection, open, options, arguments, isStopped)))
        return kSceneIsWrong;
    const bool terminal = system::isTerminal(system::Standard::error);
    SuiteProgress progress(open.size(), terminal);
    std::size_t drawn = 0;
    std::vector<std::string> failed;
    suite::RunEvents events;
    events.begins = [&](const suite::ShotReference& each) {
        progress.begins(selection->suites[each.suite].shots[each.shot].name);
    };
    events.done = [&](const suite::ShotResult& shot) {
        std::string lines = printable(shot.diagnostics, hasColor(system::Standard::error));
        if (!lines.empty()) {
            lines.pop_back();
            progress.print(lines);
        }
        const bool bad = suite::isFailure(shot.verdict);
        if (bad)
            failed.push_back(several ? shot.suite + "/" + shot.shot : shot.shot);
        else
            ++drawn;
        progress.add(bad);
    };
    events.stop = isStopped;
    const suite::RunEnd end = suite::runShots(selection->suites, open, options, events);
    progress.clear();
    print(end.diagnostics);
    if (end.noDriver) return kNoDriver;

    std::string summary = fmt::format("{} of {} shots rendered", drawn, open.size());
    if (open.size() < selection->shots.size())
        summary += fmt::format(", {} exist already", selection->shots.size() - open.size());
    for (std::size_t i = 0; i < failed.size(); ++i) summary += (i == 0 ? ", failed: " : ", ") + failed[i];
    printLine(summary);
    if (end.stopped) {
        printLine("stopped; continue with --resume");
        interruption.obey();
    }
    return failed.empty() ? kDone : kSceneIsWrong;
}

/// Prints why an animation cannot go into the file that -o names. Returns the exit status; kDone if it can.
int checkFilm(const RenderArguments& arguments) {
    if (arguments.outputIsFolder || !arguments.suite.suites.empty()) return kDone;
    if (arguments.frames == 1 && image::isVideo(arguments.output))
        return refuse("-o " + arguments.output +
                      ": a video has several frames; add --frames 60, or name a .png for one picture");
    if (arguments.frames == 1 || !image::isVideo(arguments.output) || image::hasFfmpeg()) return kDone;
    printError("-o " + arguments.output + ": " + image::kFfmpegIsMissing);
    return kNoDriver;
}

/// Checks what CLI11 cannot check, and renders.
int runRenderCommand(RenderArguments& arguments) {
    SceneArguments named;
    if (printErrors(resolveScenes(arguments.scenes, named))) return kSceneIsWrong;
    arguments.scenes = std::move(named.scenes);
    arguments.standardInput = std::move(named.standardInput);
    arguments.outputIsFolder = named.hasFolder || arguments.scenes.size() > 1;
    // A filter: the scene comes in, the picture goes out.
    if (arguments.standardInput && arguments.output.empty() && !arguments.outputIsFolder)
        arguments.output = "-";
    const bool isMany = arguments.outputIsFolder || !arguments.suite.suites.empty();
    if (arguments.output == "-" && isMany)
        return refuse("-o - writes the pictures of one scene, not of several; name a folder");
    if (arguments.output == "-" && system::isTerminal(system::Standard::output))
        return refuse("a picture cannot be shown on a terminal; name a file with -o, or add > FILE");
    if (arguments.statsFile == "-" && (arguments.output == "-" || arguments.explain || arguments.trace))
        return refuse(std::string("--stats - writes to standard output, and so does ") +
                      (arguments.explain ? "--explain"
                       : arguments.trace ? "--trace"
                                         : "the picture") +
                      "; name a file for one of them");
    if (!acceptsSet(arguments.picture.options.set)) return kWrongUsage;
    if (const int status = checkFilm(arguments); status != kDone) return status;
    std::set<fs::path> names{fs::path(arguments.output).filename()};
    for (const std::string& each : arguments.saves) {
        const auto save = readSave(each);
        if (!save) return refuse("--save " + each + ": expected NAME=FILE, such as shadow=shadow.exr");
        if (save->file == "-")
            return refuse("--save " + each + ": '-' does not mean standard output here; name a file");
        if (!names.insert(save->file.filename()).second)
            return refuse("--save " + each + ": another file has the same name");
    }
    if (!arguments.saves.empty() && arguments.scenes.size() > 1)
        return refuse("--save writes the textures and buffers of one scene, not of several");
    if (arguments.untrusted && !prepareUntrusted()) return kNoDriver;
    if (!arguments.suite.suites.empty()) {
        arguments.suite.untrusted = arguments.untrusted;
        arguments.suite.run.driver = arguments.driver;
        arguments.suite.run.jobs = arguments.jobs;
        arguments.suite.run.ofAll = arguments.picture;
        return renderSuites(arguments.suite, arguments.output);
    }
    if (arguments.scenes.empty())
        return refuse("expected a scene (.glib) or a folder of scenes, or a suite after --suite");
    std::vector<fs::path>& roots = arguments.picture.options.libraryRoots;
    for (fs::path& each : libraryRoots()) roots.push_back(std::move(each));
    return renderScenes(arguments);
}

}  // namespace

void addRender(CommandLine& program, int& status) {
    auto arguments = std::make_shared<RenderArguments>();
    CommandLine command = program.subcommand(
        "render", "renders scenes to pictures, without a window or a display",
        "glibra render teapot.glib                            # writes teapot.png\n"
        "glibra render scenes/ -o pictures/ --size 800x600    # all scenes of a folder\n"
        "glibra render arrow.glib --frames 60 -o film.mp4     # or film.gif; film.png: film_0000.png ...");
    RenderArguments& to = *arguments;
    const Option scenes =
        command.list("SCENE", to.scenes, "scene files (.glib) or folders of them; - is standard input");
    Option suite = command
                       .list("--suite", to.suite.suites,
                             "render the shots of a suite instead: a TOML file or a folder of scenes")
                       .excludes(scenes);
    command.option("-o,--output", to.output,
                   "file of the picture, or a folder for several; the ending of the name decides the "
                   "format; - is standard output (PNG)");
    addPictureOptions(command, to.picture);
    command
        .option("--frames", to.frames,
                "render an animation of so many frames: to one .gif or .apng, to one .mp4, .webm, .mkv, .mov "
                "or .avi (by the program ffmpeg), or else to NAME_0000.png, NAME_0001.png, ...")
        .within(1, 1'000'000);
    command.option("--fps", to.framesPerSecond, "frames per second of an animation")
        .within(1e-3, 1e6)
        .withDefault();
    command.driver(to.driver);
    command.jobs(to.jobs);
    addSelectionOptions(command, to.suite);
    for (const char* each : {"--only", "--shard", "--resume"}) command.find(each).needs(suite).rare();
    command
        .repeated(
            "--save", to.saves,
            "write a texture of the scene, a part of it, or a buffer to a file as well: shadow=shadow.exr, "
            "glow.level(2)=glow.png, sky.face(0)=px.png, Particles=particles.csv (or .npy)")
        .placeholder("NAME=FILE");
    command.flag("--explain", to.explain, "print what was made, what was skipped and why");
    command.flag(
        "--check-order", to.checkOrder,
        "draw the picture again with the invocations of shaders that store in memory in another order, "
        "and name what differs");
    command.flag("--trace", to.trace, "print the OpenGL calls of the picture, with places in the scene");
    addUntrustedOption(command, to.untrusted);
    command.option("--stats", to.statsFile,
                   "file for the times and counts of every stage, as JSON; - is standard output");
    for (const char* each : {"--driver", "--stats", "--save", "--untrusted", "--trace"})
        command.find(each).rare();
    excludePictureOptions(command, suite);
    for (const char* each :
         {"--frames", "--fps", "--save", "--explain", "--check-order", "--trace", "--stats"})
        suite.excludes(command.find(each));
    command.onRun([arguments, timeout = command.find("--timeout"), &status] {
        if (timeout.isGiven()) arguments->suite.run.timeout = arguments->picture.timeout;
        arguments->suite.run.memory = arguments->picture.memory;
        status = runRenderCommand(*arguments);
    });
}

}  // namespace glibra::cli
