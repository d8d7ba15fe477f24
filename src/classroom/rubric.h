#pragma once
// The checks of an assignment with their points, from a TOML file, and the marks that they give.
//
//     [[check]]
//     name = "the dots grow with uAd"
//     points = 3
//     reacts = "uAd"
//
//     [late]
//     due = "2026-11-20 23:59"
//     per-day = 0.1

#include <glibra/result.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "classroom/classroom.h"

namespace glibra::classroom {

/// One check: exactly one of these is asked for.
struct Check {
    enum class Kind { drawn, slider, stage, reacts, ignores, like, without, uses, avoids, byHand, solved };
    Kind kind = Kind::drawn;
    std::string name;
    double points = 1;
    bool isBonus = false;
    /// The uniform, the stage ("tessellation" is either of its two), the function, or what like is measured
    /// by: "likeness" or "flip".
    std::string of;
    std::optional<std::pair<double, double>> range;  ///< of a slider
    std::vector<std::string> ids;                    ///< of messages; "*" in them is any text
    double full = 0, none = 0;    ///< like: the figures from which on there are all points, and none
    std::vector<std::string> at;  ///< like: labels of moments; empty: all
    Place place{};                ///< in the file of the rubric
};

/// What handing in late costs.
struct LateRule {
    std::string due;      ///< "2026-11-20 23:59", or empty
    double perDay = 0.1;  ///< the part of the points that each begun day takes
    double most = 1;      ///< the largest part
};

struct Rubric {
    std::vector<Check> checks;
    std::optional<LateRule> late;
};

/// The rubric of an exercise without another one: a point if it is solved.
Rubric solvedRubric();

/// Errors: suite-E01 to suite-E03, suite-E04 (a number out of its limits, or two in the wrong order),
/// suite-E17 (no message has an id of `without`), suite-E24 (a check asks for nothing or for several things,
/// or has a key of another kind), suite-E25 (two checks of one name).
Result<Rubric> readRubricText(std::string_view text, const std::string& file);

/// The checks that name a moment or a slider which the class does not draw (suite-E26).
Diagnostics problemsOf(const Rubric& rubric, const std::vector<Moment>& moments,
                       const std::vector<Slider>& sliders, bool hasReference);

/// When a submission was handed in, as a roster or a learning platform says. The first of these that is known
/// counts: `daysLate`; `status` if it tells of an extension; `time` and the due date of the rule; `status`;
/// `isLate`, which is one day.
struct HandedIn {
    std::optional<double> daysLate;
    std::optional<std::string> time;  ///< as daysBetween reads it (hand_in.h)
    bool isLate = false;              ///< late, but nobody says how much
    std::string status{};             ///< Moodle's column of that name
};

/// What a student does to get all points of a check: one phrase, without a verb's subject.
std::string adviceOf(const Check& check);

/// Sets marks, lateFactor and lateReason of an entry.
void giveMarks(const Rubric& rubric, const Classroom& classroom, const HandedIn& handedIn, Entry& entry);

}  // namespace glibra::classroom
