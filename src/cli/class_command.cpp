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
#include "classroom/archive.h"
#include "classroom/class_page.h"
#include "classroom/class_run.h"
#include "classroom/hand_in_time.h"
#include "classroom/import_table.h"
#include "classroom/moments.h"
#include "classroom/roster.h"
#include "classroom/rubric.h"
#include "classroom/submissions.h"
#include "cli/class_serve.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/interruption.h"
#include "cli/library_hint.h"
#include "cli/run_facts.h"
#include "cli/site_options.h"
#include "cli/suite_progress.h"
#include "cli/untrusted.h"
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
    std::vector<std::string> scenes, scenesOf;
    std::string names, roster, assignment, rubric;
    classroom::GradeBook book = classroom::GradeBook::none;
    std::vector<std::string> templates;
    int common = 0;
    bool studentPages = false, isAnonymous = false, serves = false;
    std::vector<double> times;
    std::vector<std::string> sweeps;
    SiteOptions made{.site = "glibra-class"};
};

/// What is found out before anything is drawn.
struct ClassInput {
    classroom::ClassPlan plan;
    classroom::SubmissionOptions find;
    std::optional<classroom::Roster> roster;
    std::vector<std::optional<std::size_t>> handed;  ///< of the students of the roster
    std::optional<classroom::Rubric> rubric;
    classroom::TeacherMarks own;
};

/// The moments, and the reference's scene. Without a value, the reason has been printed.
std::optional<std::vector<classroom::Moment>> momentsOf(const ClassArguments& arguments,
                                                        fs::path& reference) {
    const suite::Shot& picture = arguments.made.picture;
    const bool isSuite = glib::sameWord(fs::path(arguments.reference).extension().string(), ".toml");
    if (isSuite && (!arguments.times.empty() || !arguments.sweeps.empty() || !picture.options.set.empty() ||
                    picture.options.width > 0)) {
        printError("--time, --set, --sweep and --size belong into the suite that --reference names");
        return std::nullopt;
    }
    Result<std::vector<classroom::Moment>> moments =
        isSuite ? classroom::momentsOfSuite(arguments.reference)
                : classroom::momentsOf(picture, arguments.times, arguments.sweeps);
    print(moments.diagnostics);
    if (!moments) return std::nullopt;
    reference = isSuite ? moments->front().shot.script : fs::path(arguments.reference);
    for (classroom::Moment& each : *moments) {
        std::vector<fs::path>& roots = each.shot.options.libraryRoots;
        if (isSuite) {
            const std::vector<fs::path>& named = picture.options.libraryRoots;
            roots.insert(roots.end(), named.begin(), named.end());
        }
        for (fs::path& root : libraryRoots()) roots.push_back(std::move(root));
    }
    return std::move(*moments.value);
}

/// What confines the workers. Every submission's folder can be read by all workers, but a scene reads only
/// its own, because the file look-up refuses the others.
base::Sandbox drawingSandbox(const classroom::ClassPlan& plan, Driver driver) {
    std::vector<std::string> scenes;
    if (!plan.reference.empty()) scenes.push_back(plan.reference.string());
    for (const classroom::Submission& each : plan.submissions.all)
        if (!each.scene.empty()) scenes.push_back(each.scene.string());
    base::Sandbox sandbox = sandboxOf(scenes, plan.moments.front().shot.options, driver);
    sandbox.readable.push_back(plan.folder);
    sandbox.readable.emplace_back(plan.site, fs::path(classroom::kUnpacked));
    sandbox.readable.insert(sandbox.readable.end(), plan.given.begin(), plan.given.end());
    return sandbox;
}

/// Reads --scene, --scene-of, --names and --roster. The exit status; kDone if all is well.
int readNames(const ClassArguments& arguments, ClassInput& input) {
    input.find.scenes = arguments.scenes;
    for (const std::string& each : arguments.scenesOf) {
        const std::size_t equals = each.rfind('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == each.size()) {
            printError(fmt::format("--scene-of '{}': expected STUDENT=PATTERN, as 'ana=final.glib'", each));
            return kWrongUsage;
        }
        input.find.sceneOf[each.substr(0, equals)] = each.substr(equals + 1);
    }
    if (!arguments.names.empty()) {
        Result<classroom::NameRule> rule = classroom::NameRule::of(arguments.names);
        print(rule.diagnostics);
        if (!rule) return kWrongUsage;
        input.find.names = std::move(*rule);
    }
    if (!arguments.roster.empty()) {
        Result<classroom::Roster> roster = classroom::readRoster(arguments.roster);
        print(roster.diagnostics);
        if (!roster) return kWrongUsage;
        for (const classroom::Student& each : roster->students)
            if (!each.scene.empty())
                input.find.sceneOf.try_emplace(each.number.empty() ? each.name : each.number, each.scene);
        input.roster = std::move(*roster);
    }
    return kDone;
}

