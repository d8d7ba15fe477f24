#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/files.h"
#include "classroom/class_page.h"
#include "classroom/class_run.h"
#include "classroom/grades.h"
#include "classroom/hand_in.h"
#include "classroom/moments.h"
#include "classroom/rubric.h"
#include "classroom/teacher_marks.h"
#include "classroom/unpack.h"
#include "cli/class_input.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/file_access.h"
#include "cli/picture_options.h"
#include "cli/scene_arguments.h"
#include "cli/suite_progress.h"
#include "suite/golden/hash_list.h"
#include "suite/options/option_table.h"
#include "suite/options/option_words.h"
#include "suite/write_below.h"
#include "system/folder.h"
#include "system/interruption.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

/// What is read of the reference and of the submissions.
std::vector<std::string> scenesOf(const classroom::ClassPlan& plan) {
    std::vector<std::string> scenes;
    if (!plan.reference.empty() && plan.pictures.empty()) scenes.push_back(plan.reference.generic_string());
    for (const classroom::Submission& each : plan.submissions.all)
        if (!each.scene.empty()) scenes.push_back(each.scene.generic_string());
    return scenes;
}

/// What confines the workers. Every submission's folder can be read by all workers, but a scene reads only
/// its own, because the file look-up refuses the others.
system::Sandbox drawingSandbox(const classroom::ClassPlan& plan, Driver driver) {
    system::Sandbox sandbox = sandboxOf(scenesOf(plan), plan.moments.front().shot.options, driver);
    sandbox.readable.push_back(plan.folder);
    sandbox.readable.emplace_back(plan.site, fs::path(classroom::kUnpacked));
    sandbox.readable.insert(sandbox.readable.end(), plan.given.begin(), plan.given.end());
    for (const classroom::EarlierClass& each : plan.earlier) sandbox.readable.push_back(each.folder);
    if (!plan.earlier.empty()) sandbox.readable.emplace_back(plan.site, fs::path("earlier"));
    return sandbox;
}

/// What marking has found out.
struct Marked {
    bool knowsTimes = true;  ///< false: the late rule knows of no submission when it came in
    Diagnostics remarks;     ///< about what the teacher has typed
};

/// Gives all marks.
Marked mark(const ClassInput& input, classroom::Classroom& room) {
    bool knowsTimes = input.find.names.book() == classroom::GradeBook::canvas;  // which marks the late ones
    for (std::size_t i = 0; i < room.entries.size(); ++i) {
        classroom::Entry& entry = room.entries[i];
        classroom::HandedIn handedIn;
        handedIn.isLate = entry.submission.isLate;
        if (!entry.submission.time.empty()) handedIn.time = entry.submission.time;
        for (std::size_t student = 0; student < input.handed.size(); ++student) {
            if (input.handed[student] != i) continue;
            const classroom::Student& known = input.roster->students[student];
            // Of a group, the member counts who was given the most time.
            if (known.daysLate)
                handedIn.daysLate = std::min(*known.daysLate, handedIn.daysLate.value_or(*known.daysLate));
            if (!known.status.empty()) handedIn.status = known.status;
            if (known.time) handedIn.time = known.time;
        }
        knowsTimes = knowsTimes || handedIn.daysLate || handedIn.time || handedIn.isLate ||
                     classroom::readMoodleStatus(handedIn.status).daysLate;
        if (input.rubric) classroom::giveMarks(*input.rubric, room, handedIn, entry);
    }
    return {knowsTimes || !input.rubric || !input.rubric->late,
            classroom::applyTeacherMarks(input.own, room)};
}

/// Gives typed points that do not know what they were typed for the last hand-in that the page has shown, and
/// keeps that.
void keepDigests(ClassInput& input, const classroom::Classroom& room) {
    const std::string before = classroom::toText(input.own);
    classroom::addDigests(input.own, room, classroom::readDigests(input.plan.site));
    if (classroom::toText(input.own) != before) classroom::writeTeacherMarks(input.own, input.plan.site);
    classroom::writeDigests(room, input.plan.site);
}

