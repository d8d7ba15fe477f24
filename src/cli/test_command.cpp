#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/text.h"
#include "base/utf8.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/file_access.h"
#include "cli/picture_options.h"
#include "cli/suite_options.h"
#include "cli/suite_progress.h"
#include "cli/test_results.h"
#include "image/file.h"
#include "render/file/job.h"
#include "suite/golden/golden_store.h"
#include "suite/golden/hash_list.h"
#include "suite/golden/orphans.h"
#include "suite/options/option_words.h"
#include "suite/report/terminal_report.h"
#include "suite/results/merge.h"
#include "suite/results/results.h"
#include "suite/results/results_file.h"
#include "suite/run/fingerprint.h"
#include "suite/run/verdict.h"
#include "suite/suite.h"
#include "system/interruption.h"

namespace glibra::cli {

namespace fs = std::filesystem;
namespace {

/// The goldens that belong to no shot of the suites, for each suite. `goldens` replaces their own folders
/// unless it is empty.
std::vector<std::shared_ptr<const suite::Orphans>> orphansOf(const std::vector<suite::Suite>& suites,
                                                             const fs::path& goldens) {
    std::vector<std::shared_ptr<const suite::Orphans>> orphans;
    for (const suite::Suite& each : suites)
        orphans.push_back(
            std::make_shared<const suite::Orphans>(suite::orphanGoldens(each, goldens, suites)));
    return orphans;
}

/// Puts those that are still there into `run`, or removes them with `prune`. Returns the exit status.
int settleOrphans(const std::vector<suite::Suite>& suites,
                  const std::vector<std::shared_ptr<const suite::Orphans>>& orphans, bool prune,
                  suite::RunResult& run) {
    int status = kDone;
    for (std::size_t i = 0; i < suites.size(); ++i) {
        std::vector<fs::path> left = orphans[i]->files();
        std::error_code ignored;
        std::erase_if(left, [&](const fs::path& each) { return !fs::exists(each, ignored); });
        if (left.empty()) continue;
        const bool isRefused = std::ranges::any_of(run.shots, [&](const suite::ShotResult& each) {
            return each.suite == suites[i].name && each.verdict == suite::Verdict::refused;
        });
        if (prune && isRefused)
            print({withoutId(Severity::note,
                             fmt::format("--prune removes nothing of '{}', because a picture of it was not "
                                         "accepted",
                                         suites[i].name))});
        if (prune && !isRefused) {
            if (printErrors(suite::removeOrphans(left))) status = kSceneIsWrong;
            std::string text =
                fmt::format("{} of no shot of '{}' {} removed:", base::counted(left.size(), "golden"),
                            suites[i].name, left.size() == 1 ? "was" : "were");
            for (const fs::path& each : left) text += " " + each.generic_string();
            print({withoutId(Severity::note, text)});
            continue;
        }
        for (const fs::path& each : left) run.orphans.push_back({suites[i].name, each.generic_string()});
    }
    std::ranges::sort(run.orphans);
    return status;
}

/// Prints a note about those that the run has left.
void noteOrphans(const suite::RunResult& run) {
    constexpr std::size_t kMostNames = 10;
    for (std::string& each : suite::orphanLines(run, kMostNames))
        print({withoutId(Severity::note, std::move(each))});
}

constexpr const char* kMissing = "missing";  ///< --update=missing

struct TestArguments {
    SuiteArguments suites;
    std::string update;  ///< "all", "missing" or empty
    bool rename = false;
    bool strictOrphans = false;
    bool list = false;
    std::string results = "glibra-results";
    bool resultsAreNamed = false;  ///< by the user
    ReportRequest reports;
    std::string goldens;
    std::vector<std::string> merge;
    std::vector<std::string> roots;
    std::string command;

