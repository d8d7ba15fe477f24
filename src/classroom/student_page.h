#pragma once
// Pages that leave the teacher's hands: one per student, and a class without names.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "classroom/classroom.h"

namespace glibra::classroom {

inline constexpr const char* kStudentPages = "students";
inline constexpr std::size_t kMostStudentPictures = 12;

/// The page of one submission, to send back: its pictures beside the reference's, points, comment and
/// messages, all in one file. It has nothing of other submissions.
std::string studentPage(const Classroom& classroom, std::size_t entry, const std::filesystem::path& site);

/// The names of the files of all: "Ana Lee.html".
std::vector<std::string> studentFiles(const Classroom& classroom);

/// The class with "Submission 01" and so on for names, in an order that does not show the names, without
/// numbers, addresses, commands and folders. `keys` are the names in the new order.
Classroom anonymous(const Classroom& classroom, std::vector<std::string>& keys);

}  // namespace glibra::classroom
