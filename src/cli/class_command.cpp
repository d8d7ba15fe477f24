#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/utf8.h"
#include "classroom/class_page.h"
#include "classroom/class_run.h"
#include "classroom/moments.h"
#include "classroom/submissions.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/interruption.h"
#include "cli/library_hint.h"
#include "cli/picture_options.h"
#include "cli/run_facts.h"
#include "cli/suite_progress.h"
#include "cli/untrusted.h"
#include "cli/written_files.h"
#include "glib/text.h"
#include "suite/golden/hash_key.h"
#include "suite/options/option_table.h"
#include "suite/options/option_words.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

struct ClassArguments {
    std::string folder;
    std::string reference;
    std::string site = "glibra-class";
    std::string scene;
    std::vector<std::string> templates;
    std::vector<double> times;
    std::vector<std::string> sweeps;
    suite::Shot picture;
    double timeout = 20;  ///< seconds: a class has a submission that never ends sooner than a suite has
    Driver driver = Driver::automatic;
    int jobs = 0;
    bool untrusted = false;
    bool siteIsNamed = false;  ///< by the user
};

/// The moments, and the reference's scene. Without a value, the reason has been printed.
std::optional<std::vector<classroom::Moment>> momentsOf(const ClassArguments& arguments,
                                                        fs::path& reference) {
    const bool isSuite = glib::sameWord(fs::path(arguments.reference).extension().string(), ".toml");
    if (isSuite && (!arguments.times.empty() || !arguments.sweeps.empty() ||
                    !arguments.picture.options.set.empty() || arguments.picture.options.width > 0)) {
        printError("--time, --set, --sweep and --size belong into the suite that --reference names");
        return std::nullopt;
    }
    Result<std::vector<classroom::Moment>> moments =
        isSuite ? classroom::momentsOfSuite(arguments.reference)
                : classroom::momentsOf(arguments.picture, arguments.times, arguments.sweeps);
    print(moments.diagnostics);
    if (!moments) return std::nullopt;
    reference = isSuite ? moments->front().shot.script : fs::path(arguments.reference);
    for (classroom::Moment& each : *moments) {
        std::vector<fs::path>& roots = each.shot.options.libraryRoots;
        if (isSuite) {
            const std::vector<fs::path>& named = arguments.picture.options.libraryRoots;
            roots.insert(roots.end(), named.begin(), named.end());
        }
        for (fs::path& root : libraryRoots()) roots.push_back(std::move(root));
    }
    return std::move(*moments.value);
}

/// What confines the workers. Every submission's folder can be read by all workers, but a scene reads only
/// its own, because the file look-up refuses the others.
base::Sandbox drawingSandbox(const classroom::ClassPlan& plan, Driver driver) {
    std::vector<std::string> scenes{plan.reference.string()};
    for (const classroom::Submission& each : plan.submissions.all)
        if (!each.scene.empty()) scenes.push_back(each.scene.string());
    base::Sandbox sandbox = sandboxOf(scenes, plan.moments.front().shot.options, driver);
    sandbox.readable.push_back(plan.folder);
    sandbox.readable.insert(sandbox.readable.end(), plan.given.begin(), plan.given.end());
    sandbox.writable.emplace_back(plan.site, fs::path("pictures"));
    return sandbox;
}

