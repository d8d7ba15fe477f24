
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/contained_call.h"
#include "base/workers.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/file_access.h"
#include "cli/info_output.h"
#include "cli/picture_options.h"
#include "cli/render_answer.h"
#include "cli/scene_arguments.h"
#include "gpu/context/context.h"
#include "image/file.h"
#include "render/check/answers.h"
#include "render/check/run_checks.h"
#include "render/check/scene_check.h"
#include "render/consequences.h"
#include "suite/report/terminal_report.h"
#include "suite/run/exercise_check.h"
#include "suite/run/run_options.h"
#include "system/interruption.h"

namespace glibra::cli {
namespace {

struct CheckArguments {
    std::vector<std::string> scenes;
    std::optional<std::string> standardInput;  ///< the text of the scene kStandardInput
    suite::Shot picture;
    Driver driver = Driver::automatic;
    bool json = false;
    std::string translated;
    int jobs = 0;  ///< 0: gpu::usualWorkers()
    bool untrusted = false;
    bool run = false;
    bool web = false;
};

/// Writes each shader to the folder, which is made if it does not exist.
Diagnostics writeShaders(const std::vector<render::TranslatedShader>& shaders,
                         const std::filesystem::path& folder, const ReadFiles& read) {
    if (shaders.empty()) return {};
    Diagnostics problems;
    std::error_code ignored;  // reported with the first file that cannot be written
    std::filesystem::create_directories(folder, ignored);
    for (const render::TranslatedShader& each : shaders) {
        const std::filesystem::path file = folder / std::filesystem::path(each.name).filename();
        Diagnostics refused = read.overwrittenBy(file, "--translated");
        if (refused.empty())
            refused = image::writeFileAtomically(file, std::as_bytes(std::span(each.source)),
                                                 image::NamedBy::program);
        append(problems, std::move(refused));
    }
    return problems;
}

/// True if something is wrong besides checks that do not hold.
bool hasErrorOfScene(const Diagnostics& diagnostics) {
    return std::ranges::any_of(diagnostics, [](const Diagnostic& each) {
        return each.severity == Severity::error && !each.id.starts_with("check-");
    });
}

/// The folder of each scene's shaders in `folder`: with several scenes one that has the scene's name, within
/// the folders below the one that all of them are in.
std::vector<std::filesystem::path> shaderFolders(const std::vector<std::string>& scenes,
                                                 const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> folders(scenes.size(), folder);
    if (scenes.size() < 2 || folder.empty()) return folders;
    std::vector<std::filesystem::path> places;
    for (const std::string& each : scenes)
        places.push_back(
            std::filesystem::absolute(each == kStandardInput ? "standard_input" : each).lexically_normal());
    std::filesystem::path common = places.front().parent_path();
    for (const std::filesystem::path& each : places)
        while (std::ranges::mismatch(common, each).in1 != common.end()) common = common.parent_path();
    for (std::size_t i = 0; i < places.size(); ++i)
        folders[i] = folder / places[i].lexically_relative(common).replace_extension();
    return folders;
}

/// Runs in a worker. It opens the context with its first scene and keeps it.
class SceneChecker {
  public:
    SceneChecker(const CheckArguments& arguments, int jobs) : arguments_(arguments), jobs_(jobs) {}

