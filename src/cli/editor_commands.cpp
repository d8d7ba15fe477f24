// What editors run: `glibra format` and `glibra language-server`.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/scene_arguments.h"
#include "editor/format.h"
#include "editor/language_server.h"
#include "glib/limits.h"
#include "image/file.h"
#include "system/process.h"
#include "system/terminal.h"

namespace glibra::cli {

// `glibra format`: formats scenes in place.

namespace {

struct FormatArguments {
    std::vector<std::string> scenes;
    bool isCheck = false;
    bool readsInput = false;
};

/// Formats a scene, or with `isCheck` only says that it is not formatted. One that was found in a folder may
/// be a link, or another name, of any file of the user.
int formatScene(const std::string& scene, bool isCheck, bool isFound) {
    std::error_code failure;
    if (isFound && std::filesystem::is_symlink(scene, failure)) {
        printLine(fmt::format("{} is a link, which is left as it is", scene));
        return kDone;
    }
    const auto bytes = image::readFile(scene, {scene, {scene, 1, 1}}, glib::kLargestFile);
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
    const image::NamedBy named = isFound ? image::NamedBy::program : image::NamedBy::user;
    return printErrors(image::writeFileAtomically(scene, std::as_bytes(std::span(text)), named))
               ? kSceneIsWrong
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
            const bool isFound = std::ranges::find(arguments.scenes, each) == arguments.scenes.end();
            status = std::max(status, formatScene(each, arguments.isCheck, isFound));
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

// `glibra language-server`: the language server between standard input and standard output.

constexpr int kPause = 150;  // milliseconds without a key before scenes are checked

/// Takes what has arrived within the time; -1 waits for ever. False at the end of the input.
bool takeInput(editor::MessageReader& reader, int milliseconds) {
    if (!system::isInputReady(milliseconds).value_or(false)) return true;
    std::array<char, 65536> block;
    std::size_t count = 0;
    if (system::readInput(block, count) != 0) return false;
    reader.add({block.data(), count});
    return count > 0;
}

/// True if more input is there, or comes within the time.
bool isTyping(int milliseconds) {
    return system::isInputReady(milliseconds).value_or(false);
}

int serve() {
    editor::ServerOptions options;
    options.version = GLIBRA_VERSION;
    options.libraryRoots = libraryRoots();
    editor::LanguageServer server(std::move(options));
    editor::MessageReader reader;
    // The exit status if no more can be written.
    const auto deliver = [&]() -> std::optional<int> {
        std::string bytes;
        for (const std::string& each : server.takeOutput()) bytes += editor::framed(each);
        const std::error_code failure(system::writeOutput(bytes), std::generic_category());
        if (!failure) return std::nullopt;
        if (failure == std::errc::broken_pipe) return kDiffers;  // the client reads no more
        printError("cannot write to standard output: " + failure.message());
        return kSceneIsWrong;
    };
    std::future<editor::ContainedCheck> checked;  // of the scene that is checked now
    std::optional<long long> client;  // a number of another machine or container names nobody here
    for (bool isOpen = true; isOpen && !server.exitStatus();) {
        constexpr int kLook = 2000;  // milliseconds after which the client is looked for
        constexpr int kCheck = 20;   // while a scene is checked; keys are answered meanwhile
        const bool isIdle = !checked.valid() && !server.hasWork();
        isOpen = takeInput(reader, !isIdle ? kCheck : client ? kLook : -1);
        if (client && !system::isRunning(*client)) return kDiffers;
        while (const std::optional<std::string> message = reader.next())
            if (!server.receive(*message)) reader.refuse(*message);
        server.answer();
        if (!client && server.clientProcess() && system::isRunning(*server.clientProcess()))
            client = server.clientProcess();
        if (const auto status = deliver()) return *status;
        if (reader.isLost()) {
            printError(
                fmt::format("the client states a message of more than {} bytes, which is "
                            "too long; the language server ends",
                            editor::MessageReader::kLargestMessage));
            return kDiffers;
        }
        if (checked.valid() && checked.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
            server.endWork(checked.get());
            if (const auto status = deliver()) return *status;
        }
        if (!checked.valid() && server.hasWork() && isOpen && !server.exitStatus() && !isTyping(kPause)) {
            if (editor::LanguageServer::Work work = server.beginWork()) {
                // At the end of the server nobody waits for the thread.
                std::packaged_task<editor::ContainedCheck()> task(std::move(work));
                checked = task.get_future();
                std::thread(std::move(task)).detach();
            }
            if (const auto status = deliver()) return *status;
        }
    }
    // A client that is gone without `exit` has not ended the session.
    return server.exitStatus().value_or(kDiffers);
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

void addLanguageServer(CommandLine& program, int& status) {
    CommandLine command = program.subcommand(
        "language-server", "serves editors by the Language Server Protocol, on standard input and output",
        "glibra language-server                 # started by an editor: see docs/editors.md");
    const auto isStandard = std::make_shared<bool>(false);
    command.flag("--stdio", *isStandard, "what some editors add; it is the only way of talking");
    command.onRun([isStandard, &status] { status = serve(); });
}

}  // namespace glibra::cli
