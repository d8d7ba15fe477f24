#include "cli/bench_command.h"

#include "cli/command_line.h"
#include "cli/commands.h"

namespace glibra::cli {

void addBench(CommandLine& program, int& status) {
    program.subcommand("bench", "measures run time against error, as curves with their Pareto fronts",
                       [&status](const std::vector<std::string>& arguments) {
                           status = becomeProgram(kBenchProgram, arguments);
                       });
}

}  // namespace glibra::cli