    std::string operator()(std::size_t index, const base::Step& step) {
        if (!context_) {
            suite::shareProcessors(jobs_, arguments_.scenes.size());
            Result<gpu::Context> opened = gpu::openContext({.driver = arguments_.driver});
            if (!opened) return pack({.status = kNoDriver, .remarks = {std::move(opened.diagnostics), {}}});
            context_.emplace(std::move(*opened));
        }
        const std::string& scene = arguments_.scenes[index];
        return pack(guarded(scene, [&] {
            const RenderOptions options =
                optionsFor(scene, arguments_.standardInput, arguments_.picture.options);
            render::CheckResult checked =
                render::checkScene(*context_, scene, options, &shared_, arguments_.web);
            if (arguments_.translated.empty()) checked.shaders.clear();
            if (arguments_.run) checked.diagnostics = runOf(scene, options, std::move(checked.diagnostics));
            // The limit of time is that of a picture, and an exercise has several.
            if (arguments_.run && !options.sceneText && !hasErrorOfScene(checked.diagnostics))
                append(checked.diagnostics,
                       suite::checkExercise(*context_, scene, options, [&] { step({}); }));
            SourceLines lines;
            if (quotesLines_) lines = linesOf(checked.diagnostics, arguments_.standardInput);
            return Answer{.remarks = {std::move(checked.diagnostics), {}},
                          .shaders = std::move(checked.shaders),
                          .lines = std::move(lines)};
        }));
    }

  private:
    /// What drawing the scene reports in addition, and its checks that do not hold.
    Diagnostics runOf(const std::string& scene, const RenderOptions& options, Diagnostics checked) {
        Diagnostics found = hasError(checked)
                                ? render::answerWithoutPicture(scene, options, std::move(checked))
                                : render::runChecks(*context_, scene, options, std::move(checked), &shared_);
        Diagnostics misspelt = render::takeMisspellings(found);
        append(misspelt, std::move(found));
        return misspelt;
    }

    const CheckArguments& arguments_;
    int jobs_;
    bool quotesLines_ = system::isTerminal(system::Standard::error);  // a confined worker has no terminal
    std::optional<gpu::Context> context_;
    render::SharedParts shared_;  // after the context, because it must be destroyed first
};

/// Reports what the workers found, in the order of the scenes.
class CheckReport {
  public:
    /// What the scenes read is not written over by their translated shaders.
    CheckReport(const CheckArguments& arguments, ReadFiles read)
        : arguments_(arguments),
          read_(std::move(read)),
          folders_(shaderFolders(arguments.scenes, arguments.translated)),
          answers_(arguments.scenes.size()) {}

    void add(std::size_t index, Answer answer) {
        answers_[index] = std::move(answer);
        for (; next_ < answers_.size() && answers_[next_] && status_ != kNoDriver; ++next_) {
            report(next_, *answers_[next_]);
            answers_[next_].emplace();  // shaders may be large
        }
    }
    [[nodiscard]] int status() const { return status_; }
    [[nodiscard]] std::string json() const { return toJson(scenes_); }

  private:
    static int statusOf(const Diagnostics& diagnostics) {
        int status = kDone;
        for (const Diagnostic& each : diagnostics)
            if (each.severity == Severity::error)
                status = std::max(status, each.id.starts_with("check-") ? kDiffers : kSceneIsWrong);
        return status;
    }

    void report(std::size_t index, Answer& answer) {
        Diagnostics diagnostics = std::move(answer.remarks.general);
        append(diagnostics, writeShaders(answer.shaders, folders_[index], read_));
        status_ = std::max({status_, answer.status, statusOf(diagnostics)});
        if (arguments_.json && status_ != kNoDriver)
            scenes_.push_back({arguments_.scenes[index], std::move(diagnostics)});
        else
            print(diagnostics, answer.lines);
    }

