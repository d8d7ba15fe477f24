#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/info_output.h"
#include "cli/sister_program.h"
#include "gpu/context/context.h"

namespace glibra::cli {
namespace {

/// Runs `glibra bench` and `glibra info --precision`.
constexpr SisterProgram kBenchProgram{
    "glibra-bench",
    "build it with `cmake --build BUILD_FOLDER --target glibra_bench_program` (this needs Boost)"};

}  // namespace

void addBench(CommandLine& program, int& status) {
    program.subcommand("bench", "measures run time against error, as curves with their Pareto fronts",
                       [&status](const std::vector<std::string>& arguments) {
                           status = becomeProgram(kBenchProgram, arguments);
                       });
}

namespace {

struct InfoArguments {
    Driver driver = Driver::automatic;
    bool json = false;
    bool precision = false;
};

/// Starts glibra-bench, which prints what `runInfoCommand` prints, with the measured precision.
int measurePrecision(const InfoArguments& arguments) {
    std::vector<std::string> words{"precision"};
    if (arguments.json) words.emplace_back("--json");
    words.insert(words.end(), {"--driver", std::string(word(arguments.driver))});
    return becomeProgram(kBenchProgram, words);
}

int runInfoCommand(const InfoArguments& arguments) {
    if (arguments.precision) return measurePrecision(arguments);
    const Result<gpu::Context> context = gpu::openContext({.driver = arguments.driver});
    if (!context) {
        print(context.diagnostics);
        return kNoDriver;
    }
    std::fputs((arguments.json ? infoJsonText(*context) : infoText(*context)).c_str(), stdout);
    return kDone;
}

}  // namespace

void addInfo(CommandLine& program, int& status) {
    auto arguments = std::make_shared<InfoArguments>();
    CommandLine command =
        program.subcommand("info", "prints the driver, its limits and its capabilities",
                           "glibra info                 # driver, limits, capabilities\n"
                           "glibra info --json\n"
                           "glibra info --precision     # the errors of the GLSL functions");
    command.driver(arguments->driver);
    command.flag(
        "--precision", arguments->precision,
        "measure the errors of the GLSL functions and compare them with the limits of the specification");
    command.flag("--json", arguments->json, "print as JSON");
    command.onRun([arguments, &status] { status = runInfoCommand(*arguments); });
}

}  // namespace glibra::cli
