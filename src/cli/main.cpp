
#include <csignal>
#include <exception>

#include "base/standard_files.h"
#include "cli/command_line.h"
#include "cli/commands.h"

namespace {

int run(int argc, char** argv) {
    glibra::cli::Program program("glibra runs GLIB shader scenes", "glibra render glib/start/teapot.glib");
    program.version("glibra " GLIBRA_VERSION);
    program.requireSubcommand();
    glibra::cli::CommandLine line = program.line();
    int status = glibra::cli::kDone;
    glibra::cli::addRender(line, status);
    glibra::cli::addTest(line, status);
    glibra::cli::addView(line, status);
    glibra::cli::addCheck(line, status);
    glibra::cli::addCompare(line, status);
    glibra::cli::addNoise(line, status);
    glibra::cli::addBench(line, status);
    glibra::cli::addInfo(line, status);
    glibra::cli::addLanguage(line, status);
    return program.parse(argc, argv).value_or(status);
}

}  // namespace

int main(int argc, char** argv) {
    if (!glibra::base::openStandardFiles()) return glibra::cli::kNoDriver;
    // A write beyond the limit of the shell (ulimit -f) fails with a message instead.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return run(argc, argv);
    } catch (const std::exception& failure) {
        glibra::cli::printError(failure.what());
        return glibra::cli::kSceneIsWrong;
    }
}
