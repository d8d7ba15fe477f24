#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdio>
#include <exception>

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
        return app.exit(wrong) == 0 ? glibra::cli::kDone : glibra::cli::kWrongUsage;
    }
}

}  // namespace

int main(int argc, char** argv) {
    // A write beyond the limit of the shell (ulimit -f) fails with a message instead.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return run(argc, argv);
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "glibra: error: %s\n", failure.what());
        return glibra::cli::kSceneIsWrong;
    }
}
