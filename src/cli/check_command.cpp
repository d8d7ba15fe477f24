#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/json_output.h"
#include "cli/picture_options.h"
#include "gpu/context/context.h"
#include "image/file.h"
#include "render/scene_renderer.h"

namespace glibra::cli {
namespace {

struct CheckArguments {
    std::vector<std::string> scenes;
    suite::Shot picture;
    Driver driver = Driver::automatic;
    bool json = false;
    std::string translated;
};

/// Writes each shader to the folder, which is made if it does not exist.
Diagnostics writeShaders(const std::vector<render::TranslatedShader>& shaders,
                         const std::filesystem::path& folder) {
    Diagnostics problems;
    std::error_code ignored;  // reported with the first file that cannot be written
    std::filesystem::create_directories(folder, ignored);
    for (const render::TranslatedShader& each : shaders)
        append(problems,
               image::writeFileAtomically(folder / each.name, std::as_bytes(std::span(each.source))));
    return problems;
}

int run(CheckArguments& arguments) {
    Result<gpu::Context> context = gpu::openContext({.driver = arguments.driver});
    if (!context) {
        print(context.diagnostics);
        return kNoDriver;
    }
    arguments.picture.options.libraryRoots = libraryRoots();
    int status = kDone;
    std::vector<CheckedScene> report;
    for (const std::string& scene : arguments.scenes) {
        const render::CheckResult checked = render::checkScene(*context, scene, arguments.picture.options);
        Diagnostics diagnostics = checked.diagnostics;
        if (!arguments.translated.empty())
            append(diagnostics, writeShaders(checked.shaders, arguments.translated));
        if (hasError(diagnostics)) status = kSceneIsWrong;
        if (arguments.json)
            report.push_back({scene, std::move(diagnostics)});
        else
            print(diagnostics);
    }
    if (arguments.json) std::fputs(toJson(report).c_str(), stdout);
    return status;
}

}  // namespace

void addCheck(CommandLine& program, int& status) {
    auto arguments = std::make_shared<CheckArguments>();
    CommandLine command = program.subcommand(
        "check", "parses scenes, finds their files, compiles and links their shaders; draws nothing",
        "glibra check a.glib");
    command.list("SCENE", arguments->scenes, "scene files (.glib)").required();
    command.driver(arguments->driver);
    addPictureOption(command, "strict", arguments->picture);
    addPictureOption(command, "no-shim", arguments->picture);
    command.option("--translated", arguments->translated,
                   "folder for the shaders after translation, as the driver compiles them");
    command.flag("--json", arguments->json, "print the diagnostics as JSON on standard output");
    command.onRun([arguments, &status] { status = run(*arguments); });
}

}  // namespace glibra::cli
