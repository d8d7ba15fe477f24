#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>

#include "cli/commands.h"
#include "gpu/context.h"
#include "image/file.h"
#include "render/scene_renderer.h"

namespace glibra::cli {
namespace {

struct CheckArguments {
    std::vector<std::string> scenes;
    RenderOptions options;
    Driver driver = Driver::automatic;
    bool json = false;
    bool noShim = false;
    std::string translated;
};

nlohmann::ordered_json toJson(const Diagnostics& diagnostics) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Diagnostic& each : diagnostics)
        list.push_back({{"file", each.place.file},
                        {"line", each.place.line},
                        {"column", each.place.column},
                        {"severity", name(each.severity)},
                        {"id", each.id},
                        {"text", each.text}});
    return list;
}

/// Writes each shader to the folder, which is made if need be.
Diagnostics writeShaders(const std::vector<render::TranslatedShader>& shaders,
                         const std::filesystem::path& folder) {
    Diagnostics problems;
    std::error_code ignored;  // told with the first file that cannot be written
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
    arguments.options.shim = !arguments.noShim;
    arguments.options.libraryRoots = libraryRoots();
    int status = kDone;
    nlohmann::ordered_json report = nlohmann::ordered_json::array();
    for (const std::string& scene : arguments.scenes) {
        const render::CheckResult checked = render::checkScene(*context, scene, arguments.options);
        Diagnostics diagnostics = checked.diagnostics;
        if (!arguments.translated.empty())
            append(diagnostics, writeShaders(checked.shaders, arguments.translated));
        if (hasError(diagnostics)) status = kSceneIsWrong;
        if (arguments.json)
            report.push_back(
                {{"scene", scene}, {"good", !hasError(diagnostics)}, {"diagnostics", toJson(diagnostics)}});
        else
            print(diagnostics);
    }
    if (arguments.json)
        std::printf("%s\n", report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    return status;
}

}  // namespace

void addCheck(CLI::App& app, int& status) {
    auto arguments = std::make_shared<CheckArguments>();
    CLI::App* command = app.add_subcommand("check", "parse, resolve files, compile and link; draw nothing");
    command->add_option("SCENE", arguments->scenes, "scene files (.glib)")->required();
    command->add_option("--driver", arguments->driver, "which OpenGL: auto, egl, egl-device, osmesa")
        ->transform(CLI::CheckedTransformer(kDriversByWord));
    command->add_flag("--strict", arguments->options.strict, "warnings are errors");
    command->add_flag("--no-shim", arguments->noShim, "compile the shaders as they are");
    command->add_option("--translated", arguments->translated,
                        "folder for the shaders as the driver gets them");
    command->add_flag("--json", arguments->json, "the diagnostics as JSON on standard output");
    command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace glibra::cli
