#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <memory>
#include <thread>

#include "cli/commands.h"
#include "cli/interruption.h"
#include "cli/suite_options.h"
#include "cli/suite_progress.h"
#include "cli/test_results.h"
#include "image/file.h"
#include "suite/golden/hash_key.h"
#include "suite/report/html_report.h"
#include "suite/report/junit_report.h"
#include "suite/report/terminal_report.h"
#include "suite/report/verdict_commands.h"
#include "suite/results/merge.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

struct TestArguments {
    SuiteArguments suites;
    bool update = false;
    bool force = false;
    bool variant = false;
    bool noSkip = false;
    std::string results = "glibra-results";
    std::string report;
    std::string junit;
    std::string goldens;
    std::vector<std::string> merge;
    std::string command;
};

/// Writes the reports that were asked for and prints the summary; the exit status.
int tell(const suite::RunResult& run, const TestArguments& arguments) {
    const std::string text = suite::toText(run, ::isatty(STDOUT_FILENO) == 1, arguments.results);
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
    Diagnostics problems;
    if (!arguments.report.empty()) {
        append(problems, suite::writeHtmlReport(run, arguments.results, arguments.report));
        if (!hasError(problems))
            std::fprintf(stderr, "report: %s\n", (fs::path(arguments.report) / "index.html").c_str());
    }
    if (!arguments.junit.empty()) {
        const std::string xml = suite::toJunit(run);
        std::error_code ignored;  // reported with the file that cannot be written
        if (const fs::path folder = fs::path(arguments.junit).parent_path(); !folder.empty())
            fs::create_directories(folder, ignored);
        append(problems, image::writeFileAtomically(arguments.junit, std::as_bytes(std::span(xml))));
    }
    print(problems);
    return std::max(hasError(problems) ? kSceneIsWrong : kDone, exitStatus(run));
}

int merge(const TestArguments& arguments) {
    const std::vector<fs::path> folders(arguments.merge.begin(), arguments.merge.end());
    const Result<suite::RunResult> merged = suite::mergeResults(folders, arguments.results);
    print(merged.diagnostics);
    const int status = hasError(merged.diagnostics) ? kSceneIsWrong : kDone;
    return merged ? std::max(status, tell(*merged, arguments)) : status;
}

/// The command as it was given; empty where the system does not tell.
std::string commandLine() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    std::string line;
    for (std::string word; std::getline(file, word, '\0');)
        line += (line.empty() ? "" : " ") + suite::shellWord(word);
    return line;
}

