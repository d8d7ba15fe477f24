#pragma once
// What the automatic checks of a rubric say about one submission, for the student who is about to hand it in,
// and for platforms that run checks themselves.

#include <string>
#include <string_view>
#include <vector>

#include "classroom/classroom.h"
#include "classroom/rubric.h"

namespace glibra::classroom {

/// The first entry of the class is the submission; its marks are those of the rubric.

/// True if every automatic check without bonus has all its points.
bool reachesAll(const Classroom& classroom);

/// A line per check: "2 of 4  looks like it: at worst likeness 0.600 at uAd=0.3; compare ...", the sum, and
/// what is not judged here.
std::vector<std::string> resultLines(const Rubric& rubric, const Classroom& classroom);

/// The platforms that read the result of a run as JSON.
enum class ResultFormat {
    gradescope,  ///< results.json (gradescope-autograders.readthedocs.io, "Autograder Specifications")
    submitty,    ///< validation_results.json of a custom validator (submitty.org, "Validation")
    github       ///< what the runners of GitHub Classroom hand to autograding-grading-reporter, before base64
};

/// Checks by hand are left out, and named in a text. Points of a bonus raise the score and not its most.
std::string resultText(ResultFormat format, const Rubric& rubric, const Classroom& classroom);

}  // namespace glibra::classroom
