#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "gpu/context.h"
#include "gpu/info.h"

namespace glibra::cli {
namespace {

struct InfoArguments {
    Driver driver = Driver::automatic;
    bool json = false;
};

int run(const InfoArguments& arguments) {
    const Result<gpu::Context> context = gpu::openContext({.driver = arguments.driver});
    if (!context) {
        print(context.diagnostics);
        return kNoDriver;
    }
    if (arguments.json) {
        nlohmann::ordered_json json;
        json["glibra"] = GLIBRA_VERSION;
        for (const gpu::InfoEntry& each : gpu::describe(*context))
            std::visit([&](const auto& value) { json[each.key] = value; }, each.value);
        std::printf("%s\n", json.dump(2).c_str());
        return kDone;
    }
    std::printf("glibra %s\n%s", GLIBRA_VERSION, gpu::toText(gpu::describe(*context)).c_str());
    return kDone;
}

}  // namespace

void addInfo(CLI::App& app, int& status) {
    auto arguments = std::make_shared<InfoArguments>();
    CLI::App* command = app.add_subcommand("info", "the driver, its limits and capabilities");
    command->add_option("--driver", arguments->driver, "which OpenGL: auto, egl, egl-device, osmesa")
        ->transform(CLI::CheckedTransformer(kDriverWords));
    command->add_flag("--json", arguments->json, "as JSON");
    command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace glibra::cli
