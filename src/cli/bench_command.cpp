#include "cli/bench_command.h"

#include <CLI/CLI.hpp>

#include "cli/commands.h"

namespace glibra::cli {

void addBench(CLI::App& app, int& status) {
    CLI::App* command =
        app.add_subcommand("bench", "measures run time against error, as curves with their Pareto fronts");
    // glibra-bench reads its own arguments, --help among them.
    command->prefix_command();
    command->set_help_flag();
    command->callback([command, &status] { status = becomeProgram(kBenchProgram, command->remaining()); });
}

}  // namespace glibra::cli
