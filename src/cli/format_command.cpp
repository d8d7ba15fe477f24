// `glibra format`: formats scenes in place.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/scene_arguments.h"
#include "editor/format.h"
#include "glib/limits.h"
#include "image/file.h"

namespace glibra::cli {
namespace {

struct FormatArguments {
    std::vector<std::string> scenes;
    bool isCheck = false;
    bool readsInput = false;
};

/// Formats a scene, or with `isCheck` only says that it is not formatted.
int formatScene(const std::string& scene, bool isCheck) {
    const auto bytes = image::readFile(scene, {scene, {scene, 1, 1}}, glib::kLargestFile);
    std::error_code failure;
    if (!bytes && std::filesystem::is_regular_file(scene, failure) &&
        std::filesystem::is_empty(scene, failure))
        return kDone;  // an empty scene
    if (!bytes) {
        const Diagnostic& why = bytes.diagnostics.front();
        print({diagnose(why.id == "file-E09" ? "glib-E15" : "glib-E14", "cannot read the scene: " + why.text,
                        why.place)});
        return kSceneIsWrong;
    }
    const std::string_view old(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    const std::string text = editor::formatted(old);
    if (text == old) return kDone;
    if (isCheck) {
        printLine(fmt::format("{} is not formatted", scene));
        return kDiffers;
    }
    return printErrors(image::writeFileAtomically(scene, std::as_bytes(std::span(text)))) ? kSceneIsWrong
                                                                                          : kDone;
}

int runFormatCommand(FormatArguments& arguments) {
    if (arguments.readsInput) arguments.scenes.emplace_back("-");
    if (arguments.scenes.empty()) return refuse("no scene is named, and no --stdin");
    SceneArguments named;
    if (printErrors(resolveScenes(arguments.scenes, named))) return kSceneIsWrong;
    int status = kDone;
    for (const std::string& each : named.scenes) {
        if (each != kStandardInput) {
            status = std::max(status, formatScene(each, arguments.isCheck));
            continue;
        }
        const std::string text = editor::formatted(*named.standardInput);
        if (!arguments.isCheck) {
            std::fwrite(text.data(), 1, text.size(), stdout);
        } else if (text != *named.standardInput) {
            printLine(fmt::format("{} is not formatted", kStandardInput));
            status = std::max(status, kDiffers);
        }
    }
    return status;
}

}  // namespace

void addFormat(CommandLine& program, int& status) {
    auto arguments = std::make_shared<FormatArguments>();
    CommandLine command = program.subcommand(
        "format", "formats the texts of scenes in place, which changes no picture",
        "glibra format teapot.glib                 # indents blocks, aligns backslashes, ends lines\n"
        "glibra format --check scenes/             # exit status 1 if a scene is not formatted\n"
        "glibra format --stdin < a.glib > b.glib   # for editors");
    command.list("SCENE", arguments->scenes, "scene files (.glib) or folders of them; - is standard input");
    command.flag("--check", arguments->isCheck, "write nothing; name the scenes that are not formatted");
    command.flag("--stdin", arguments->readsInput, "format standard input to standard output");
    command.onRun([arguments, &status] { status = runFormatCommand(*arguments); });
}

}  // namespace glibra::cli
