#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <thread>

#include "cli/commands.h"
#include "cli/interruption.h"
#include "cli/render_answer.h"
#include "cli/suite_options.h"
#include "cli/suite_render.h"
#include "gpu/context.h"
#include "gpu/hardware.h"
#include "image/file.h"
#include "plan/uniforms.h"
#include "render/animation.h"
#include "render/job.h"
#include "render/workers.h"
#include "suite/run/run.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

struct RenderArguments {
    std::vector<std::string> scenes;
    std::string output;
    std::string size;
    std::string statsFile;
    Driver driver = Driver::automatic;
    RenderOptions options;
    int frames = 1;
    double framesPerSecond = 30;
    int jobs = 0;  ///< 0: a process a processor
    double timeout = 300;
    SuiteArguments suite;
    bool noShim = false;
    bool noSkip = false;
    bool explain = false;
};

/// "WxH", both 1..kLargestPictureSide.
std::optional<std::pair<int, int>> parseSize(const std::string& text) {
    int width = 0;
    int height = 0;
    char rest = 0;
    // NOLINTNEXTLINE(cert-err34-c): the count of matched fields is checked, and the width of the numbers is
    // bounded
    if (std::sscanf(text.c_str(), "%6dx%6d%c", &width, &height, &rest) != 2) return std::nullopt;
    if (width < 1 || height < 1 || width > kLargestPictureSide || height > kLargestPictureSide)
        return std::nullopt;
    return std::pair(width, height);
}

/// The file each scene is written to. Without -o the scene's name in the current folder; several scenes of
/// one name keep the folders in which they differ.
std::vector<fs::path> outputFiles(const RenderArguments& arguments) {
    std::vector<fs::path> names;
    std::set<std::string> distinct;
    for (const std::string& scene : arguments.scenes) {
        names.push_back(fs::path(scene).filename().replace_extension(".png"));
        distinct.insert(names.back().string());
    }
    if (distinct.size() < names.size()) {
        fs::path common = fs::absolute(arguments.scenes.front()).lexically_normal().parent_path();
        for (const std::string& scene : arguments.scenes) {
            const fs::path folder = fs::absolute(scene).lexically_normal().parent_path();
            while (!common.empty() && common != common.parent_path() &&
                   std::mismatch(common.begin(), common.end(), folder.begin(), folder.end()).first !=
                       common.end())
                common = common.parent_path();
        }
        for (std::size_t i = 0; i < names.size(); ++i)
            names[i] = fs::absolute(arguments.scenes[i])
                           .lexically_normal()
                           .lexically_relative(common)
                           .replace_extension(".png");
    }
    if (arguments.output.empty()) return names;
    const bool isFolder =
        arguments.scenes.size() > 1 || fs::is_directory(arguments.output) || arguments.output.back() == '/';
    for (fs::path& name : names)
        name = isFolder ? fs::path(arguments.output) / name : fs::path(arguments.output);
    return names;
}

int jobsOf(const RenderArguments& arguments) {
    return arguments.jobs > 0 ? arguments.jobs : suite::defaultJobs();
}

/// Processes that an animation is divided among: two with half the frames each draw them sooner on a software
/// rasteriser than one with all its threads. Figures and explanations are those of one process.
int partsOf(const RenderArguments& arguments) {
    constexpr int kLeastFrames = 8;  // what a process's start is worth
    constexpr int kMostParts = 8;    // each holds all that the scene reads
    const int most = std::min({arguments.frames / kLeastFrames, kMostParts, jobsOf(arguments)});
    if (arguments.scenes.size() > 1 || arguments.explain || !arguments.statsFile.empty() || most < 2 ||
        gpu::mayUseHardware(arguments.driver))
        return 1;
    const int different =
        render::mostDifferentFrames(arguments.scenes.front(), arguments.options, arguments.frames,
                                    arguments.framesPerSecond, most * kLeastFrames);
    return std::max(1, different / kLeastFrames);
}