int runClassCommand(const ClassArguments& arguments, const std::string& command) {
    if (arguments.untrusted && !prepareUntrusted()) return kNoDriver;
    classroom::ClassPlan plan;
    plan.folder = arguments.folder;
    plan.site = arguments.site;
    plan.given.assign(arguments.templates.begin(), arguments.templates.end());
    for (const fs::path& each : plan.given)
        if (std::error_code failure; !fs::exists(each, failure)) {
            printError(fmt::format("there is no template '{}'", each.string()));
            return kWrongUsage;
        }
    if (std::error_code failure; fs::equivalent(plan.site, plan.folder, failure)) {
        printError(fmt::format(
            "-o {}: this is the folder of the submissions, among which the page would count; name "
            "another one",
            arguments.site));
        return kWrongUsage;
    }
    if (std::error_code failure; !arguments.siteIsNamed && fs::is_symlink(plan.site, failure)) {
        print({linkedFolder(plan.site, "-o")});
        return kSceneIsWrong;
    }
    std::optional<std::vector<classroom::Moment>> moments = momentsOf(arguments, plan.reference);
    if (!moments) return kWrongUsage;
    plan.moments = std::move(*moments);
    std::vector<fs::path> others = plan.given;
    others.emplace_back(plan.site);
    others.emplace_back(plan.reference.has_parent_path() ? plan.reference.parent_path() : fs::path("."));
    others.emplace_back(arguments.reference);
    Result<classroom::Submissions> found = classroom::findSubmissions(
        plan.folder, {.scene = arguments.scene, .reference = plan.reference, .others = std::move(others)});
    print(found.diagnostics);
    if (!found) return kWrongUsage;
    plan.submissions = std::move(*found);

    std::optional<base::Sandbox> drawing, reading;
    if (arguments.untrusted) {
        drawing = drawingSandbox(plan, arguments.driver);
        reading = drawing;
        reading->writable.clear();
        reading->readable.emplace_back(plan.site, fs::path("pictures"));
        makeWritableFolders(*drawing);
    }
    classroom::ClassOptions options;
    options.driver = arguments.driver;
    options.jobs = arguments.jobs;
    options.timeout = arguments.timeout;
    options.memory = arguments.picture.memory;
    options.drawing = drawing ? &*drawing : nullptr;
    options.reading = reading ? &*reading : nullptr;

    const auto start = std::chrono::steady_clock::now();
    const Interruption interruption;
    SuiteProgress progress(classroom::pictureCount(plan), ::isatty(STDERR_FILENO) == 1);
    classroom::ClassEvents events;
    events.begins = [&](const std::string& submission) { progress.begins(submission); };
    events.done = [&](bool failed) { progress.add(failed); };
    events.stop = [&] { return interruption.signal() != 0; };
    classroom::ClassEnd end = classroom::runClass(plan, options, events);
    progress.clear();
    print(end.diagnostics);
    if (end.noDriver) return kNoDriver;
    if (end.stopped) {
        printLine("stopped; no page was written");
        interruption.obey();
    }
    if (end.stopped || hasError(end.diagnostics)) return kSceneIsWrong;

    end.classroom.machine = suite::describeMachine();
    end.classroom.command = command;
    end.classroom.began = utcNow();
    end.classroom.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const Diagnostics problems = classroom::writeSite(end.classroom, plan.site);
    print(problems);
    if (hasError(problems)) return kSceneIsWrong;
    for (const classroom::Entry& each : end.classroom.entries)
        if (!classroom::isDrawn(each))
            printLine(base::printableText(fmt::format("{}: {}: {}", each.submission.name,
                                                      classroom::stateOf(each), classroom::reasonOf(each))));
    for (const classroom::Entry& each : end.classroom.entries)
        if (const Diagnostics hint = libraryHint(each.submission.scene, each.diagnostics); !hint.empty()) {
            print(hint);
            break;
        }
    printLine(classroom::summary(end.classroom));
    printLine("page: " + (plan.site / "index.html").string());
    const std::vector<classroom::Submission>& all = plan.submissions.all;
    const bool isWhole = std::none_of(all.begin(), all.end(),
                                      [](const classroom::Submission& each) { return each.isUnlisted; });
    return isWhole ? kDone : kSceneIsWrong;
}

}  // namespace

void addClass(CommandLine& program, int& status) {
    auto arguments = std::make_shared<ClassArguments>();
    CommandLine command = program.subcommand(
        "class", "draws the submissions of a class beside a reference, on one page with scores and a table",
        "glibra class submissions/ --reference solution.glib -o site/   # a page and a table for the grade "
        "book\n"
        "glibra class submissions/ --reference solution.glib --time 0 --time 2.5\n"
        "glibra class submissions/ --reference solution.glib --template handout/ --untrusted");
    ClassArguments& to = *arguments;
    command.option("SUBMISSIONS", to.folder, "folder with a folder or a .glib file per student").required();
    command
        .option("--reference", to.reference,
                "the scene to compare with; or a suite of it or an exercise (.toml), which says what to draw")
        .required();
    command.option("-o,--output", to.site, "folder for index.html, grades.csv and the pictures")
        .written()
        .withDefault();
    command.option("--scene", to.scene, "the scene in each folder, as 'project2.glib' or 'src/*.glib'");
    command.repeated(
        "--template", to.templates,
        "file or folder of code that was given to all; it does not count as similar; may be repeated");
    const suite::OptionRow& time = *suite::findOption("time");
    command
        .repeated(
            "--time",
            [&to, &time](const std::string& text) {
                suite::Shot shot;
                std::string problem = suite::readOptionText(time, text, shot);
                if (problem.empty()) to.times.push_back(shot.options.time);
                return problem;
            },
            "seconds since the start of the scenes; may be repeated, for several pictures of each")
        .placeholder("SECONDS");
    command
        .repeated("--sweep", to.sweeps,
                  "values of a uniform, one picture each, as in a suite: 'uTol = [0, 0.1]'; may be repeated")
        .placeholder("'NAME = LIST'");
    for (const char* each : {"set", "size", "samples", "strict", "library", "memory"})
        addPictureOption(command, each, to.picture);
    command.option("--timeout", to.timeout, "seconds that one picture may take; 0 means no limit")
        .within(0, 1e6)
        .withDefault();
    command.driver(to.driver);
    command.jobs(to.jobs);
    addUntrustedOption(command, to.untrusted);
    command.onRun([arguments, site = command.find("--output"), &status] {
        arguments->siteIsNamed = site.isGiven();
        status = runClassCommand(*arguments, commandLine());
    });
}

}  // namespace glibra::cli
