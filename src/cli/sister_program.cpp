#include "cli/sister_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/scene_arguments.h"
#include "glib/text.h"
#include "scene/file_lookup.h"
#include "system/library.h"
#include "system/places.h"
#include "system/process.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

/// Empty if the program is missing. GLIBRA_PROGRAMS_DIR may be one folder deeper than lib, as in
/// lib/x86_64-linux-gnu.
fs::path find(const char* program) {
    std::error_code failure;
    const std::string name = system::programName(program);
    const fs::path folder = system::programFile().parent_path();
    for (const fs::path& each :
         {folder / name, folder / "../lib/glibra" / name, folder / ".." / GLIBRA_PROGRAMS_DIR / name})
        if (fs::is_regular_file(each, failure) && system::isProgram(each)) return each;
    return {};
}

constexpr SisterProgram kWindow{"glibra-view", "`glibra render SCENE` makes a picture without it"};
constexpr std::size_t kMostTabs = 64;

bool isNamedAsScene(const std::string& word) {
    return glib::sameWord(fs::path(word).extension().generic_string(), ".glib");
}

}  // namespace

int becomeProgram(const SisterProgram& program, const std::vector<std::string>& arguments) {
    const fs::path file = find(program.name);
    if (file.empty()) {
        printError(fmt::format("the program {} is missing; {}", program.name, program.missing));
        return kNoDriver;
    }
    const int problem = system::becomeProgram(file, arguments);
    printError(fmt::format("cannot start {}: {}", file.generic_string(), std::strerror(problem)));
    return kNoDriver;
}

bool isSceneOrFolder(const std::string& word) {
    std::error_code failure;
    return isNamedAsScene(word) || fs::is_directory(word, failure);
}

int openWindow(const std::vector<std::string>& arguments) {
    std::vector<std::string> words;
    std::string firstScene;
    for (const std::string& each : arguments) {
        std::error_code failure;
        if (!each.starts_with('-') && isSceneOrFolder(each) && firstScene.empty()) firstScene = each;
        if (!fs::is_directory(each, failure)) {
            words.push_back(each);
            continue;
        }
        SceneArguments inside;
        if (printErrors(resolveScenes({each}, inside))) return kSceneIsWrong;
        if (inside.scenes.size() > kMostTabs) {
            printLine(fmt::format("{} has {} scenes; the first {} are opened", each, inside.scenes.size(),
                                  kMostTabs));
            inside.scenes.resize(kMostTabs);
        }
        words.insert(words.end(), inside.scenes.begin(), inside.scenes.end());
    }
    const bool asksForHelp = std::any_of(arguments.begin(), arguments.end(), [](const std::string& each) {
        return each == "-h" || each == "--help" || each == "--help-all";
    });
    std::string library;
    const system::Desktop desktop = asksForHelp ? system::Desktop::ready : system::desktop(library);
    if (desktop == system::Desktop::noDisplay) {
        printError(fmt::format(
            "there is no display to open a window on; `glibra render {}` draws a picture without one",
            firstScene.empty() ? "SCENE" : firstScene));
        return kNoDriver;
    }
    if (desktop == system::Desktop::noLibrary) {
        printError(fmt::format("the window needs the library {}, which this system does not have; {}",
                               library, kWindow.missing));
        return kNoDriver;
    }
    return becomeProgram(kWindow, words);
}

std::string whyNoScene(const std::string& scene) {
    std::error_code failure;
    if (fs::exists(scene, failure)) return {};
    scene::FolderListings listings;
    const fs::path folder = fs::path(scene).has_parent_path() ? fs::path(scene).parent_path() : ".";
    const auto near =
        scene::nearestFiles(fs::path(scene).filename().generic_string(), std::span(&folder, 1), listings);
    return fmt::format("there is no file '{}'{}", scene,
                       near.empty() ? "" : fmt::format("; did you mean '{}'?", near.front()));
}

void addView(CommandLine& program, int& status) {
    program.subcommand(
        "view", "shows a scene in a window, with a slider for every range",
        [&status](const std::vector<std::string>& arguments) { status = openWindow(arguments); });
}

}  // namespace glibra::cli
