#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWindowProgram = "glibra-view";

/// Beside this program, as in the build folder, or where it is installed. Libraries may lie one folder deeper
/// than lib, as in lib/x86_64-linux-gnu.
fs::path windowProgram() {
    std::error_code failure;
    const fs::path folder = fs::read_symlink("/proc/self/exe", failure).parent_path();
    std::vector<fs::path> places{folder / kWindowProgram, folder / "../lib/glibra" / kWindowProgram};
#ifdef GLIBRA_VIEW_INSTALL_DIR
    places.emplace_back(folder / ".." / GLIBRA_VIEW_INSTALL_DIR / kWindowProgram);
#endif
    for (const fs::path& each : places)
        if (fs::is_regular_file(each, failure) && ::access(each.c_str(), X_OK) == 0) return each;
    return {};
}

/// Becomes the window program; comes back only if that fails.
int becomeWindow(const std::vector<std::string>& arguments) {
    const fs::path program = windowProgram();
    if (program.empty()) {
        std::fprintf(stderr,
                     "glibra: error: the window program %s is not installed; `glibra render SCENE` makes a "
                     "picture without it\n",
                     kWindowProgram);
        return kNoDriver;
    }
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& each : words) pointers.push_back(each.data());
    pointers.push_back(nullptr);
    ::execv(program.c_str(), pointers.data());
    std::fprintf(stderr, "glibra: error: cannot start %s: %s\n", program.c_str(), std::strerror(errno));
    return kNoDriver;
}

}  // namespace

void addView(CLI::App& app, int& status) {
    CLI::App* command = app.add_subcommand("view", "a scene in a window, with a slider for every range");
    // The window program reads its own arguments, --help among them.
    command->prefix_command();
    command->set_help_flag();
    command->callback([command, &status] { status = becomeWindow(command->remaining()); });
}

}  // namespace glibra::cli
