#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/bench_command.h"
#include "cli/commands.h"
#include "cli/info_output.h"
#include "gpu/context.h"

namespace glibra::cli {
namespace {

struct InfoArguments {
    Driver driver = Driver::automatic;
    bool json = false;
    bool precision = false;
};

/// Starts glibra-bench, which prints what `run` prints, with the measured precision.
int measurePrecision(const InfoArguments& arguments) {
    std::vector<std::string> words{"precision"};
    if (arguments.json) words.emplace_back("--json");
    words.insert(words.end(), {"--driver", std::string(word(arguments.driver))});
    return becomeProgram(kBenchProgram, words);
}

int run(const InfoArguments& arguments) {
    if (arguments.precision) return measurePrecision(arguments);
    const Result<gpu::Context> context = gpu::openContext({.driver = arguments.driver});
    if (!context) {
        print(context.diagnostics);
        return kNoDriver;
    }
    if (arguments.json)
        std::printf("%s\n", infoJson(*context).dump(2).c_str());
    else
        std::printf("%s", infoText(*context).c_str());
    return kDone;
}

}  // namespace

void addInfo(CLI::App& app, int& status) {
    auto arguments = std::make_shared<InfoArguments>();
    CLI::App* command = app.add_subcommand("info", "the driver, its limits and capabilities");
    command->add_option("--driver", arguments->driver, "which OpenGL: auto, egl, egl-device, osmesa")
        ->transform(CLI::CheckedTransformer(kDriversByWord));
    command->add_flag("--precision", arguments->precision,
                      "measure the error of GLSL's functions against what the specification allows");
    command->add_flag("--json", arguments->json, "as JSON");
    command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace glibra::cli