/// Reads --rubric, and what the teacher has typed. The exit status; kDone if all is well.
int readChecks(const ClassArguments& arguments, ClassInput& input) {
    Result<classroom::TeacherMarks> own = classroom::readTeacherMarks(input.plan.site);
    print(own.diagnostics);
    if (!own) return kSceneIsWrong;
    input.own = std::move(*own);
    if (arguments.rubric.empty()) return kDone;
    Result<classroom::Rubric> rubric = classroom::readRubric(arguments.rubric);
    print(rubric.diagnostics);
    if (!rubric) return kWrongUsage;
    const Diagnostics problems = classroom::problemsOf(
        *rubric, input.plan.moments, classroom::slidersOf(input.plan.moments), !input.plan.reference.empty());
    print(problems);
    if (hasError(problems)) return kWrongUsage;
    input.rubric = std::move(*rubric);
    return kDone;
}

/// Gives all marks. False if the late rule knows of no submission when it came in.
bool mark(const ClassInput& input, classroom::Classroom& room) {
    bool knowsTimes = input.find.names.book() == classroom::GradeBook::canvas;  // which marks the late ones
    for (std::size_t i = 0; i < room.entries.size(); ++i) {
        classroom::Entry& entry = room.entries[i];
        classroom::HandedIn handedIn;
        handedIn.isLate = entry.submission.isLate;
        if (!entry.submission.time.empty()) handedIn.time = entry.submission.time;
        for (std::size_t student = 0; student < input.handed.size(); ++student) {
            if (input.handed[student] != i) continue;
            const classroom::Student& known = input.roster->students[student];
            handedIn.daysLate = known.daysLate;
            handedIn.status = known.status;
            if (known.time) handedIn.time = known.time;
        }
        knowsTimes = knowsTimes || handedIn.daysLate || handedIn.time || handedIn.isLate ||
                     classroom::readMoodleStatus(handedIn.status).daysLate;
        if (input.rubric) classroom::giveMarks(*input.rubric, room, handedIn, entry);
        classroom::applyTeacherMarks(input.own, entry);
    }
    return knowsTimes || !input.rubric || !input.rubric->late;
}

/// If the submissions are one zip file, as a learning platform exports them, unpacks it. False: it cannot be.
bool unpackExport(const ClassArguments& arguments, classroom::ClassPlan& plan) {
    std::error_code failure;
    if (!classroom::isArchive(plan.folder) || !fs::is_regular_file(plan.folder, failure)) return true;
    std::optional<base::Sandbox> sandbox;
    if (arguments.made.untrusted) {
        sandbox.emplace();
        sandbox->readable.push_back(plan.folder);
        sandbox->writable.emplace_back(plan.site, fs::path(classroom::kExport));
    }
    Result<fs::path> folder = classroom::unpackExport(
        plan.folder, {.site = plan.site, .jobs = 1, .timeout = 0, .sandbox = sandbox ? &*sandbox : nullptr});
    print(folder.diagnostics);
    if (folder) plan.folder = std::move(*folder);
    return folder.value.has_value();
}

/// Finds out what is to be drawn. The exit status; kDone if all is well.
int readInput(const ClassArguments& arguments, ClassInput& input) {
    classroom::ClassPlan& plan = input.plan;
    plan.folder = arguments.folder;
    plan.site = arguments.made.site;
    plan.common = static_cast<std::size_t>(arguments.common);
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
            arguments.made.site));
        return kWrongUsage;
    }
    if (!mayWriteSite(arguments.made)) return kSceneIsWrong;
    std::optional<std::vector<classroom::Moment>> moments = momentsOf(arguments, plan.reference);
    if (!moments) return kWrongUsage;
    plan.moments = std::move(*moments);
    if (const int status = readNames(arguments, input); status != kDone) return status;
    if (const int status = readChecks(arguments, input); status != kDone) return status;
    input.find.reference = plan.reference;
    input.find.others = plan.given;
    input.find.others.emplace_back(plan.site);
    input.find.others.emplace_back(arguments.roster);
    input.find.others.emplace_back(arguments.rubric);
    if (!plan.reference.empty()) {
        input.find.others.emplace_back(plan.reference.has_parent_path() ? plan.reference.parent_path()
                                                                        : fs::path("."));
        input.find.others.emplace_back(arguments.reference);
    }
    if (!unpackExport(arguments, plan)) return kWrongUsage;
    Result<classroom::Submissions> found = classroom::findSubmissions(plan.folder, input.find);
    print(found.diagnostics);
    if (!found) return kWrongUsage;
    plan.submissions = std::move(*found);
    return kDone;
}