/// Runs in the worker: opens the context with its first job and keeps it.
class JobRunner {
  public:
    /// Each scene is drawn in `parts` pieces.
    JobRunner(const RenderArguments& arguments, std::vector<fs::path> outputs, std::size_t parts)
        : arguments_(arguments), outputs_(std::move(outputs)), parts_(parts) {}

    std::string operator()(std::size_t piece, const render::Step& step) {
        const std::size_t index = piece / parts_;
        Answer answer;
        if (!context_) {
            suite::shareProcessors(jobsOf(arguments_), arguments_.scenes.size() * parts_);
            Result<gpu::Context> opened = gpu::openContext({.driver = arguments_.driver});
            if (!opened) return pack({.status = kNoDriver, .remarks = {std::move(opened.diagnostics), {}}});
            context_.emplace(std::move(*opened));
        }
        render::Job job;
        job.scene = arguments_.scenes[index];
        job.output = outputs_[index];
        job.options = arguments_.options;
        job.frames = arguments_.frames;
        job.framesPerSecond = arguments_.framesPerSecond;
        job.part = static_cast<int>(piece % parts_);
        job.parts = static_cast<int>(parts_);
        job.explain = arguments_.explain;
        job.stats = !arguments_.statsFile.empty();
        render::JobResult result;
        try {
            result = render::runJob(
                *context_, job, [&](int written) { step(std::to_string(written)); }, &shared_);
        } catch (const std::bad_alloc&) {
            result.failed = true;
            result.diagnostics.push_back(error("draw-E05", "out of memory", {job.scene.string(), 1, 1}));
        } catch (const std::exception& failure) {
            result.failed = true;
            result.diagnostics.push_back(error("draw-E06", failure.what(), {job.scene.string(), 1, 1}));
        }
        answer.status = result.failed ? kSceneIsWrong : kDone;
        answer.remarks = {std::move(result.diagnostics), std::move(result.ofFrames)};
        answer.explanation = std::move(result.explanation);
        answer.statsJson = std::move(result.statsJson);
        return pack(answer);
    }

  private:
    const RenderArguments& arguments_;
    std::vector<fs::path> outputs_;
    std::size_t parts_;
    std::optional<gpu::Context> context_;
    render::SharedParts shared_;  // after the context: it has to go first
};

/// The line "[3/60] scene.glib" that is rewritten on a terminal, and nothing elsewhere.
class ProgressLine {
  public:
    ProgressLine(bool shown, std::size_t scenes, int frames)
        : shown_(shown && (scenes > 1 || frames > 1)), total_(scenes * static_cast<std::size_t>(frames)) {}
    void show(std::size_t done, const std::string& what) const {
        if (shown_) std::fprintf(stderr, "\r\033[K[%zu/%zu] %s", done, total_, what.c_str());
    }
    void clear() const {
        if (shown_) std::fputs("\r\033[K", stderr);
    }

  private:
    bool shown_;
    std::size_t total_;
};

