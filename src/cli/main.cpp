#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "base/suggest.h"
#include "base/text.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/sister_program.h"
#include "system/memory.h"
#include "system/terminal.h"

namespace glibra::cli {
namespace {

/// What `glibra` without arguments prints.
constexpr const char* kOverview =
    "glibra runs GLIB shader scenes. What it can do, by example:\n"
    "  glibra teapot.glib                           open a scene in a window, with its sliders\n"
    "  glibra render teapot.glib -o teapot.png      draw a picture, without a display\n"
    "  glibra render scenes/ -o pictures/           draw all scenes of a folder\n"
    "  glibra check teapot.glib                     report what is wrong with a scene and its shaders\n"
    "  glibra test submissions/ --report out/       compare pictures with accepted ones\n"
    "  glibra compare a.png b.png                   compare two pictures\n"
    "  glibra language Sphere                       look up a command of the scene language\n"
    "  glibra info                                  show the graphics driver\n"
    "`glibra --help` lists all commands, `glibra COMMAND --help` the options of one.\n";

/// Answers a first word that is no command: a scene is opened in the window, anything else is reported.
int openOrRefuse(const std::vector<std::string>& words, const std::vector<std::string>& commands) {
    const std::string& word = words.front();
    if (isSceneOrFolder(word)) {
        const std::string missing = whyNoScene(word);
        if (missing.empty()) return openWindow(words);
        printError(missing);
        return kSceneIsWrong;
    }
    const std::vector<std::string_view> names(commands.begin(), commands.end());
    printError(fmt::format("there is no command and no scene '{}'{}", word, base::suggestion(word, names)));
    printLine("`glibra` without arguments shows what it can do");
    return kWrongUsage;
}

int run(int argc, char** argv) {
    if (argc == 1) {
        std::fputs(kOverview, stdout);
        return kDone;
    }
    Program program("glibra runs GLIB shader scenes",
                    "glibra teapot.glib                    # opens a scene in a window\n"
                    "glibra render teapot.glib             # writes teapot.png\n"
                    "glibra check scenes/                  # reports what is wrong with scenes");
    program.version("glibra " GLIBRA_VERSION);
    program.requireSubcommand();
    CommandLine line = program.line();
    int status = kDone;
    for (auto* add : {addRender, addTest, addReview, addClass, addGallery, addPublish, addView, addCheck,
                      addFormat, addCompare, addNoise, addBench, addInfo, addLanguage, addLanguageServer})
        add(line, status);
    addManual(line, program, status);
    addCompletion(line, program, status);
    line.subcommand("help", "prints the options of a subcommand", [](const std::vector<std::string>&) {});
    const std::vector<std::string> commands = program.subcommands();
    std::vector<char*> words(argv, argv + argc);
    char asked[] = "--help";
    if (words[1] == std::string_view("help")) {  // `glibra help render` is `glibra render --help`
        words.erase(words.begin() + 1);
        words.push_back(asked);
    }
    const std::string first = words[1];
    if (!first.starts_with('-') && std::find(commands.begin(), commands.end(), first) == commands.end())
        return openOrRefuse({words.begin() + 1, words.end()}, commands);
    return program.parse(static_cast<int>(words.size()), words.data()).value_or(status);
}

}  // namespace
}  // namespace glibra::cli

int main(int argc, char** argv) {
    if (!glibra::system::openStandardFiles()) return glibra::cli::kNoDriver;
    // A write beyond the limit of the shell (ulimit -f) fails with a message instead.
    glibra::system::failBeyondLargestFile();
    try {
        return glibra::cli::endProgram(glibra::cli::run(argc, argv));
    } catch (const std::exception& failure) {
        return glibra::cli::failProgram(glibra::base::reasonOf(failure));
    }
}