/// Names the students of the roster who handed nothing in, and those that it does not have.
void nameOthers(const ClassInput& input, classroom::Classroom& room) {
    if (!input.roster) return;
    for (std::size_t i = 0; i < input.handed.size(); ++i) {
        const classroom::Student& student = input.roster->students[i];
        if (!input.handed[i]) room.absent.push_back(student.name.empty() ? student.number : student.name);
    }
    for (const classroom::Submission& each : input.plan.submissions.all)
        for (const classroom::Member& member : classroom::membersOf(each))
            if (!classroom::studentOf(*input.roster, member)) room.strangers.push_back(member.name);
}

classroom::ImportOptions importOptions(const ClassArguments& arguments, const ClassInput& input) {
    classroom::ImportOptions import;
    import.book = arguments.book != classroom::GradeBook::none ? arguments.book : input.find.names.book();
    import.assignment = arguments.assignment.empty()
                            ? system::realPath(input.plan.folder).filename().generic_string()
                            : arguments.assignment;
    import.roster = input.roster ? &*input.roster : nullptr;
    import.handed = input.handed;
    return import;
}

/// Says what the grade book may not import as it is meant.
void noteImport(const classroom::ImportOptions& import, const classroom::Classroom& room) {
    for (const std::string& why :
         {classroom::whyNoAssignment(import), classroom::whyOtherMaximum(room, import)})
        if (!why.empty()) printNote(why);
}

/// Writes the page, the table, and what the grade book imports. The exit status; kDone if all is well.
int writeFiles(const ClassArguments& arguments, const ClassInput& input, classroom::Classroom& room) {
    classroom::SiteFiles files;
    files.studentPages = arguments.studentPages;
    files.isAnonymous = arguments.isAnonymous;
    files.import = importOptions(arguments, input);
    return printErrors(classroom::writeSite(room, input.plan.site, files)) ? kSceneIsWrong : kDone;
}

/// The file that most keeps a submission from being drawn: "image.bmp"; empty if it is another reason.
std::string missingFile(const classroom::Entry& entry) {
    const auto first = std::find_if(entry.diagnostics.begin(), entry.diagnostics.end(),
                                    [](const Diagnostic& each) { return each.severity == Severity::error; });
    return first != entry.diagnostics.end() && first->id == "file-E01" ? first->subject : std::string();
}

/// Names what several submissions miss, and where a teacher puts it for all of them.
void reportMissing(const classroom::Classroom& room) {
    std::map<std::string, std::size_t> users;
    for (const classroom::Entry& each : room.entries)
        if (const std::string file = missingFile(each); !file.empty()) ++users[file];
    for (const auto& [file, count] : users) {
        if (count < 2) continue;
        const std::string ending = fs::path(file).extension().generic_string();
        const bool isShader = ending == ".vert" || ending == ".frag" || ending == ".geom" ||
                              ending == ".tcs" || ending == ".tes" || ending == ".comp" || ending == ".glsl";
        printNote(
            fmt::format("{} submissions miss '{}'; if it was given to all, put it into '{}'", count, file,
                        (fs::path(room.folder) / (isShader ? "shaders" : "textures")).generic_string()));
    }
}

/// "3 students are late: ana, bob, cem", with the first names; nothing if there is none.
void reportNames(const char* one, const char* words, std::vector<std::string> names) {
    if (names.empty()) return;
    constexpr std::size_t kMostNames = 6;
    const bool isMore = names.size() > kMostNames;
    const std::string count = base::counted(names.size(), one);
    if (isMore) names.resize(kMostNames);
    printNote(fmt::format("{} {}: {}{}", count, words, fmt::join(names, ", "), isMore ? ", ..." : ""));
}

/// Names what of the earlier submissions cannot be compared.
void reportEarlier(const classroom::Classroom& room) {
    std::vector<std::string> names;
    for (const classroom::Entry& each : room.earlier)
        if (each.submission.scene.empty()) names.push_back(each.submission.name);
    reportNames("earlier submission", "without a scene cannot be compared", std::move(names));
}

/// Says which fields nobody has typed points into yet.
void reportOpen(const classroom::Classroom& room) {
    std::map<std::string, std::size_t> open;
    std::size_t all = 0;
    for (const classroom::Entry& entry : room.entries)
        for (const classroom::Mark& each : entry.marks)
            if (each.isOpen && !each.isBonus) {
                ++open[each.check];
                ++all;
            }
    if (all == 0) return;
    std::string checks;
    for (const auto& [check, count] : open)
        checks += fmt::format("{}'{}' of {}", checks.empty() ? "" : ", ", check, count);
    printNote(
        fmt::format("{} not yet marked by hand: {}; submissions with such fields have no grade to import",
                    all == 1 ? "1 field is" : fmt::format("{} fields are", all), checks));
}