int renderAll(RenderArguments& arguments) {
    const bool terminal = ::isatty(STDERR_FILENO) == 1;
    const std::vector<fs::path> outputs = outputFiles(arguments);
    std::error_code ignored;  // a folder that cannot be made is reported with the file that cannot be written
    for (const fs::path& each : outputs)
        if (each.has_parent_path()) fs::create_directories(each.parent_path(), ignored);

    const auto parts = static_cast<std::size_t>(partsOf(arguments));
    JobRunner runner(arguments, outputs, parts);
    const ProgressLine progress(terminal, arguments.scenes.size(), arguments.frames);
    int status = kDone;
    std::vector<std::string> failed;
    std::vector<std::string> stats(arguments.scenes.size());
    std::vector<int> framesDone(arguments.scenes.size() * parts);
    std::size_t doneCount = 0;
    std::vector<render::AnimationRemarks> remarks;  // of parts: told when all are there

    const auto done = [&](std::size_t piece, const render::Outcome& outcome) {
        const std::size_t index = piece / parts;
        const std::string& scene = arguments.scenes[index];
        if (outcome.end == render::Outcome::End::stopped) {
            image::removeTemporaryFiles(outputs[index].parent_path(), outcome.process);
            return;
        }
        Answer answer;
        if (outcome.end == render::Outcome::End::finished) {
            answer = unpack(outcome.answer);
        } else {
            answer.status = kSceneIsWrong;
            const std::string text =
                outcome.end == render::Outcome::End::timedOut
                    ? fmt::format("not drawn within {:g} seconds (--timeout)", arguments.timeout)
                    : fmt::format("the process that drew it ended with signal {}; the other scenes go on",
                                  outcome.signal);
            answer.remarks.general = {
                error(outcome.end == render::Outcome::End::timedOut ? "draw-E07" : "draw-E06", text,
                      {scene, 1, 1})};
            // The worker could not remove what it had half written.
            image::removeTemporaryFiles(outputs[index].parent_path(), outcome.process);
        }
        progress.clear();
        if (parts > 1)
            remarks.push_back(std::move(answer.remarks));
        else
            print(render::joined({answer.remarks}));
        std::fwrite(answer.explanation.data(), 1, answer.explanation.size(), stdout);
        std::fflush(stdout);
        stats[index] = std::move(answer.statsJson);
        status = std::max(status, answer.status);
        if (answer.status != kDone) failed.push_back(scene);
        if (parts == 1) doneCount += static_cast<std::size_t>(arguments.frames - framesDone[piece]);
        progress.show(doneCount, scene);
    };
    const auto step = [&](std::size_t piece, const std::string& text) {
        const int frames = std::stoi(text);
        doneCount += static_cast<std::size_t>(frames - framesDone[piece]);
        framesDone[piece] = frames;
        progress.show(doneCount, arguments.scenes[piece / parts]);
    };
    const Interruption interruption;
    render::runInWorkers(arguments.scenes.size() * parts,
                         {.workers = jobsOf(arguments),
                          .timeout = arguments.timeout,
                          .stop = [&] { return interruption.signal() != 0; }},
                         std::ref(runner), done, step);
    progress.clear();
    print(render::joined(remarks));
    interruption.obey();

    if (arguments.scenes.size() > 1) {
        std::string summary = fmt::format("{} of {} scenes rendered", arguments.scenes.size() - failed.size(),
                                          arguments.scenes.size());
        for (std::size_t i = 0; i < failed.size(); ++i) summary += (i == 0 ? ", failed: " : ", ") + failed[i];
        std::fprintf(stderr, "%s\n", summary.c_str());
    }
    if (!arguments.statsFile.empty()) {
        std::string all;
        for (const std::string& each : stats)
            if (!each.empty()) all += (all.empty() ? "" : ",\n") + each;
        if (arguments.scenes.size() > 1) all = "[" + all + "]";
        all += '\n';
        const Diagnostics problems =
            image::writeFileAtomically(arguments.statsFile, std::as_bytes(std::span(all)));
        print(problems);
        if (hasError(problems)) status = std::max(status, kSceneIsWrong);
    }
    return status;
}

/// What CLI11 cannot check by itself.
int run(RenderArguments& arguments) {
    if (!arguments.size.empty()) {
        const auto size = parseSize(arguments.size);
        if (!size) {
            std::fprintf(stderr,
                         "glibra: error: --size %s is not WxH with 1 to 65536 pixels a side, as 800x600\n",
                         arguments.size.c_str());
            return kWrongUsage;
        }
        std::tie(arguments.options.width, arguments.options.height) = *size;
    }
    if (arguments.output == "-" && (arguments.scenes.size() > 1 || arguments.frames > 1)) {
        std::fprintf(stderr, "glibra: error: -o - takes one picture\n");
        return kWrongUsage;
    }
    for (const std::string& each : arguments.options.set) {
        const Result<plan::Override> parsed = plan::parseOverride(each);
        print(parsed.diagnostics);
        if (!parsed) return kWrongUsage;
    }
    if (!arguments.suite.suites.empty()) {
        arguments.suite.driver = arguments.driver;
        arguments.suite.jobs = arguments.jobs;
        arguments.suite.skip = !arguments.noSkip;
        return renderSuites(arguments.suite, arguments.output);
    }
    if (arguments.scenes.empty()) {
        std::fprintf(stderr, "glibra: error: name a scene (.glib), or a suite by --suite\n");
        return kWrongUsage;
    }
    arguments.options.shim = !arguments.noShim;
    arguments.options.skip = !arguments.noSkip;
    arguments.options.libraryRoots = libraryRoots();
    return renderAll(arguments);
}

}  // namespace