/// Unpacks zip files and gives the students the names of the roster. The exit status; kDone if all is well.
int unpack(const ClassArguments& arguments, ClassInput& input, const Interruption& interruption) {
    std::optional<base::Sandbox> sandbox;
    if (arguments.made.untrusted) {
        sandbox.emplace();
        sandbox->readable.push_back(input.plan.folder);
        sandbox->writable.emplace_back(input.plan.site, fs::path(classroom::kUnpacked));
    }
    const Diagnostics problems =
        classroom::unpackSubmissions(input.plan.submissions, input.find,
                                     {.site = input.plan.site,
                                      .jobs = arguments.made.jobs,
                                      .timeout = arguments.made.timeout,
                                      .sandbox = sandbox ? &*sandbox : nullptr,
                                      .stop = [&] { return interruption.signal() != 0; }});
    print(problems);
    if (hasError(problems)) return kSceneIsWrong;
    if (input.roster) input.handed = classroom::applyRoster(*input.roster, input.plan.submissions);
    return kDone;
}

void nameAbsent(const ClassInput& input, classroom::Classroom& room) {
    for (std::size_t i = 0; i < input.handed.size(); ++i) {
        const classroom::Student& student = input.roster->students[i];
        if (!input.handed[i]) room.absent.push_back(student.name.empty() ? student.number : student.name);
    }
}

/// Writes the page, the table, and what the grade book imports. The exit status; kDone if all is well.
int writeFiles(const ClassArguments& arguments, const ClassInput& input, classroom::Classroom& room) {
    const classroom::GradeBook book =
        arguments.book != classroom::GradeBook::none ? arguments.book : input.find.names.book();
    classroom::SiteFiles files;
    files.studentPages = arguments.studentPages;
    files.isAnonymous = arguments.isAnonymous;
    files.import.book = book;
    files.import.assignment = arguments.assignment.empty()
                                  ? fs::weakly_canonical(input.plan.folder).filename().string()
                                  : arguments.assignment;
    files.import.roster = input.roster ? &*input.roster : nullptr;
    files.import.handed = input.handed;
    if (const std::string why = classroom::whyNoAssignment(files.import); !why.empty())
        printLine(base::printableText("glibra: note: " + why));
    const Diagnostics problems = classroom::writeSite(room, input.plan.site, files);
    print(problems);
    return hasError(problems) ? kSceneIsWrong : kDone;
}

void report(const classroom::Classroom& room, const fs::path& site) {
    for (const classroom::Entry& each : room.entries)
        if (classroom::stateOf(each) != "drawn")
            printLine(base::printableText(fmt::format("{}: {}: {}", each.submission.name,
                                                      classroom::stateOf(each), classroom::reasonOf(each))));
    for (const classroom::Entry& each : room.entries)
        if (const Diagnostics hint = libraryHint(each.submission.scene, each.diagnostics); !hint.empty()) {
            print(hint);
            break;
        }
    printLine(classroom::summary(room));
    printLine("page: " + (site / "index.html").string());
}

