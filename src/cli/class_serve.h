#pragma once
// `glibra class --serve`: the page of a class on the loopback address, where a teacher types points and
// comments.

#include <filesystem>
#include <functional>

#include "classroom/classroom.h"
#include "classroom/teacher_marks.h"

namespace glibra::cli {

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
