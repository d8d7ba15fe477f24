#pragma once
// What `glibra class` is asked for, and what is found out before anything is drawn.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "classroom/class_run.h"
#include "classroom/classroom.h"
#include "classroom/grades.h"
#include "classroom/names.h"
#include "classroom/roster.h"
#include "classroom/rubric.h"
#include "classroom/submissions.h"
#include "classroom/teacher_marks.h"
#include "cli/picture_options.h"
#include "system/interruption.h"

namespace glibra::cli {

struct ClassArguments {
    std::string folder;
    std::string reference;
    std::vector<std::string> scenes, scenesOf;
    std::string names, roster, assignment, rubric;
    classroom::GradeBook book = classroom::GradeBook::none;
    std::vector<std::string> templates, earlier;
    int common = 0;
    bool studentPages = false, isAnonymous = false, serves = false;
    bool isOwn = false;   ///< --mine: SUBMISSIONS is one submission
    std::string handOut;  ///< a folder for the reference's pictures; empty: the class is drawn
    std::vector<std::pair<classroom::ResultFormat, std::string>> results;  ///< with their files
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
    std::string rubricText;  ///< that it was read from
    classroom::TeacherMarks own;
};

/// The file of --rubric, or the one that was handed out with the pictures of the reference; empty if there is
/// none.
std::filesystem::path rubricFile(const ClassArguments& arguments);
/// Finds out what is to be drawn. The exit status; kDone if all is well.
int readInput(const ClassArguments& arguments, ClassInput& input);
/// Unpacks zip files and gives the students the names of the roster. The exit status; kDone if all is well.
int unpack(const ClassArguments& arguments, ClassInput& input, const system::Interruption& interruption);

// `glibra class --serve`: the page of a class on the loopback address, where a teacher types points and
// comments.

struct ClassService {
    classroom::Classroom& room;
    classroom::TeacherMarks& own;  ///< what is typed; SITE/marks.json is written with every change
    std::filesystem::path site;
    bool isAnonymous = false;
    std::function<void()> mark;   ///< gives all marks anew, from the rubric and `own`
    std::function<bool()> write;  ///< writes page and tables anew; false: it has printed why not
    std::function<bool()> stop;
};

/// Serves until `stop`; prints the address. Returns the exit status.
int serveClass(const ClassService& service);

}  // namespace glibra::cli
