#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/utf8.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "suite/file/suite_file.h"
#include "suite/results/results.h"
#include "suite/results/results_file.h"
#include "suite/serve/review.h"
#include "system/folder.h"
#include "system/interruption.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

struct ReviewArguments {
    std::string results = "glibra-results";
    std::vector<std::string> suites;
    std::string goldens;
    bool allowOutside = false;
    bool serve = false;
    std::vector<std::string> accept;  ///< patterns of shots
};

/// The suites of the run. Those that only the results name have to lie below the current folder: results may
/// come from somebody else, who is not to choose which goldens are written.
Result<std::vector<suite::Suite>> suitesOf(const suite::RunResult& run, const ReviewArguments& arguments) {
    std::vector<fs::path> files(arguments.suites.begin(), arguments.suites.end());
    if (files.empty() && run.planned)
        for (const suite::PlannedShots& each : *run.planned)
            if (!each.file.empty() && system::isBelow(each.file, ".")) files.emplace_back(each.file);
    std::vector<suite::Suite> suites;
    Diagnostics problems;
    for (const fs::path& each : files) {
        Result<suite::Suite> read = suite::readSuite(each);
        append(problems, std::move(read.diagnostics));
        if (read) suites.push_back(*std::move(read.value));
    }
    if (hasError(problems)) return problems;
    return {std::move(suites), std::move(problems)};
}

void list(const suite::Review& review, bool isWhole) {
    std::string text;
    for (const suite::ReviewGroup& group : review.groups()) {
        text += fmt::format("{} ({})\n", base::printableText(group.cause), group.shots.size());
        for (const std::size_t each : group.shots) {
            const suite::ShotResult& shot = review.shots()[each];
            const std::string decided = review.decisionOf(each);
            text += base::printableText(fmt::format("    {}{}/{}: {}", decided.empty() ? "" : decided + ": ",
                                                    shot.suite, shot.shot, suite::reasonOf(shot))) +
                    "\n";
        }
    }
    if (text.empty() && isWhole) text = "nothing has failed\n";
    std::fwrite(text.data(), 1, text.size(), stdout);
}

/// --accept: the pictures of these shots become goldens.
int accept(suite::Review& review, std::span<const std::string> patterns) {
    std::string text;
    int accepted = 0, refused = 0;
    for (std::size_t i = 0; i < review.shots().size(); ++i) {
        if (!review.isNamed(i, patterns)) continue;
        const suite::ShotResult& shot = review.shots()[i];
        const std::string why = review.acceptUnseen(i);
        ++(why.empty() ? accepted : refused);
        text += base::printableText(fmt::format("{}: {}/{}{}{}", why.empty() ? "accepted" : "refused",
                                                shot.suite, shot.shot, why.empty() ? "" : ": ", why)) +
                "\n";
    }
    text += accepted + refused == 0 ? "no shot of these names needs a look\n"
                                    : fmt::format("{} accepted, {} refused\n", accepted, refused);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return refused == 0 && accepted > 0 ? kDone : kDiffers;
}

int review(const ReviewArguments& arguments) {
    if (arguments.serve && !arguments.accept.empty())
        return refuse("--accept excludes --serve: it accepts without a page");
    const Result<suite::RunResult> run = suite::readResults(arguments.results);
    print(run.diagnostics);
    if (!run) return kSceneIsWrong;
    const auto suites = suitesOf(*run, arguments);
    print(suites.diagnostics);
    if (!suites) return kSceneIsWrong;
    suite::Review shown(*run, *suites, {arguments.results, arguments.goldens, arguments.allowOutside});
    print(shown.problems());
    if (!arguments.accept.empty()) return accept(shown, arguments.accept);
    const std::string missing = suite::shortfall(*run);
    if (!missing.empty()) print({diagnose("result-E03", missing + "; continue the run with --resume")});
    if (!arguments.serve) {
        list(shown, missing.empty());
        if (!missing.empty()) return kSceneIsWrong;
        for (std::size_t i = 0; i < shown.shots().size(); ++i)
            if (!suite::isChangedPass(shown.shots()[i]) && shown.decisionOf(i) != "accepted") return kDiffers;
        return kDone;
    }
    if (suites->empty())
        printNote(
            "nothing can be accepted, because the suites are not below the current folder; "
            "name them");
    const system::Interruption interruption;
    auto server = suite::LoopbackServer::open();
    print(server.diagnostics);
    if (!server) return kSceneIsWrong;
    shown.serve(*server);
    std::printf("%s\n", server->address().c_str());
    std::fflush(stdout);
    printLine("open this address in a browser; Ctrl-C ends the review");
    server->run([&] { return interruption.signal() != 0; });
    return kDone;
}

}  // namespace

void addReview(CommandLine& program, int& status) {
    auto arguments = std::make_shared<ReviewArguments>();
    ReviewArguments& to = *arguments;
    CommandLine command = program.subcommand(
        "review", "shows the shots that failed, by cause, to accept or to reject in a browser",
        "glibra review glibra-results/                  # what failed, grouped by cause\n"
        "glibra review glibra-results/ --serve          # prints an address for your browser\n"
        "glibra review glibra-results/ --accept 'oval*' # the pictures of these shots become goldens\n"
        "glibra review results/ tests/pictures.toml --serve");
    command.option("RESULTS", to.results, "folder that `glibra test --results` has written").withDefault();
    command.list("SUITE", to.suites, "suites of the run, if they are not below the current folder");
    command.flag("--serve", to.serve, "serve a page on this machine (127.0.0.1) and print its address");
    command.repeated(
        "--accept", to.accept,
        "make the pictures of these shots goldens, without a page: names or patterns as for `glibra test "
        "--only`, or SUITE/SHOT; may be repeated");
    command
        .option("--goldens", to.goldens,
                "folder with one folder of goldens per suite, instead of the suites' own")
        .written();
    command.flag("--allow-outside", to.allowOutside, "let goldens be written outside of the suite's folder");
    command.onRun([arguments, &status] { status = review(*arguments); });
}

}  // namespace glibra::cli
