#include <CLI/CLI.hpp>

#include "cli/commands.h"
#include "cli/sister_program.h"

namespace glibra::cli {
namespace {

constexpr SisterProgram kWindow{"glibra-view", "`glibra render SCENE` makes a picture without it"};

}  // namespace

void addView(CLI::App& app, int& status) {
    CLI::App* command =
        app.add_subcommand("view", "shows a scene in a window, with a slider for every range");
    // The window program reads its own arguments, --help among them.
    command->prefix_command();
    command->set_help_flag();
    command->callback([command, &status] { status = becomeProgram(kWindow, command->remaining()); });
}

}  // namespace glibra::cli