std::string utcNow() {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

/// A line for a shot that needs one while the run goes on; empty for a plain pass.
std::string lineOf(const suite::ShotResult& shot) {
    if (shot.verdict == suite::Verdict::passed && !shot.changed) return {};
    return fmt::format("{}: {}/{}{}{}", shot.changed ? "changed" : suite::name(shot.verdict), shot.suite,
                       shot.shot, shot.reason.empty() ? "" : ": ", shot.reason);
}

int test(const TestArguments& arguments) {
    int status = kDone;
    const std::optional<Selection> selection = readSelection(arguments.suites, status);
    if (!selection) return status;

    const auto start = std::chrono::steady_clock::now();
    const Interruption interruption;
    suite::RunResult run;
    run.machine = suite::describeMachine();
    run.shard = arguments.suites.shard;
    run.command = arguments.command;
    run.began = utcNow();
    std::optional<RunRecord> record =
        RunRecord::open(arguments.results, run, arguments.suites.resume, arguments.update,
                        [&] { return interruption.signal() != 0; });
    if (!record) {
        interruption.obey();
        return kSceneIsWrong;
    }
    std::vector<suite::ShotReference> open;
    for (const suite::ShotReference& each : selection->shots)
        if (!record->isDone(selection->suites[each.suite], each)) open.push_back(each);

    const bool terminal = ::isatty(STDERR_FILENO) == 1;
    SuiteProgress progress(open.size(), terminal);
    suite::RunOptions options;
    options.driver = arguments.suites.driver;
    options.jobs = arguments.suites.jobs;
    options.timeout = arguments.suites.timeout;
    options.skip = !arguments.noSkip;
    options.update = arguments.update;
    options.force = arguments.force;
    options.variant = arguments.variant;
    options.goldens = arguments.goldens;
    options.results = arguments.results;
    suite::RunEvents events;
    events.begins = [&](const suite::ShotReference& each) {
        const suite::Suite& suite = selection->suites[each.suite];
        progress.begins(suite.name + "/" + suite.shots[each.shot].name);
    };
    events.done = [&](const suite::ShotResult& shot) {
        if (const std::string line = lineOf(shot); !line.empty()) progress.tell(line);
        progress.add(suite::isFailure(shot.verdict));
        record->add(shot);
    };
    events.stop = [&] { return interruption.signal() != 0 || record->failed(); };
    const suite::RunEnd end = suite::runShots(selection->suites, open, options, events);
    progress.clear();
    print(end.diagnostics);
    if (end.noDriver) return kNoDriver;

    run.driver = end.driver;
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    record->finish(run, selection->suites, selection->shots);
    if (record->failed()) status = kSceneIsWrong;
    if (hasError(end.diagnostics)) status = kSceneIsWrong;
    status = std::max(status, tell(run, arguments));
    if (end.stopped && interruption.signal() != 0) {
        std::fprintf(stderr, "stopped; --resume continues with what is left\n");
        interruption.obey();
    }
    return status;
}

int runCommand(const TestArguments& arguments) {
    const auto refuse = [](const char* why) {
        std::fprintf(stderr, "glibra: error: %s\n", why);
        return kWrongUsage;
    };
    if (!arguments.merge.empty()) {
        if (!arguments.suites.suites.empty()) return refuse("--merge takes results folders and no suites");
        return merge(arguments);
    }
    if (arguments.suites.suites.empty()) return refuse("name a suite: a TOML file, or a folder of scenes");
    if ((arguments.force || arguments.variant) && !arguments.update)
        return refuse("--force and --variant go with --update");
    return test(arguments);
}

}  // namespace

void addTest(CLI::App& app, int& status) {
    auto arguments = std::make_shared<TestArguments>();
    CLI::App* command = app.add_subcommand("test", "hold rendered pictures against golden ones");
    TestArguments& to = *arguments;
    command->add_option("SUITE", to.suites.suites, "suites: TOML files, or folders of scenes");
    command->add_flag("--update", to.update, "make what differs the new golden");
    command->add_flag("--force", to.force,
                      "with --update: even pictures of one colour, or with values that are no number");
    command->add_flag("--variant", to.variant,
                      "with --update: a golden for this family of drivers alone, as NAME.nvidia.png");
    addSelectionOptions(*command, to.suites);
    command->add_option("--results", to.results, "folder for results and the pictures of failures")
        ->capture_default_str();
    command->add_option("--report", to.report, "folder for a report to look at in a browser");
    command->add_option("--junit", to.junit, "file for a report as JUnit XML");
    command->add_option("--goldens", to.goldens,
                        "folder with a folder of golden pictures a suite, instead of the suites' own");
    command->add_option("--merge", to.merge, "join the results of several runs, which were shards of one");
    command->add_option("--jobs", to.suites.jobs, "worker processes; without it one a processor")
        ->check(CLI::Range(1, 256));
    command->add_option("--driver", to.suites.driver, "which OpenGL: auto, egl, egl-device, osmesa")
        ->transform(CLI::CheckedTransformer(kDriversByWord));
    command
        ->add_option("--timeout", to.suites.timeout,
                     "seconds that one shot may take, instead of what the suite says; 0 for no limit")
        ->check(CLI::Range(0.0, 1e6));
    command->add_flag("--no-skip", to.noSkip,
                      "read, make and draw also what the pictures do not need; they stay the same");
    command->callback([arguments, &status] {
        arguments->command = commandLine();
        arguments->suites.withNamed = !arguments->update;
        status = runCommand(*arguments);
    });
}

}  // namespace glibra::cli
