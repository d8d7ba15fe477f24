#include "cli/class_input.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstddef>
#include <string_view>
#include <system_error>

#include "base/suggest.h"
#include "classroom/moments.h"
#include "classroom/unpack.h"
#include "cli/commands.h"
#include "cli/file_access.h"
#include "glib/text.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

/// The folder of --reference, if it has pictures in place of a scene.
bool isOfPictures(const ClassArguments& arguments) {
    std::error_code failure;
    return fs::is_directory(arguments.reference, failure);
}

/// The moments of the pictures that --reference names, with what this machine adds to them.
Result<std::vector<classroom::Moment>> momentsOfPictures(const ClassArguments& arguments,
                                                         classroom::ClassPlan& plan) {
    if (!classroom::hasReferencePictures(arguments.reference))
        return withoutId(Severity::error,
                         fmt::format("'{}' is a folder without the pictures of a reference ({}); 'glibra "
                                     "class --reference SCENE --hand-out {}' writes them",
                                     arguments.reference, classroom::kReferenceFile, arguments.reference));
    Result<classroom::ReferencePictures> read = classroom::readReferencePictures(arguments.reference);
    if (!read) return std::move(read.diagnostics);
    plan.reference = read->scene;
    plan.pictures = std::move(read->files);
    for (classroom::Moment& each : read->moments) {
        each.shot.memory = arguments.made.picture.memory;
        each.shot.options.libraryRoots = arguments.made.picture.options.libraryRoots;
    }
    return std::move(read->moments);
}