int runClassCommand(const ClassArguments& arguments, const std::string& command) {
    if (arguments.made.untrusted && !prepareUntrusted()) return kNoDriver;
    ClassInput input;
    if (const int status = readInput(arguments, input); status != kDone) return status;
    const Interruption interruption;
    if (const int status = unpack(arguments, input, interruption); status != kDone) return status;
    const classroom::ClassPlan& plan = input.plan;
    Confinement confined;
    if (arguments.made.untrusted)
        confined = confinement(drawingSandbox(plan, arguments.made.driver), plan.site);
    classroom::ClassOptions options;
    options.driver = arguments.made.driver;
    options.jobs = arguments.made.jobs;
    options.timeout = arguments.made.timeout;
    options.memory = arguments.made.picture.memory;
    options.drawing = confined.forDrawing();
    options.reading = confined.forReading();

    const auto start = std::chrono::steady_clock::now();
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
    if (end.misspelt) return kWrongUsage;
    if (end.stopped || hasError(end.diagnostics)) return kSceneIsWrong;

    classroom::Classroom& room = end.classroom;
    room.machine = suite::describeMachine();
    room.command = command;
    room.began = utcNow();
    room.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    nameAbsent(input, room);
    if (!mark(input, room))
        printLine(
            "glibra: note: the late rule takes nothing, because nothing says when the submissions came in; a roster "
            "says it in a column 'submitted' or 'days late'");
    if (const int status = writeFiles(arguments, input, room); status != kDone) return status;
    report(room, plan.site);
    if (arguments.serves) {
        const int status = serveClass({.room = room,
                                       .own = input.own,
                                       .site = plan.site,
                                       .isAnonymous = arguments.isAnonymous,
                                       .mark = [&] { mark(input, room); },
                                       .write = [&] { return writeFiles(arguments, input, room) == kDone; },
                                       .stop = [&] { return interruption.signal() != 0; }});
        if (status != kDone) return status;
    }
    const std::vector<classroom::Submission>& all = plan.submissions.all;
    const bool isWhole = std::none_of(all.begin(), all.end(),
                                      [](const classroom::Submission& each) { return each.isUnlisted; });
    return isWhole ? kDone : kSceneIsWrong;
}

void addNameOptions(CommandLine& command, ClassArguments& to) {
    command.repeated("--scene", to.scenes,
                     "the scene where a folder has several, as 'project2.glib' or 'src/*.glib'; may be "
                     "repeated, the first that fits decides");
    command
        .repeated("--scene-of", to.scenesOf, "the scene of one student, as 'ana=final.glib'; may be repeated")
        .placeholder("STUDENT=PATTERN");
    command
        .option("--names", to.names,
                "splits names of files and folders into student and number: moodle, canvas, gradescope, or a "
                "regular expression with a group for each, as '(.*)_([0-9]+)'")
        .placeholder("RULE");
    command
        .option("--roster", to.roster, "list of the class (.csv), which gives names, numbers and addresses")
        .existingFile();
    using classroom::GradeBook;
    command.choice(
        "--grade-book", to.book,
        std::initializer_list<std::pair<const char*, GradeBook>>{{"moodle", GradeBook::moodle},
                                                                 {"canvas", GradeBook::canvas},
                                                                 {"gradescope", GradeBook::gradescope}},
        "also writes the table that it imports; by default that of --names");
    command.option("--assignment", to.assignment,
                   "column of Canvas that gets the points; by default the folder's name");
}

}  // namespace

void addClass(CommandLine& program, int& status) {
    auto arguments = std::make_shared<ClassArguments>();
    CommandLine command = program.subcommand(
        "class", "draws the submissions of a class beside a reference, on one page with scores and a table",
        "glibra class submissions/ --reference solution.glib -o site/   # a page and a table for the grade "
        "book\n"
        "glibra class submissions/ --reference solution.glib --time 0 --time 2.5 --untrusted\n"
        "glibra class export/ --names moodle --roster grades.csv        # a learning platform's own names");
    ClassArguments& to = *arguments;
    command.option("SUBMISSIONS", to.folder, "folder with a folder, a zip file or a .glib file per student; or a zip file of all")
        .required();
    command.option(
        "--reference", to.reference,
        "the scene to compare with; or a suite of it or an exercise (.toml), which says what to draw");
    command
        .option("--rubric", to.rubric,
                "checks with points for the table and the page (.toml); see the page 'A class'")
        .existingFile();
    addNameOptions(command, to);
    command.flag("--student-pages", to.studentPages,
                 "also writes a page for each student, to send back, without the others");
    command.flag(
        "--serve", to.serves,
        "then serves the page on this machine alone, so that points and comments can be typed on it; "
        "Ctrl-C ends it");
    command.flag("--anonymous", to.isAnonymous, "the page has numbers for names; names.csv says which");
    command.repeated(
        "--template", to.templates,
        "file or folder of code that was given to all; it does not count as similar; may be repeated");
    command
        .option("--common", to.common,
                "code that more submissions than this have does not count as similar; by default a third of "
                "the class, at least 4 and at most 10")
        .atLeast(1)
        .rare();
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
    addSiteOptions(command, to.made, "folder for index.html, grades.csv and the pictures",
                   {"set", "size", "samples", "strict", "library", "memory"});
    command.onRun([arguments, site = command.find("--output"), &status] {
        arguments->made.siteIsNamed = site.isGiven();
        status = runClassCommand(*arguments, commandLine());
    });
}

}  // namespace glibra::cli
