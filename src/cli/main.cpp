#include <CLI/CLI.hpp>

#include <csignal>
#include <exception>

#include "base/standard_files.h"
#include "cli/command_line.h"
#include "cli/commands.h"

namespace {

int run(int argc, char** argv) {
    CLI::App app{"glibra runs GLIB shader scenes"};
    glibra::cli::setExample(app, "glibra render glib/start/teapot.glib");
    app.set_version_flag("--version", "glibra " GLIBRA_VERSION);
    app.require_subcommand(1);
    int status = glibra::cli::kDone;
    try {
        glibra::cli::addRender(app, status);
        glibra::cli::addTest(app, status);
        glibra::cli::addView(app, status);
        glibra::cli::addCheck(app, status);
        glibra::cli::addCompare(app, status);
        glibra::cli::addNoise(app, status);
        glibra::cli::addBench(app, status);
        glibra::cli::addInfo(app, status);
        glibra::cli::addLanguage(app, status);
        app.parse(argc, argv);
        return status;
    } catch (const CLI::ParseError& wrong) {
        return glibra::cli::reportUsage(app, wrong);
    }
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