/// The moments, and the reference's scene or pictures. Without a value, the reason has been printed.
std::optional<std::vector<classroom::Moment>> momentsOf(const ClassArguments& arguments,
                                                        classroom::ClassPlan& plan) {
    const suite::Shot& picture = arguments.made.picture;
    const bool hasPictures = isOfPictures(arguments);
    const bool isSuite = glib::sameWord(fs::path(arguments.reference).extension().generic_string(), ".toml");
    if ((isSuite || hasPictures) && (!arguments.times.empty() || !arguments.sweeps.empty() ||
                                     !picture.options.set.empty() || picture.options.width > 0)) {
        printError(hasPictures
                       ? "--time, --set, --sweep and --size do not go with the pictures that --reference "
                         "names: they say what is drawn"
                       : "--time, --set, --sweep and --size belong into the suite that --reference names");
        return std::nullopt;
    }
    Result<std::vector<classroom::Moment>> moments =
        hasPictures ? momentsOfPictures(arguments, plan)
        : isSuite   ? classroom::momentsOfSuite(arguments.reference)
                    : classroom::momentsOf(picture, arguments.times, arguments.sweeps);
    print(moments.diagnostics);
    if (!moments) return std::nullopt;
    if (!hasPictures) plan.reference = isSuite ? moments->front().shot.script : fs::path(arguments.reference);
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

/// Reads --scene, --scene-of, --names and --roster. The exit status; kDone if all is well.
int readNames(const ClassArguments& arguments, ClassInput& input) {
    input.find.scenes = arguments.scenes;
    for (const std::string& each : arguments.scenesOf) {
        const std::size_t equals = each.rfind('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == each.size())
            return refuse(
                fmt::format("--scene-of '{}': expected STUDENT=PATTERN, as 'ana=final.glib'", each));
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
        input.roster = std::move(*roster);
    }
    return kDone;
}

/// Reads what the teacher has typed, which does not count for one's own submission. The exit status; kDone if
/// all is well.
int readOwnMarks(const ClassArguments& arguments, ClassInput& input) {
    if (arguments.isOwn || !arguments.handOut.empty()) return kDone;
    Result<classroom::TeacherMarks> own = classroom::readTeacherMarks(input.plan.site);
    print(own.diagnostics);
    if (!own) return kSceneIsWrong;
    input.own = std::move(*own);
    return kDone;
}

/// Reads the rubric. The exit status; kDone if all is well.
int readChecks(const ClassArguments& arguments, ClassInput& input) {
    const fs::path file = rubricFile(arguments);
    Result<classroom::Rubric> rubric = classroom::solvedRubric();
    if (!file.empty()) {
        constexpr std::uint64_t kLargestRubric = 1U << 20U;
        const Result<std::string> text = classroom::givenText(file, kLargestRubric);
        print(text.diagnostics);
        if (!text) return kWrongUsage;
        input.rubricText = *text;
        rubric = classroom::readRubricText(*text, file.generic_string());
    } else if (!isOfPictures(arguments) && suite::readExercise(arguments.reference)) {
        input.rubricText = "[[check]]\nsolved = true\n";
    } else {
        if (!arguments.isOwn) return kDone;
        return refuse(
            fmt::format("--mine needs the checks: --rubric FILE, or {} in the folder of --reference",
                        classroom::kReferenceRubric));
    }
    print(rubric.diagnostics);
    if (!rubric) return kWrongUsage;
    if (printErrors(classroom::problemsOf(*rubric, input.plan.moments,
                                          classroom::slidersOf(input.plan.moments),
                                          !input.plan.reference.empty())))
        return kWrongUsage;
    input.rubric = std::move(*rubric);
    return kDone;
}

/// What confines the processes that unpack submissions into a folder of a site; nothing without --untrusted.
std::optional<system::Sandbox> unpackingSandbox(const ClassArguments& arguments, const fs::path& from,
                                                const fs::path& site, std::string_view into) {
    if (!arguments.made.untrusted) return std::nullopt;
    system::Sandbox sandbox;
    sandbox.readable.push_back(from);
    sandbox.writable.emplace_back(site, fs::path(into));
    return sandbox;
}

/// If the submissions are one zip file, as a learning platform exports them, unpacks it to the site, and
/// `from` is then its folder. False: it cannot be.
bool unpackExport(const ClassArguments& arguments, fs::path& from, const fs::path& site) {
    std::error_code failure;
    if (!classroom::isArchive(from) || !fs::is_regular_file(from, failure)) return true;
    const auto sandbox = unpackingSandbox(arguments, from, site, classroom::kExport);
    Result<fs::path> folder =
        classroom::unpackExport(from, {.site = site, .timeout = 0, .sandbox = sandbox ? &*sandbox : nullptr});
    print(folder.diagnostics);
    if (folder) from = std::move(*folder);
    return folder.value.has_value();
}

/// Unpacks zip files of submissions to the site. The exit status; kDone if all is well.
int unpackAll(const ClassArguments& arguments, classroom::Submissions& submissions, const fs::path& from,
              const fs::path& site, const classroom::SubmissionOptions& find,
              const system::Interruption& interruption) {
    const auto sandbox = unpackingSandbox(arguments, from, site, classroom::kUnpacked);
    const Diagnostics problems =
        classroom::unpackSubmissions(submissions, find,
                                     {.site = site,
                                      .timeout = arguments.made.timeout,
                                      .sandbox = sandbox ? &*sandbox : nullptr,
                                      .stop = [&] { return interruption.signal() != 0; }});
    return printErrors(problems) ? kSceneIsWrong : kDone;
}

/// Where zip files of the earlier folder of this number are unpacked.
fs::path earlierSite(const classroom::ClassPlan& plan, std::size_t number) {
    return plan.site / "earlier" / std::to_string(number + 1);
}

/// Finds the submissions of --earlier. The exit status; kDone if all is well.
int findEarlier(const ClassArguments& arguments, ClassInput& input) {
    classroom::SubmissionOptions find = input.find;
    find.sceneOf.clear();
    std::size_t count = 0;
    for (const std::string& each : arguments.earlier) {
        fs::path folder = each;
        if (std::error_code failure; fs::equivalent(folder, arguments.folder, failure))
            return refuse(fmt::format("--earlier {}: these are the submissions themselves", each));
        if (!unpackExport(arguments, folder, earlierSite(input.plan, input.plan.earlier.size())))
            return kWrongUsage;
        Result<classroom::Submissions> found = classroom::findSubmissions(folder, find);
        print(found.diagnostics);
        if (!found) return kWrongUsage;
        count += found->all.size();
        if (count > 2 * classroom::kMostSubmissions)
            return refuse(fmt::format("--earlier: there are more than {} earlier submissions",
                                      2 * classroom::kMostSubmissions));
        const fs::path named = fs::path(each).has_filename() ? fs::path(each) : fs::path(each).parent_path();
        input.plan.earlier.push_back({named.stem().generic_string(), std::move(folder), std::move(*found)});
    }
    return kDone;
}

/// "; did you mean 'Bob Ng'?", or nothing.
std::string nearestStudent(const std::string& student, const classroom::Submissions& found) {
    std::vector<std::string> names;
    for (const classroom::Submission& each : found.all)
        for (std::string& name : classroom::identitiesOf(each)) names.push_back(std::move(name));
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    return base::suggestion(student, candidates);
}

/// Gives the roster's patterns, and those whose student only the roster calls so, to the submissions
/// themselves, in input.find.sceneOf. The exit status; kWrongUsage if nobody is called so.
int useNamesOfRoster(const std::vector<std::string>& scenesOf, const classroom::Submissions& found,
                     ClassInput& input) {
    const classroom::Roster* roster = input.roster ? &*input.roster : nullptr;
    for (const std::string& each : scenesOf) {
        const std::size_t equals = each.rfind('=');
        const std::string student = each.substr(0, equals);
        const auto index = classroom::submissionOf(found, roster, student);
        if (index) {
            const std::vector<std::string> names = classroom::identitiesOf(found.all[*index]);
            if (std::find(names.begin(), names.end(), student) == names.end())
                input.find.sceneOf.try_emplace(found.all[*index].name, each.substr(equals + 1));
        } else if (!roster || !classroom::studentOf(*roster, {student, student, student})) {
            // Of a student of the roster, the page says that nothing was handed in.
            return refuse(fmt::format("--scene-of '{}': nobody is called '{}'{}", each, student,
                                      nearestStudent(student, found)));
        }
    }
    if (!roster) return kDone;
    for (const classroom::Submission& each : found.all) {
        const std::vector<std::string> names = classroom::identitiesOf(each);
        const auto hasPattern = [&](const std::string& name) { return input.find.sceneOf.contains(name); };
        if (std::any_of(names.begin(), names.end(), hasPattern)) continue;
        for (const classroom::Member& member : classroom::membersOf(each))
            if (const auto student = classroom::studentOf(*roster, member);
                student && !roster->students[*student].scene.empty())
                input.find.sceneOf.try_emplace(each.name, roster->students[*student].scene);
    }
    return kDone;
}

/// Finds the submissions. The exit status; kDone if all is well.
int findAll(const ClassArguments& arguments, ClassInput& input) {
    const auto find = arguments.isOwn ? classroom::ownSubmission : classroom::findSubmissions;
    Result<classroom::Submissions> found = find(input.plan.folder, input.find);
    print(found.diagnostics);
    if (!found) return kWrongUsage;
    const std::size_t patterns = input.find.sceneOf.size();
    if (const int status = useNamesOfRoster(arguments.scenesOf, *found, input); status != kDone)
        return status;
    if (input.find.sceneOf.size() > patterns) found = find(input.plan.folder, input.find);
    if (!found) return kWrongUsage;
    input.plan.submissions = std::move(*found);
    return kDone;
}

}  // namespace

fs::path rubricFile(const ClassArguments& arguments) {
    if (!arguments.rubric.empty() || !isOfPictures(arguments)) return arguments.rubric;
    const fs::path beside = fs::path(arguments.reference) / classroom::kReferenceRubric;
    std::error_code failure;
    return fs::exists(beside, failure) ? beside : fs::path();
}

int readInput(const ClassArguments& arguments, ClassInput& input) {
    classroom::ClassPlan& plan = input.plan;
    plan.folder = arguments.folder;
    plan.site = arguments.made.site;
    plan.common = static_cast<std::size_t>(arguments.common);
    plan.studentPages = arguments.studentPages;
    plan.given.assign(arguments.templates.begin(), arguments.templates.end());
    for (const fs::path& each : plan.given)
        if (std::error_code failure; !fs::exists(each, failure))
            return refuse(fmt::format("there is no template '{}'", each.generic_string()));
    if (std::error_code failure; fs::equivalent(plan.site, plan.folder, failure))
        return refuse(fmt::format(
            "-o {}: this is the folder of the submissions, among which the page would count; name "
            "another one",
            arguments.made.site));
    if (!mayWriteSite(arguments.made)) return kSceneIsWrong;
    std::optional<std::vector<classroom::Moment>> moments = momentsOf(arguments, plan);
    if (!moments) return kWrongUsage;
    plan.moments = std::move(*moments);
    if (const int status = readNames(arguments, input); status != kDone) return status;
    if (const int status = readOwnMarks(arguments, input); status != kDone) return status;
    if (const int status = readChecks(arguments, input); status != kDone) return status;
    if (!arguments.handOut.empty()) return kDone;
    input.find.reference = plan.reference;
    input.find.others = plan.given;
    input.find.others.emplace_back(plan.site);
    input.find.others.emplace_back(arguments.roster);
    input.find.others.emplace_back(arguments.rubric);
    if (!plan.pictures.empty()) {
        input.find.others.emplace_back(arguments.reference);
    } else if (!plan.reference.empty()) {
        input.find.others.emplace_back(plan.reference.has_parent_path() ? plan.reference.parent_path()
                                                                        : fs::path("."));
        input.find.others.emplace_back(arguments.reference);
    }
    if (!arguments.isOwn && !unpackExport(arguments, plan.folder, plan.site)) return kWrongUsage;
    // An earlier folder may lie beside this year's.
    for (const std::string& each : arguments.earlier) input.find.others.emplace_back(each);
    if (const int status = findAll(arguments, input); status != kDone) return status;
    return findEarlier(arguments, input);
}

int unpack(const ClassArguments& arguments, ClassInput& input, const system::Interruption& interruption) {
    classroom::ClassPlan& plan = input.plan;
    if (const int status =
            unpackAll(arguments, plan.submissions, plan.folder, plan.site, input.find, interruption);
        status != kDone)
        return status;
    for (std::size_t i = 0; i < plan.earlier.size(); ++i) {
        auto& [name, folder, submissions] = plan.earlier[i];
        if (const int status =
                unpackAll(arguments, submissions, folder, earlierSite(plan, i), input.find, interruption);
            status != kDone)
            return status;
    }
    if (input.roster) input.handed = classroom::applyRoster(*input.roster, input.plan.submissions);
    return kDone;
}

}  // namespace glibra::cli
