#include "cli/suite_render.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "cli/commands.h"
#include "cli/interruption.h"
#include "cli/suite_progress.h"
#include "cli/untrusted.h"
#include "cli/written_files.h"
#include "suite/golden/golden_store.h"
#include "suite/run/fingerprint.h"

namespace glibra::cli {

namespace fs = std::filesystem;

namespace {

/// file-E13 for each picture that would replace a suite, a golden, or a file that a scene reads.
Diagnostics overwrittenByPictures(const Selection& selection, std::span<const suite::ShotReference> shots,
                                  const suite::RunOptions& options, const SuiteArguments& arguments,
                                  const std::function<bool()>& stop) {
    std::vector<fs::path> pictures;
    for (const suite::ShotReference& each : shots) {
        const suite::Suite& suite = selection.suites[each.suite];
        pictures.push_back(suite::pictureFile(options.onlyRender, suite, suite.shots[each.shot],
                                              selection.suites.size() > 1));
    }
    if (!anyExists(pictures)) return {};
    ReadFiles read;
    read.add(selection, suite::inputsOf(selection.suites, selection.shots,
                                        inputWorkers(arguments, shots.size(), options.sandbox, stop),
                                        arguments.timeout));
    for (const suite::Suite& suite : selection.suites)
        for (const suite::Shot& shot : suite.shots)
            if (shot.golden)
                read.add(suite::goldenFolder(suite) / suite::goldenName(shot), "it is a golden of the suite");
    Diagnostics problems;
    for (const fs::path& each : pictures) append(problems, read.overwrittenBy(each, "-o"));
    return problems;
}

}  // namespace

int renderSuites(const SuiteArguments& arguments, const std::string& output) {
    int status = kDone;
    const std::optional<Selection> selection = readSelection(arguments, status);
    if (!selection) return status;
    const bool several = selection->suites.size() > 1;
    suite::RunOptions options;
    options.driver = arguments.driver;
    options.jobs = arguments.jobs;
    options.timeout = arguments.timeout;
    options.memory = arguments.memory;
    options.skip = arguments.skip;
    options.onlyRender = output;
    if (output.empty()) options.onlyRender = several ? "." : selection->suites.front().name;

    // Without -o, the names of all folders are this program's.
    for (const suite::Suite& each : selection->suites) {
        const fs::path folder = several ? options.onlyRender / each.name : options.onlyRender;
        std::error_code failure;
        if ((several || output.empty()) && fs::is_symlink(folder, failure)) {
            print({linkedFolder(folder, "-o")});
            return kSceneIsWrong;
        }
    }
    std::optional<base::Sandbox> sandbox;
    if (arguments.untrusted) {
        std::vector<base::Reach> folders;
        for (const suite::Suite& each : selection->suites)
            folders.push_back(several ? base::Reach(options.onlyRender, each.name)
                                      : base::Reach(options.onlyRender));
        sandbox = sandboxOf(*selection, arguments.driver, {}, folders);
        if (!sandbox) return kSceneIsWrong;
        options.sandbox = &*sandbox;
        makeWritableFolders(*sandbox);
    }

    std::vector<suite::ShotReference> open;
    for (const suite::ShotReference& each : selection->shots) {
        const suite::Suite& suite = selection->suites[each.suite];
        std::error_code failure;
        if (!arguments.resume ||
            !fs::exists(suite::pictureFile(options.onlyRender, suite, suite.shots[each.shot], several),
                        failure))
            open.push_back(each);
    }

    const Interruption interruption;
    const auto isStopped = [&] { return interruption.signal() != 0; };
    if (printErrors(overwrittenByPictures(*selection, open, options, arguments, isStopped)))
        return kSceneIsWrong;
    const bool terminal = ::isatty(STDERR_FILENO) == 1;
    SuiteProgress progress(open.size(), terminal);
    std::size_t drawn = 0;
    std::vector<std::string> failed;
    suite::RunEvents events;
    events.begins = [&](const suite::ShotReference& each) {
        progress.begins(selection->suites[each.suite].shots[each.shot].name);
    };
    events.done = [&](const suite::ShotResult& shot) {
        std::string lines = printable(shot.diagnostics, hasColor(STDERR_FILENO));
        if (!lines.empty()) {
            lines.pop_back();
            progress.print(lines);
        }
        const bool bad = suite::isFailure(shot.verdict);
        if (bad)
            failed.push_back(several ? shot.suite + "/" + shot.shot : shot.shot);
        else
            ++drawn;
        progress.add(bad);
    };
    events.stop = isStopped;
    const suite::RunEnd end = suite::runShots(selection->suites, open, options, events);
    progress.clear();
    print(end.diagnostics);
    if (end.noDriver) return kNoDriver;

    std::string summary = fmt::format("{} of {} shots rendered", drawn, open.size());
    if (open.size() < selection->shots.size())
        summary += fmt::format(", {} exist already", selection->shots.size() - open.size());
    for (std::size_t i = 0; i < failed.size(); ++i) summary += (i == 0 ? ", failed: " : ", ") + failed[i];
    printLine(summary);
    if (end.stopped) {
        printLine("stopped; continue with --resume");
        interruption.obey();
    }
    return failed.empty() ? kDone : kSceneIsWrong;
}

}  // namespace glibra::cli
