#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/sister_program.h"

namespace glibra::cli {
namespace {

constexpr SisterProgram kWindow{"glibra-view", "`glibra render SCENE` makes a picture without it"};

}  // namespace

void addView(CommandLine& program, int& status) {
    program.subcommand(
        "view", "shows a scene in a window, with a slider for every range",
        [&status](const std::vector<std::string>& arguments) { status = becomeProgram(kWindow, arguments); });
}

}  // namespace glibra::cli