    [[nodiscard]] bool updates() const { return !update.empty(); }
    /// It may write or remove goldens.
    [[nodiscard]] bool writesGoldens() const { return updates() || rename || suites.run.prune; }
};

/// Prints the summary and writes the reports. Returns the exit status.
int report(suite::RunResult& run, const TestArguments& arguments, const suite::ReportRoots& roots) {
    run.orphansFail = arguments.strictOrphans;
    const std::string text =
        suite::toText(run, {.color = hasColor(system::Standard::output), .resultsFolder = arguments.results});
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
    noteOrphans(run);
    if (std::string awaited = suite::awaitedLine(run); !awaited.empty())
        print({withoutId(Severity::note, std::move(awaited))});
    return std::max(writeReports(run, arguments.reports, arguments.results, roots) ? kDone : kSceneIsWrong,
                    exitStatus(run));
}

/// A CI server reads the reports of a run that could not begin, too: each shot is an error.
void reportNoDriver(suite::RunResult run, const TestArguments& arguments, const Selection& selection,
                    const std::vector<suite::ShotReference>& shots, const Diagnostics& why) {
    const std::string reason = why.empty() ? "there is no OpenGL driver" : toString(why.front());
    for (const suite::ShotReference& each : shots) {
        const suite::Suite& suite = selection.suites[each.suite];
        run.shots.push_back(
            suite::ShotJudge::broken(suite, suite.shots[each.shot], suite::Verdict::failed, reason));
    }
    run.planned.reset();  // all that was planned is in the list
    writeReports(run, arguments.reports, arguments.results,
                 shownRoots(selection.suites, selection.shots, arguments.goldens));
}

/// file-E13 for the reports if they would replace a file that was read.
Diagnostics overwrittenByReports(const TestArguments& arguments, const ReadFiles& read) {
    Diagnostics problems;
    if (!arguments.reports.junit.empty())
        append(problems, read.overwrittenBy(arguments.reports.junit, "--junit"));
    if (!arguments.reports.summary.empty())
        append(problems, read.overwrittenBy(arguments.reports.summary, "--summary"));
    if (!arguments.reports.report.empty())
        append(problems, read.overwrittenBy(fs::path(arguments.reports.report) / "index.html", "--report"));
    return problems;
}

/// file-E13 for each file that the run would write although it reads it.
Diagnostics overwrittenBy(const TestArguments& arguments, const Selection& selection,
                          const suite::ShotInputs& inputs) {
    ReadFiles read;
    read.add(selection, inputs);
    Diagnostics problems;
    std::map<fs::path, std::size_t> goldens;  // the suite of each
    for (const suite::ShotReference& each : selection.shots) {
        const suite::Suite& suite = selection.suites[each.suite];
        const suite::Shot& shot = suite.shots[each.shot];
        const fs::path golden = suite::goldenFolder(suite, arguments.goldens) / suite::goldenName(shot);
        const auto [known, isNew] = goldens.try_emplace(render::filePlaceOf(golden), each.suite);
        if (!arguments.updates() || !shot.golden || shot.expectedError) continue;
        append(problems, read.overwrittenBy(golden, "--update"));
        if (!isNew && known->second != each.suite)
            problems.push_back(diagnose(
                "file-E13",
                fmt::format(
                    "--update: '{}' is a golden of the suites '{}' and '{}'; give each suite a folder "
                    "of its own, or its shots other names",
                    golden.generic_string(), selection.suites[known->second].name, suite.name),
                shot.place));
    }
    for (const auto& [golden, suite] : goldens) read.add(golden, "it is a golden of this run");
    append(problems, overwrittenByReports(arguments, read));
    append(problems, read.overwrittenBy(suite::resultsFile(arguments.results), "--results"));
    return problems;
}

int merge(const TestArguments& arguments) {
    const std::vector<fs::path> folders(arguments.merge.begin(), arguments.merge.end());
    ReadFiles read;
    for (const fs::path& each : folders) read.add(suite::resultsFile(each), "its results are merged");
    if (printErrors(overwrittenByReports(arguments, read))) return kSceneIsWrong;
    const Result<suite::RunResult> merged = suite::mergeResults(folders, arguments.results);
    print(merged.diagnostics);
    const int status = hasError(merged.diagnostics) ? kSceneIsWrong : kDone;
    // The results may come from anywhere, so what they name outside of their folders is shown only where the
    // user says so.
    suite::ReportRoots roots;
    for (const std::string& each : arguments.roots) {
        roots.texts.add(each);
        roots.pictures.add(each);
    }
    roots.areUnnamed = arguments.roots.empty();
    if (arguments.suites.run.timeout) roots.decoder.seconds = *arguments.suites.run.timeout;
    if (!merged) return status;
    suite::RunResult run = *merged;
    if (arguments.suites.run.strictFlaky)
        for (suite::ShotResult& each : run.shots) suite::countFlakyAsFailure(each);
    return std::max(status, report(run, arguments, roots));
}

/// The line to print for a shot while the run goes on; empty for a plain pass.
std::string lineOf(const suite::ShotResult& shot) {
    if (shot.verdict == suite::Verdict::passed && !shot.changed) return {};
    return base::printableText(fmt::format("{}: {}/{}{}{}",
                                           shot.changed ? "changed" : suite::name(shot.verdict), shot.suite,
                                           shot.shot, shot.reason.empty() ? "" : ": ", shot.reason));
}

/// The names of all shots to judge.
std::vector<suite::PlannedShots> planOf(const Selection& selection) {
    std::vector<suite::PlannedShots> plan;
    for (const suite::Suite& each : selection.suites)
        plan.push_back({each.name, {}, each.file.generic_string()});
    for (const suite::ShotReference& each : selection.shots)
        plan[each.suite].shots.push_back(selection.suites[each.suite].shots[each.shot].name);
    return plan;
}

/// What is known of a run before it begins.
suite::RunResult beginningOf(const TestArguments& arguments, const Selection& selection,
                             const suite::RunOptions& options) {
    suite::RunResult run;
    run.machine = suite::describeMachine();
    run.shard = arguments.suites.shard;
    run.plan = suite::planDigest(selection.suites, selection.undivided, options);
    run.command = arguments.command;
    run.began = utcNow();
    run.planned = planOf(selection);
    return run;
}

suite::RunOptions runOptions(const TestArguments& arguments, const std::optional<system::Sandbox>& sandbox) {
    suite::RunOptions options = arguments.suites.run;
    options.update = arguments.updates();
    options.onlyMissing = arguments.update == kMissing;
    options.goldens = arguments.goldens;
    options.results = arguments.results;
    options.sandbox = sandbox ? &*sandbox : nullptr;
    return options;
}

/// --rename: gives the golden of the shot's former name its new one. The picture is that of the golden, or it
/// is compared with it.
void moveGolden(suite::ShotResult& shot, const Selection& selection, const suite::RunOptions& options) {
    const fs::path& from = shot.renamedFrom.empty() ? shot.nearTo : shot.renamedFrom;
    if (shot.verdict != suite::Verdict::missing || from.empty()) return;
    const auto found = std::ranges::find(selection.suites, shot.suite, &suite::Suite::name);
    if (found == selection.suites.end() || !found->find(shot.shot)) return;
    const auto store = suite::GoldenStore::open(*found, options.goldens, options.allowOutside);
    const suite::Orphans& orphans =
        *options.orphansBySuite[static_cast<std::size_t>(found - selection.suites.begin())];
    const Diagnostics problems = store->rename(from, *found->find(shot.shot), orphans.files());
    if (hasError(problems)) {
        shot.verdict = suite::Verdict::refused;
        shot.reason = toString(problems.front());
        append(shot.diagnostics, problems);
        return;
    }
    const bool isSame = !shot.renamedFrom.empty() || shot.judgement.same;
    shot.verdict = isSame ? suite::Verdict::updated : suite::Verdict::failed;
    shot.reason = fmt::format("the golden '{}' was renamed{}", from.generic_string(),
                              isSame ? "" : "; the picture is another one: " + shot.judgement.reason);
}

int test(const TestArguments& arguments) {
    int status = kDone;
    const std::optional<Selection> selection = readSelection(arguments.suites, status);
    if (!selection) return status;
    if (arguments.writesGoldens() && !arguments.suites.run.allowOutside) {
        Diagnostics problems;
        for (const suite::Suite& each : selection->suites)
            append(problems, suite::checkGoldenFolder(each, arguments.goldens));
        if (printErrors(problems)) return kWrongUsage;
    }

    std::optional<system::Sandbox> sandbox;
    if (arguments.suites.untrusted) {
        std::vector<system::Reach> folders;
        for (const suite::Suite& each : selection->suites)
            folders.emplace_back(fs::path(arguments.results), fs::path(each.name));
        sandbox = sandboxOf(*selection, arguments.suites.run.driver, arguments.goldens, folders);
        if (!sandbox) return kSceneIsWrong;
        sandbox->listable.emplace_back(
            fs::path(arguments.results));  // pictures are written from there on, folder by folder
    }

    const auto start = std::chrono::steady_clock::now();
    const system::Interruption interruption;
    const auto isStopped = [&] { return interruption.signal() != 0; };
    suite::RunOptions options = runOptions(arguments, sandbox);
    options.orphansBySuite = orphansOf(selection->suites, arguments.goldens);
    const suite::ShotInputs inputs = suite::inputsOf(
        selection->suites, selection->shots,
        inputWorkers(arguments.suites, selection->shots.size(), options.sandbox, isStopped), options.timeout);
    if (printErrors(overwrittenBy(arguments, *selection, inputs))) return kSceneIsWrong;
    const std::map<suite::ShotReference, std::string> fingerprints =
        suite::fingerprints(selection->suites, selection->shots, inputs, options);
    bool resumes = arguments.suites.resume;
    if (resumes && sandbox && mayBeForged(arguments.results, selection->suites)) {
        print({withoutId(
            Severity::note,
            fmt::format("all shots are drawn: with --untrusted no verdicts are taken from '{}', which "
                        "may have come with the suite; name another folder with --results",
                        arguments.results))});
        resumes = false;
    }
    suite::RunResult run = beginningOf(arguments, *selection, options);
    std::optional<RunRecord> record =
        RunRecord::open(arguments.results, run, resumes, arguments.updates(), isStopped);
    if (!record) {
        interruption.obey();
        return kSceneIsWrong;
    }
    if (sandbox) makeWritableFolders(*sandbox);  // opening the record has removed those of an earlier run
    std::string driver;
    if (record->hasEarlier())
        driver =
            suite::keyOfDriver(options.driver, inputWorkers(arguments.suites, 1, options.sandbox, isStopped));
    std::vector<suite::ShotReference> open;
    std::map<suite::ShotKey, std::pair<suite::ShotReference, std::string>> basisOf;  // with the fingerprint
    for (const suite::ShotReference& each : selection->shots) {
        const suite::Suite& suite = selection->suites[each.suite];
        const std::string& fingerprint = fingerprints.at(each);
        basisOf.emplace(suite::ShotKey(suite.name, suite.shots[each.shot].name),
                        std::pair(each, fingerprint));
        if (!record->isDone(suite, each, {fingerprint, driver}) ||
            (arguments.updates() && lacksGolden(suite, each.shot, arguments.goldens)))
            open.push_back(each);
    }
    if (const std::size_t count = record->droppedCount(); count > 0)
        printLine(fmt::format("{} of the earlier run {} drawn again: what the picture depends on has changed",
                              base::counted(count, "shot"), count == 1 ? "is" : "are"));

    const bool terminal = system::isTerminal(system::Standard::error);
    SuiteProgress progress(open.size(), terminal);
    // The report names each failure. Where both go to one place, it would stand there twice.
    const bool printsLines = !isSameFile(system::Standard::error, system::Standard::output);
    suite::RunEvents events;
    events.begins = [&](const suite::ShotReference& each) {
        const suite::Suite& suite = selection->suites[each.suite];
        progress.begins(suite.name + "/" + suite.shots[each.shot].name);
    };
    std::vector<suite::ShotResult> near;     // after those whose picture is that of a golden
    std::vector<suite::ShotResult> waiting;  // for pictures of the store
    const auto take = [&](suite::ShotResult shot) {
        if (arguments.rename) moveGolden(shot, *selection, options);
        if (const std::string line = lineOf(shot); printsLines && !line.empty()) progress.print(line);
        // A suite that is new has no goldens; that is no failure to count.
        progress.add(suite::isFailure(shot.verdict) && shot.verdict != suite::Verdict::missing);
        const auto& [reference, fingerprint] = basisOf.at({shot.suite, shot.shot});
        shot.fingerprint = suite::sealed(fingerprint, shot.verdict);
        if (const auto found = inputs.find(reference); suite::needsALook(shot) && found != inputs.end())
            shot.reads = found->second.files;
        record->add(shot);
    };
    events.done = [&](const suite::ShotResult& judged) {
        if (mayDownload(judged, *selection, options))
            waiting.push_back(judged);
        else if (arguments.rename && !judged.nearTo.empty())
            near.push_back(judged);
        else
            take(judged);
    };
    events.stop = [&] { return isStopped() || record->failed(); };
    suite::RunEnd end = suite::runShots(selection->suites, open, options, events);
    if (!waiting.empty()) {
        progress.clear();
        std::vector<suite::ShotResult> all = std::exchange(waiting, {});
        const std::set<suite::ShotKey> ready = downloadFor(all, *selection, options, events.stop);
        std::vector<suite::ShotReference> again;
        for (suite::ShotResult& each : all) {
            const suite::ShotKey key(each.suite, each.shot);
            if (ready.contains(key))
                again.push_back(basisOf.at(key).first);
            else
                take(std::move(each));
        }
        std::ranges::sort(again);
        if (!again.empty() && !events.stop()) {
            suite::RunEnd second = suite::runShots(selection->suites, again, options, events);
            append(end.diagnostics, std::move(second.diagnostics));
            end.stopped = end.stopped || second.stopped;
        }
        end.stopped = end.stopped || events.stop();
        // What cannot be read even now is no matter of the store.
        for (suite::ShotResult& each : std::exchange(waiting, {})) take(std::move(each));
    }
    for (suite::ShotResult& each : near) {
        if (std::error_code failure; !fs::exists(each.nearTo, failure))
            each.nearTo.clear();  // it is another shot's
        take(std::move(each));
    }
    progress.clear();
    if (sandbox)
        for (const system::Reach& each : sandbox->writable) {
            std::error_code notEmpty;
            fs::remove(each.whole(), notEmpty);
        }
    print(end.diagnostics);
    if (end.noDriver) {
        reportNoDriver(run, arguments, *selection, open, end.diagnostics);
        return kNoDriver;
    }

    run.driver = end.driver;
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    record->collect(run, selection->suites, selection->shots);
    if (!end.stopped)
        status =
            std::max(status, settleOrphans(selection->suites, options.orphansBySuite, options.prune, run));
    record->finish(run);
    if (record->failed()) status = kSceneIsWrong;
    if (const std::string missing = suite::shortfall(run); !missing.empty()) {
        print({diagnose("result-E03", missing + "; continue the run with --resume")});
        status = kSceneIsWrong;
    }
    if (hasError(end.diagnostics)) status = kSceneIsWrong;
    status = std::max(
        status, report(run, arguments, shownRoots(selection->suites, selection->shots, arguments.goldens)));
    if (arguments.updates()) noteUploads(selection->suites, arguments.results);
    if (end.stopped && interruption.signal() != 0) {
        printLine("stopped; continue with --resume");
        interruption.obey();
    }
    return status;
}

/// A merge may read its own results folder.
bool isMerged(const TestArguments& arguments) {
    return std::any_of(arguments.merge.begin(), arguments.merge.end(), [&](const std::string& each) {
        std::error_code failure;
        return fs::equivalent(each, arguments.results, failure) ||
               fs::equivalent(suite::resultsFile(each), suite::resultsFile(arguments.results), failure);
    });
}

int runCommand(const TestArguments& arguments) {
    if (arguments.list && arguments.merge.empty() && !arguments.suites.suites.empty())
        return listShots(arguments.suites);
    markUnfinished(
        {isMerged(arguments) ? "" : arguments.results, arguments.reports.report, arguments.reports.junit});
    if (std::error_code failure; !arguments.resultsAreNamed && fs::is_symlink(arguments.results, failure)) {
        print({linkedFolder(arguments.results, "--results")});
        return kSceneIsWrong;
    }
    if (!arguments.merge.empty()) {
        if (!arguments.suites.suites.empty()) return refuse("--merge takes folders of results, not suites");
        return merge(arguments);
    }
    if (arguments.suites.suites.empty())
        return refuse("expected a suite: a TOML file or a folder of scenes, such as `glibra test scenes/`");
    const suite::RunOptions& run = arguments.suites.run;
    if ((run.force || run.variant || run.also || run.replaceUnreadable || run.anyDriver) &&
        !arguments.updates())
        return refuse("--force, --variant, --also, --replace-unreadable and --any-driver need --update");
    if (run.variant && run.also) return refuse("--also excludes --variant");
    if (arguments.rename && arguments.updates())
        return refuse("--rename excludes --update: rename first, then look at what is left");
    if (arguments.writesGoldens() && arguments.suites.untrusted)
        return refuse("--untrusted changes no goldens, so it excludes --update, --rename and --prune");
    if (arguments.suites.untrusted && !prepareUntrusted()) return kNoDriver;
    if (!arguments.roots.empty()) return refuse("--root needs --merge; a run knows its folders");
    return test(arguments);
}

}  // namespace

void addTest(CommandLine& program, int& status) {
    auto arguments = std::make_shared<TestArguments>();
    CommandLine command = program.subcommand(
        "test", "renders the shots of suites and compares them with golden pictures",
        "glibra test submissions/ --update              # the first pictures become the goldens\n"
        "glibra test submissions/ --report out/         # out/index.html shows what differs\n"
        "glibra test scenes/start.toml --only teapot");
    TestArguments& to = *arguments;
    suite::RunOptions& run = to.suites.run;
    command.list("SUITE", to.suites.suites, "suites: TOML files or folders of scenes");
    command.flag(
        "--update", {"all", kMissing}, to.update,
        "accept pictures that differ or have no golden as the new goldens; --update=missing: only those "
        "that have none");
    command.flag(
        "--rename", to.rename,
        "give a golden of no shot, whose picture a shot without a golden draws, the name of that shot");
    command.flag("--prune", run.prune,
                 "remove goldens that belong to no shot of the suites, instead of listing them");
    command.flag("--force", run.force,
                 "with --update: accept even pictures of one colour or with values that are not a number");
    command.flag("--variant", run.variant,
                 "with --update: write goldens for this family of drivers only, as NAME.nvidia.png");
    command.flag("--also", run.also,
                 "with --update: keep the golden, and accept the picture beside it, as NAME.also1.png");
    command.flag("--replace-unreadable", run.replaceUnreadable,
                 "with --update: also replace goldens that cannot be read");
    command.flag(
        "--any-driver", run.anyDriver,
        "with --update: also write goldens for all drivers whose suite has those of another family of "
        "drivers");
    command.flag("--list", to.list, "print the names of the selected shots, as SUITE/SHOT, and draw nothing");
    command.flag("--strict-flaky", run.strictFlaky, "shots that are right in some of their drawings fail");
    command.flag("--strict-orphans", to.strictOrphans, "goldens that belong to no shot make the run fail");
    addSelectionOptions(command, to.suites);
    command.option("--results", to.results, "folder for the results and the pictures of failures")
        .written()
        .withDefault();
    command.option("--report", to.reports.report, "folder for a report that a browser shows").written();
    command.option("--junit", to.reports.junit, "file for a JUnit report (XML)").written();
    command
        .option("--summary", to.reports.summary,
                "file for a short report in Markdown, for the page of a CI job")
        .written();
    command
        .option("--pictures-at", to.reports.picturesAt,
                "with --summary: address below which the pictures of the results will be found")
        .placeholder("URL");
    command
        .option("--goldens", to.goldens,
                "folder with one folder of goldens per suite, instead of the suites' own")
        .written();
    command.flag(
        "--allow-outside", run.allowOutside,
        "let --update write goldens outside of the suite's folder, and follow goldens that are links "
        "to such places");
    command.list("--merge", to.merge, "merge the results in these folders, as the shards of one run")
        .placeholder("FOLDER");
    command.repeated("--root", to.roots,
                     "with --merge: a folder of scenes, shaders or goldens that the report may show; may be "
                     "repeated");
    command.jobs(run.jobs);
    command.driver(run.driver);
    for (const suite::OptionRow& row : suite::optionTable())
        if (row.withSuite) addPictureOption(command, row.name, run.ofAll);
    addUntrustedOption(command, to.suites.untrusted);
    for (const char* each :
         {"--force", "--variant", "--replace-unreadable", "--any-driver", "--shard", "--resume", "--results",
          "--junit", "--goldens", "--allow-outside", "--merge", "--root", "--driver", "--untrusted"})
        command.find(each).rare();
    command.onRun(
        [arguments, timeout = command.find("--timeout"), results = command.find("--results"), &status] {
            arguments->resultsAreNamed = results.isGiven();
            suite::RunOptions& options = arguments->suites.run;
            if (timeout.isGiven()) options.timeout = options.ofAll.timeout;
            options.memory = options.ofAll.memory;
            arguments->command = commandLine();
            arguments->suites.withNamed = !arguments->updates();
            status = runCommand(*arguments);
        });
}

}  // namespace glibra::cli