/// Says that a check of likeness cannot tell an effect from the rest of a picture.
void noteWholePictures(const ClassInput& input, const classroom::Classroom& room) {
    if (!input.rubric || room.moments.size() > 1) return;
    for (const classroom::Check& each : input.rubric->checks)
        if (each.kind == classroom::Check::Kind::like)
            return printNote(
                fmt::format("the check '{}' compares whole pictures, because there is one of each "
                            "submission; with --sweep or --time it also compares what changes",
                            each.name));
}

void report(const classroom::Classroom& room, const fs::path& site) {
    for (const classroom::Entry& each : room.entries)
        if (classroom::stateOf(each) != "drawn")
            printLine(fmt::format("{}: {}: {}", each.submission.name, classroom::stateOf(each),
                                  classroom::reasonOf(each)));
    reportMissing(room);
    reportEarlier(room);
    reportNames("student", "not in the roster", room.strangers);
    reportOpen(room);
    for (const classroom::Entry& each : room.entries)
        if (const Diagnostics hint = libraryHint(each.submission.scene, each.diagnostics); !hint.empty()) {
            print(hint);
            break;
        }
    printLine(classroom::summary(room));
    printLine("page: " + (site / "index.html").generic_string());
}

/// file-E13 for each file of the page and of --results that is read.
Diagnostics overwritten(const ClassArguments& arguments, const ClassInput& input,
                        const base::WorkerOptions& workers) {
    const classroom::ClassPlan& plan = input.plan;
    RenderOptions options = plan.moments.front().shot.options;
    options.libraryRoots.insert(options.libraryRoots.end(), plan.given.begin(), plan.given.end());
    ReadFiles read;
    if (!arguments.results.empty()) read = filesReadBy(scenesOf(plan), std::nullopt, options, workers);
    read.add(plan.folder, "it is handed in");
    read.add(rubricFile(arguments), "it is the rubric");
    read.add(arguments.roster, "it is the roster");
    read.add(arguments.reference, "it is the reference");
    read.add(fs::path(arguments.reference) / classroom::kReferenceFile, "it is of the reference");
    for (const fs::path& each : plan.pictures) read.add(each, "it is of the reference");
    Diagnostics problems;
    for (const auto& [format, file] : arguments.results)
        append(problems, read.overwrittenBy(file, "--results"));
    const std::string table = classroom::importFile(importOptions(arguments, input).book);
    for (const char* each : {"index.html", "grades.csv", "names.csv", table.c_str()})
        append(problems, read.overwrittenBy(plan.site / each, "-o"));
    return problems;
}

/// Prints what the checks say about the one submission, and writes it for platforms. The exit status.
int reportOwn(const ClassArguments& arguments, const ClassInput& input, const classroom::Classroom& room) {
    const classroom::Entry& own = room.entries.front();
    print(own.diagnostics);
    if (const std::string why = classroom::reasonOf(own); !why.empty() && own.diagnostics.empty())
        printNote(why);
    for (const std::string& each : classroom::resultLines(*input.rubric, room)) printLine(each);
    for (const auto& [format, file] : arguments.results) {
        const std::string text = classroom::resultText(format, *input.rubric, room);
        const fs::path path(file);
        if (printErrors(suite::writeBelow(path.has_parent_path() ? path.parent_path() : fs::path("."),
                                          path.filename(), std::as_bytes(std::span(text)))))
            return kSceneIsWrong;
    }
    printLine("page: " + (input.plan.site / "index.html").generic_string());
    return classroom::reachesAll(room) ? kDone : kDiffers;
}

constexpr const char* kDrawn = ".drawn";

/// Why the folder of --hand-out is not written; empty if it may be.
std::string whyNotHandedOut(const fs::path& folder) {
    std::error_code failure;
    if (!fs::exists(folder, failure) || classroom::hasReferencePictures(folder)) return {};
    if (!fs::is_directory(folder, failure)) return "it is no folder";
    // What was drawn before a run was stopped, or, where a worker is the program started again, in this run.
    const auto isOther = [](const fs::directory_entry& each) { return each.path().filename() != kDrawn; };
    return std::ranges::none_of(base::entriesOf(folder), isOther)
               ? ""
               : "it has other files; name a new or empty folder";
}