void addRender(CLI::App& app, int& status) {
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App* command = app.add_subcommand("render", "scenes to images, without a window or a display");
    RenderArguments& to = *arguments;
    CLI::Option* scenes = command->add_option("SCENE", to.scenes, "scene files (.glib)");
    CLI::Option* suite =
        command
            ->add_option("--suite", to.suite.suites, "render the shots of a suite: a TOML file or a folder")
            ->excludes(scenes);
    command->add_option(
        "-o,--output", to.output,
        "image file, or folder for several; the name's ending decides the format; - is standard output");
    command->add_option("--size", to.size, "WxH in pixels instead of the scene's WindowSize");
    command->add_option("--time", to.options.time, "seconds since the start of the scene")
        ->check(CLI::Range(-1e9, 1e9));
    command
        ->add_option("--frames", to.frames, "number of frames of an animation, written as NAME_0000.png ...")
        ->check(CLI::Range(1, 1'000'000));
    command->add_option("--fps", to.framesPerSecond, "frames a second of an animation")
        ->check(CLI::Range(1e-3, 1e6))
        ->capture_default_str();
    command->add_option("--set", to.options.set, "NAME=VALUE sets a uniform, as uKd=.5 or uColor=1,.5,0")
        ->allow_extra_args(false);
    command
        ->add_option("--view", to.options.view,
                     "auto moves the eye out of a scene, glman leaves it where it is")
        ->transform(CLI::CheckedTransformer(std::map<std::string, ViewPolicy>{{"auto", ViewPolicy::automatic},
                                                                              {"glman", ViewPolicy::glman}}));
    command->add_option("--samples", to.options.samples, "samples a pixel")->check(CLI::Range(1, 64));
    addBudgetOptions(*command, to.options);
    addViewOptions(*command, to.options.viewState);
    command->add_flag("--axes", to.options.axes, "draw the axes of eye space, two units long");
    command->add_flag("--alpha", to.options.alpha, "keep the window's alpha in the image");
    command->add_option("--driver", to.driver, "which OpenGL: auto, egl, egl-device, osmesa")
        ->transform(CLI::CheckedTransformer(kDriversByWord));
    command->add_option("--jobs", to.jobs, "worker processes; without it one a processor")
        ->check(CLI::Range(1, 256));
    command->add_option("--timeout", to.timeout, "seconds that one picture may take, 0 for no limit")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
    command->add_option("--tile", to.options.tileSize, "side of the tiles of large pictures in pixels")
        ->check(CLI::Range(16, 16384));
    addSelectionOptions(*command, to.suite);
    for (const char* each : {"--only", "--shard", "--resume"}) command->get_option(each)->needs(suite);
    command->add_flag(
        "--check-nan", to.options.checkNan,
        "name the draws that put NaN or infinity into the picture, or lose what they draw by it");
    command->add_flag("--strict", to.options.strict, "warnings are errors");
    command->add_flag("--no-shim", to.noShim,
                      "compile the shaders as they are, without translating their dialect");
    command->add_flag("--no-skip", to.noSkip,
                      "read, make and draw also what the picture does not need; it stays the same");
    command->add_flag("--explain", to.explain, "say what was made, what was skipped and why");
    command->add_option("--stats", to.statsFile, "write times and counts of every stage as JSON");
    // What the suite says for each shot.
    for (const char* each : {"--size", "--time", "--frames", "--fps", "--set", "--view", "--samples",
                             "--max-error", "--override-counts", "--axes", "--alpha", "--tile", "--strict",
                             "--no-shim", "--explain", "--stats"})
        suite->excludes(command->get_option(each));
    command->callback([arguments, command, &status] {
        if (command->count("--timeout") > 0) arguments->suite.timeout = arguments->timeout;
        status = run(*arguments);
    });
}

}  // namespace glibra::cli