    const CheckArguments& arguments_;
    ReadFiles read_;
    std::vector<std::filesystem::path> folders_;
    std::vector<std::optional<Answer>> answers_;
    std::size_t next_ = 0;  ///< the first scene that is not reported
    int status_ = kDone;
    std::vector<CheckedScene> scenes_;
};

int runCheckCommand(CheckArguments& arguments) {
    SceneArguments named;
    if (printErrors(resolveScenes(arguments.scenes, named))) return kSceneIsWrong;
    arguments.scenes = std::move(named.scenes);
    arguments.standardInput = std::move(named.standardInput);
    if (!acceptsSet(arguments.picture.options.set)) return kWrongUsage;
    std::vector<std::filesystem::path>& roots = arguments.picture.options.libraryRoots;
    for (std::filesystem::path& each : libraryRoots()) roots.push_back(std::move(each));
    const int jobs = suite::drawingJobs(arguments.jobs, arguments.driver, arguments.scenes.size());
    std::optional<system::Sandbox> sandbox;
    if (arguments.untrusted) {
        if (!prepareUntrusted()) return kNoDriver;
        sandbox = sandboxOf(arguments.scenes, arguments.picture.options, arguments.driver);
    }
    const std::uint64_t memory =
        arguments.picture.memory.value_or(base::memoryShare(jobs, arguments.scenes.size()));
    SceneChecker checker(arguments, jobs);
    const system::Interruption interruption;
    ReadFiles read;
    if (std::error_code failure; std::filesystem::is_directory(arguments.translated, failure))
        read = filesReadBy(arguments.scenes, arguments.standardInput, arguments.picture.options,
                           {.workers = suite::readingJobs(arguments.jobs),
                            .timeout = arguments.picture.timeout,
                            .memory = memory,
                            .stop = [&] { return interruption.signal() != 0; },
                            .sandbox = sandbox ? &*sandbox : nullptr});
    CheckReport report(arguments, std::move(read));
    base::runInWorkers(
        arguments.scenes.size(),
        {.workers = jobs,
         .timeout = arguments.picture.timeout,
         .memory = memory,
         .stop = [&] { return interruption.signal() != 0 || report.status() == kNoDriver; },
         .sharesDevice = gpu::mayUseHardware(arguments.driver),
         .sandbox = sandbox ? &*sandbox : nullptr},
        std::ref(checker),
        [&](std::size_t index, const base::Outcome& outcome) {
            if (outcome.end != base::Outcome::End::stopped)
                report.add(index, answerOf(outcome, arguments.scenes[index], arguments.picture,
                                           {"checked", "checked"}));
        },
        [](std::size_t, const std::string&) {});
    interruption.obey();
    if (arguments.json && report.status() != kNoDriver) std::fputs(report.json().c_str(), stdout);
    return report.status();
}

}  // namespace

void addCheck(CommandLine& program, int& status) {
    auto arguments = std::make_shared<CheckArguments>();
    CommandLine command = program.subcommand(
        "check",
        "parses scenes, finds their files, compiles and links their shaders; draws nothing without --run",
        "glibra check teapot.glib                 # messages only; exit status 3 if something is wrong\n"
        "glibra check submissions/ --strict       # all scenes of a folder; warnings are errors\n"
        "glibra check teapot.glib --run           # draws it too, and answers its Expect statements");
    command.list("SCENE", arguments->scenes, "scene files (.glib) or folders of them; - is standard input")
        .required();
    command.driver(arguments->driver).rare();
    command.jobs(arguments->jobs);
    for (const std::string_view each : suite::kCheckOptions)
        addPictureOption(command, each, arguments->picture);
    addUntrustedOption(command, arguments->untrusted);
    command
        .option("--translated", arguments->translated,
                "folder for the shaders after translation, as the driver compiles them; with several scenes "
                "each has a folder of its name there")
        .written()
        .rare();
    command
        .flag("--web", arguments->web,
              "report what WebGL 2, which browsers have, lacks for the shaders; --translated then writes "
              "them in "
              "GLSL ES 3.00")
        .excludes(command.find("--no-shim"))
        .rare();
    command.find("--untrusted").rare();
    command.flag(
        "--run", arguments->run,
        "draw the scenes, answer their Expect statements, and compare exercises with their solutions");
    for (const char* each : {"--time", "--steps", "--eye", "--samples", "--check-undefined", "--check-nan"})
        command.find(each).needs(command.find("--run"));
    command.flag("--json", arguments->json, "print the diagnostics as JSON on standard output");
    command.onRun([arguments, &status] { status = runCheckCommand(*arguments); });
}

}  // namespace glibra::cli