/// Draws the reference alone, for students. The exit status.
int handOut(const ClassArguments& given) {
    ClassArguments arguments = given;
    const fs::path folder = arguments.handOut;
    if (!arguments.folder.empty())
        return refuse("--hand-out draws the reference alone; leave out the folder of the submissions");
    if (arguments.reference.empty()) return refuse("--hand-out needs --reference");
    if (const std::string why = whyNotHandedOut(folder); !why.empty())
        return refuse(fmt::format("--hand-out {}: {}", arguments.handOut, why));
    arguments.made.site = (folder / kDrawn).generic_string();
    ClassInput input;
    if (const int status = readInput(arguments, input); status != kDone) return status;
    if (!input.plan.pictures.empty()) return refuse("--hand-out draws the scene of --reference");
    Confinement confined;
    if (arguments.made.untrusted)
        confined = confinement(drawingSandbox(input.plan, arguments.made.driver), input.plan.site);
    const system::Interruption interruption;
    classroom::ClassEvents events;
    events.stop = [&] { return interruption.signal() != 0; };
    const classroom::ClassEnd end =
        classroom::runClass(input.plan, siteWorkers(arguments.made, confined), events);
    print(end.diagnostics);
    const bool isDrawn = !end.noDriver && !end.stopped && !end.misspelt && !hasError(end.diagnostics);
    Diagnostics problems;
    if (isDrawn) problems = classroom::writeReferencePictures(end.classroom, input.plan.site, folder);
    if (isDrawn && problems.empty() && !input.rubricText.empty())
        problems = suite::writeBelow(folder, classroom::kReferenceRubric,
                                     std::as_bytes(std::span(input.rubricText)));
    std::error_code stays;
    fs::remove_all(input.plan.site, stays);
    if (!isDrawn) fs::remove(folder, stays);  // unless something was there before
    if (end.stopped) interruption.obey();
    if (end.noDriver) return kNoDriver;
    if (end.misspelt) return kWrongUsage;
    if (printErrors(problems) || !isDrawn) return kSceneIsWrong;
    printLine(fmt::format("{}: {} of '{}'{}; students run: glibra class . --mine --reference {}",
                          folder.generic_string(), base::counted(input.plan.moments.size(), "picture"),
                          input.plan.reference.filename().generic_string(),
                          input.rubricText.empty() ? " without a rubric" : " and the rubric",
                          suite::shellWord(folder.filename().generic_string())));
    return kDone;
}

