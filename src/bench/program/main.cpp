// glibra-bench: started by `glibra bench` and `glibra info --precision`.

#include <CLI/CLI.hpp>
#include <exception>

#include "base/standard_files.h"
#include "bench/program/commands.h"
#include "cli/command_line.h"
#include "cli/commands.h"

namespace glibra::bench {
namespace {

void addMeasure(CLI::App& app, MeasureArguments& to) {
    app.add_option("SUBJECT", to.subjects, "what to measure; all subjects if none is named");
    app.add_flag("--list", to.list, "print the names of the subjects");
    app.add_flag("--quick", to.options.quick, "fewer settings and measurements: seconds, for CI");
    app.add_option("-o,--output", to.folder, "folder for bench.csv, bench.json and bench.html");
    app.add_option("--csv", to.csv, "write one row per point");
    app.add_option("--json", to.json, "write the whole run, for a later --against");
    app.add_option("--html", to.html, "write one page with all diagrams and tables");
    app.add_option("--against", to.against,
                   "bench.json of an earlier run: print what changed; exit status 1 if an error grew");
    app.add_option("--tolerance", to.comparison.errorTolerance,
                   "with --against: the share by which an error may grow")
        ->check(CLI::Range(0., 1e6))
        ->capture_default_str();
    app.add_option(
           "--time-factor", to.comparison.timeFactor,
           "with --against: exit status 1 also if a median time grew by more than this factor and the "
           "spreads do not overlap")
        ->check(CLI::Range(1., 1e6));
    cli::addDriverOption(app, to.options.driver);
}

int run(int argc, char** argv) {
    CLI::App app{"run time against error: curves and their Pareto fronts", "glibra bench"};
    MeasureArguments arguments;
    addMeasure(app, arguments);
    CLI::App* precision = app.add_subcommand(
        "precision", "the error of GLSL's functions on this driver, as `glibra info --precision` prints it");
    Driver driver = Driver::automatic;
    bool asJson = false;
    cli::addDriverOption(*precision, driver);
    precision->add_flag("--json", asJson, "as JSON");
    try {
        app.parse(argc, argv);
        return precision->parsed() ? printPrecision(driver, asJson) : measure(arguments);
    } catch (const CLI::ParseError& wrong) {
        return cli::reportUsage(app, wrong);
    }
}

}  // namespace
}  // namespace glibra::bench

int main(int argc, char** argv) {
    if (!glibra::base::openStandardFiles()) return glibra::cli::kNoDriver;
    try {
        return glibra::bench::run(argc, argv);
    } catch (const std::exception& failure) {
        glibra::cli::printError(failure.what());
        return glibra::cli::kSceneIsWrong;
    }
}
