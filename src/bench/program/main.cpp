// glibra-bench: started by `glibra bench` and `glibra info --precision`.

#include <cstdio>
#include <exception>
#include <optional>

#include "base/device_lost.h"
#include "base/files.h"
#include "bench/program/commands.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/picture_options.h"

namespace glibra::bench {
namespace {

void addMeasure(cli::CommandLine& line, MeasureArguments& to) {
    line.list("SUBJECT", to.subjects, "what to measure; all subjects if none is named");
    line.option("--scene", to.scene, "measure a scene instead: with each value of --sweep");
    line.option("--sweep", to.sweep,
                "with --scene: a variable or uniform and its values, the finest last, as steps=[8,16,32,64]");
    for (const char* each : {"size", "time", "steps", "set", "samples"})
        cli::addPictureOption(line, each, to.picture);
    line.flag("--list", to.list, "print the names of the subjects");
    line.flag("--quick", to.options.quick, "fewer settings and measurements: seconds, for CI");
    line.option("-o,--output", to.folder, "folder for bench.csv, bench.json and bench.html").written();
    line.option("--csv", to.csv, "write one row per point").written();
    line.option("--json", to.json, "write the whole run, for a later --against").written();
    line.option("--html", to.html, "write one page with all diagrams and tables").written();
    line.option("--against", to.against,
                "bench.json of an earlier run: print what changed; exit status 1 if an error grew");
    line.option("--tolerance", to.comparison.errorTolerance,
                "with --against: the share by which an error may grow")
        .within(0., 1e6)
        .withDefault();
    line.option("--time-factor", to.comparison.timeFactor,
                "with --against: exit status 1 also if a median time grew by more than this factor and the "
                "spreads do not overlap")
        .within(1., 1e6);
    line.driver(to.options.driver);
}

int runProgram(int argc, char** argv) {
    cli::Program program(
        "run time against error: curves and their Pareto fronts",
        "glibra bench --list\n"
        "glibra bench --scene fog.glib --sweep 'steps=[8,16,32,256]'\n"
        "glibra bench --against out/bench.json           # what changed since an earlier run",
        "glibra bench");
    cli::CommandLine line = program.line();
    MeasureArguments arguments;
    addMeasure(line, arguments);
    cli::CommandLine precision = line.subcommand(
        "precision", "the error of GLSL's functions on this driver, as `glibra info --precision` prints it",
        "glibra bench precision\n"
        "glibra bench precision --json\n"
        "glibra bench precision --driver osmesa");
    Driver driver = Driver::automatic;
    bool asJson = false;
    precision.driver(driver);
    precision.flag("--json", asJson, "as JSON");
    if (const std::optional<int> status = program.parse(argc, argv)) return *status;
    return precision.isGiven() ? printPrecision(driver, asJson) : measure(arguments);
}

}  // namespace
}  // namespace glibra::bench

int main(int argc, char** argv) {
    if (!glibra::base::openStandardFiles()) return glibra::cli::kNoDriver;
    try {
        return glibra::cli::endProgram(glibra::bench::runProgram(argc, argv));
    } catch (const glibra::base::DeviceLost& lost) {
        // Nothing is reported: nobody knows for how long the device was held before.
        glibra::cli::print({glibra::base::diagnosticOf(lost, {})});
        return glibra::cli::kSceneIsWrong;
    } catch (const std::exception& failure) {
        return glibra::cli::failProgram(failure.what());
    }
}