int runClassCommand(const ClassArguments& arguments, const std::string& command) {
    if (arguments.made.untrusted && !prepareUntrusted()) return kNoDriver;
    if (!arguments.handOut.empty()) return handOut(arguments);
    if (arguments.folder.empty()) return refuse("SUBMISSIONS is missing");
    if (!arguments.results.empty() && !arguments.isOwn) return refuse("--results needs --mine");
    ClassInput input;
    if (const int status = readInput(arguments, input); status != kDone) return status;
    const system::Interruption interruption;
    if (const int status = unpack(arguments, input, interruption); status != kDone) return status;
    const classroom::ClassPlan& plan = input.plan;
    Confinement confined;
    if (arguments.made.untrusted)
        confined = confinement(drawingSandbox(plan, arguments.made.driver), plan.site);
    const suite::SiteWorkers workers = siteWorkers(arguments.made, confined);
    const auto stop = [&] { return interruption.signal() != 0; };
    if (printErrors(overwritten(arguments, input, suite::readingOptions(workers, 1, stop))))
        return kSceneIsWrong;

    const auto start = std::chrono::steady_clock::now();
    SuiteProgress progress(classroom::pictureCount(plan), system::isTerminal(system::Standard::error));
    classroom::ClassEvents events;
    events.begins = [&](const std::string& submission) { progress.begins(submission); };
    events.done = [&](bool failed) { progress.add(failed); };
    events.stop = stop;
    classroom::ClassEnd end = classroom::runClass(plan, workers, events);
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
    nameOthers(input, room);
    if (!arguments.isOwn) keepDigests(input, room);
    const Marked marked = mark(input, room);
    print(marked.remarks);
    noteWholePictures(input, room);
    if (!marked.knowsTimes && !arguments.isOwn)
        printNote(
            "the late rule takes nothing, because nothing says when the submissions came in; a "
            "roster "
            "says it in a column 'submitted' or 'days late'");
    noteImport(importOptions(arguments, input), room);
    if (const int status = writeFiles(arguments, input, room); status != kDone) return status;
    if (arguments.isOwn) return reportOwn(arguments, input, room);
    report(room, plan.site);
    if (arguments.serves) {
        const int status = serveClass({.room = room,
                                       .own = input.own,
                                       .site = plan.site,
                                       .isAnonymous = arguments.isAnonymous,
                                       .mark = [&] { mark(input, room); },
                                       .write = [&] { return writeFiles(arguments, input, room) == kDone; },
                                       .stop = stop});
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

void addOwnOptions(CommandLine& command, ClassArguments& to) {
    command.flag(
        "--mine", to.isOwn,
        "SUBMISSIONS is one submission: says what its automatic checks give; the exit status is 1 if "
        "points are missing");
    using classroom::ResultFormat;
    static constexpr std::pair<std::string_view, ResultFormat> kFormats[] = {
        {"gradescope", ResultFormat::gradescope},
        {"submitty", ResultFormat::submitty},
        {"github", ResultFormat::github}};
    command
        .repeated(
            "--results",
            [&to](const std::string& text) -> std::string {
                const std::size_t equals = std::min(text.find('='), text.size());
                for (const auto& [word, format] : kFormats) {
                    if (text.substr(0, equals) != word || equals + 1 >= text.size()) continue;
                    const std::string file = text.substr(equals + 1);
                    for (const auto& [other, known] : to.results)
                        if (fs::path(known).lexically_normal() == fs::path(file).lexically_normal())
                            return fmt::format("'{}' is named twice", file);
                    to.results.emplace_back(format, file);
                    return whyNotWritten(file);
                }
                return fmt::format("expected gradescope=FILE, submitty=FILE or github=FILE, found '{}'",
                                   text);
            },
            "with --mine: also writes what Gradescope, Submitty or GitHub Classroom reads, as "
            "'gradescope=results.json'; may be repeated")
        .placeholder("FORMAT=FILE");
    command
        .option("--hand-out", to.handOut,
                "only draws the reference: writes its pictures and the rubric, without its source, for "
                "students to run --mine")
        .written()
        .placeholder("FOLDER");
}

}  // namespace

void addClass(CommandLine& program, int& status) {
    auto arguments = std::make_shared<ClassArguments>();
    CommandLine command = program.subcommand(
        "class", "draws the submissions of a class beside a reference, on one page with scores and a table",
        "glibra class submissions/ --reference solution.glib -o site/   # a page and a table for the grade "
        "book\n"
        "glibra class export/ --names moodle --roster grades.csv        # a learning platform's own names\n"
        "glibra class . --mine --reference reference/                   # a student, before handing in");
    ClassArguments& to = *arguments;
    command.option("SUBMISSIONS", to.folder,
                   "folder with a folder, a zip file or a .glib file per student; or a zip file of all; with "
                   "--mine one of these");
    command.option("--reference", to.reference,
                   "the scene to compare with; or a suite of it or an exercise (.toml), which says what to "
                   "draw; or a folder that --hand-out wrote");
    addOwnOptions(command, to);
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
        .repeated(
            "--earlier", to.earlier,
            "folder of an earlier class (or its zip file), with whose code this one's is compared, too; "
            "may be repeated")
        .placeholder("FOLDER");
    command
        .option("--common", to.common,
                "code that more submissions than this have does not count as similar; by default a third of "
                "the class, at least 4 and at most 10")
        .atLeast(1)
        .rare();
    const suite::OptionRow& time = suite::optionNamed("time");
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
    for (const char* each : {"--scene-of", "--names", "--roster", "--grade-book", "--assignment",
                             "--student-pages", "--serve", "--anonymous", "--common", "--earlier"})
        command.find("--mine").excludes(command.find(each));
    command.find("--mine").excludes(command.find("--hand-out"));
    command.onRun([arguments, site = command.find("--output"), &status] {
        arguments->made.siteIsNamed = site.isGiven();
        status = runClassCommand(*arguments, commandLine());
    });
}

}  // namespace glibra::cli
