#include "classroom/own_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/text.h"

namespace glibra::classroom {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// Half of the step to which points are rounded.
constexpr double kHalfStep = .005;

bool isFull(const Mark& mark) {
    return mark.points >= mark.most - kHalfStep;
}

/// "at worst likeness 0.600 at uAd=0.3; compare the two pictures on the page".
std::string textOf(const Check& check, const Mark& mark, const Classroom& room) {
    std::string text = mark.reason;
    // A reason that names its place already says "at".
    if (mark.moment && !room.moments[*mark.moment].label.empty() && check.kind == Check::Kind::like)
        text += " at " + room.moments[*mark.moment].label;
    if (!isFull(mark)) text += (text.empty() ? "" : "; ") + adviceOf(check);
    return text;
}

struct Sums {
    double points = 0, most = 0;     ///< of automatic checks; `most` is without bonus
    double byHand = 0;               ///< the most that a person may give
    std::vector<std::string> names;  ///< of the checks by hand
};

Sums sumsOf(const Entry& entry) {
    Sums sums;
    for (const Mark& each : entry.marks) {
        if (each.isOpen) {
            sums.byHand += each.isBonus ? 0 : each.most;
            sums.names.push_back(each.check);
            continue;
        }
        sums.points += each.points;
        sums.most += each.isBonus ? 0 : each.most;
    }
    return sums;
}

/// What only the run of the whole class judges.
std::string leftOutText(const Rubric& rubric, const Sums& sums) {
    std::string text;
    if (!sums.names.empty())
        text = fmt::format("by hand, not judged here: {} ({:g} {}); ", fmt::join(sums.names, ", "),
                           sums.byHand, sums.byHand == 1 ? "point" : "points");
    return text + "only the run of the whole class compares the code with that of others" +
           (rubric.late ? " and takes points for lateness" : "");
}

std::string sumText(const Sums& sums) {
    return fmt::format("{:g} of {:g} automatic {}", sums.points, sums.most,
                       sums.most == 1 ? "point" : "points");
}

/// The messages of the scene, the sum, and what is left out.
std::string summaryText(const Rubric& rubric, const Entry& entry, const Sums& sums) {
    std::string text = sumText(sums) + "; " + leftOutText(rubric, sums) + "\n";
    if (const std::string why = reasonOf(entry); !why.empty()) text += why + "\n";
    for (const Diagnostic& each : entry.diagnostics) text += toString(each) + "\n";
    return text;
}

/// Calls `use` with each automatic check and its mark.
void forEach(const Rubric& rubric, const Entry& entry, const auto& use) {
    for (std::size_t i = 0; i < std::min(rubric.checks.size(), entry.marks.size()); ++i)
        if (!entry.marks[i].isOpen) use(rubric.checks[i], entry.marks[i]);
}

OrderedJson gradescopeOf(const Rubric& rubric, const Classroom& room, const Sums& sums) {
    OrderedJson tests = OrderedJson::array();
    forEach(rubric, room.entries.front(), [&](const Check& check, const Mark& mark) {
        tests.push_back({{"name", mark.check},
                         {"score", mark.points},
                         {"max_score", mark.isBonus ? 0 : mark.most},
                         {"status", isFull(mark) ? "passed" : "failed"},
                         {"output", textOf(check, mark, room)},
                         {"output_format", "text"},
                         {"visibility", "visible"}});
    });
    return {{"score", sums.points},
            {"execution_time", room.seconds},
            {"output", summaryText(rubric, room.entries.front(), sums)},
            {"output_format", "text"},
            {"visibility", "visible"},
            {"tests", std::move(tests)}};
}

OrderedJson submittyOf(const Rubric& rubric, const Classroom& room, const Sums& sums) {
    OrderedJson messages = OrderedJson::array();
    forEach(rubric, room.entries.front(), [&](const Check& check, const Mark& mark) {
        const std::string reason = textOf(check, mark, room);
        messages.push_back({{"message", fmt::format("{:g} of {:g}: {}{}{}", mark.points, mark.most,
                                                    mark.check, reason.empty() ? "" : ": ", reason)},
                            {"status", isFull(mark)      ? "success"
                                       : mark.points > 0 ? "warning"
                                                         : "failure"}});
    });
    messages.push_back(
        {{"message", summaryText(rubric, room.entries.front(), sums)}, {"status", "information"}});
    const double part = sums.most > 0 ? std::clamp(sums.points / sums.most, 0., 1.) : 1;
    return {{"status", "success"}, {"data", {{"score", part}, {"message", std::move(messages)}}}};
}

OrderedJson githubOf(const Rubric& rubric, const Classroom& room, const Sums& sums) {
    OrderedJson tests = OrderedJson::array();
    forEach(rubric, room.entries.front(), [&](const Check& check, const Mark& mark) {
        tests.push_back({{"name", mark.check},
                         {"status", isFull(mark) ? "pass" : "fail"},
                         {"score", mark.points},
                         {"message", textOf(check, mark, room)},
                         {"test_code", ""},
                         {"filename", ""},
                         {"line_no", 0},
                         {"execution_time", 0}});
    });
    return {{"version", 1},
            {"status", reachesAll(room) ? "pass" : "fail"},
            {"max_score", sums.most},
            {"tests", std::move(tests)}};
}

}  // namespace

bool reachesAll(const Classroom& room) {
    return std::ranges::all_of(room.entries.front().marks,
                               [](const Mark& each) { return each.isOpen || each.isBonus || isFull(each); });
}

std::vector<std::string> resultLines(const Rubric& rubric, const Classroom& room) {
    const Entry& entry = room.entries.front();
    std::vector<std::string> lines;
    std::size_t width = 0;
    const auto points = [](const Mark& mark) { return fmt::format("{:g} of {:g}", mark.points, mark.most); };
    for (const Mark& each : entry.marks) width = std::max(width, points(each).size());
    forEach(rubric, entry, [&](const Check& check, const Mark& mark) {
        const std::string reason = textOf(check, mark, room);
        lines.push_back(fmt::format("{:>{}}  {}{}{}{}", points(mark), width, mark.check,
                                    mark.isBonus ? " (bonus)" : "", reason.empty() ? "" : ": ", reason));
    });
    const Sums sums = sumsOf(entry);
    lines.push_back(sumText(sums));
    lines.push_back("glibra: note: " + leftOutText(rubric, sums));
    return lines;
}

std::string resultText(ResultFormat format, const Rubric& rubric, const Classroom& room) {
    const Sums sums = sumsOf(room.entries.front());
    const OrderedJson json = format == ResultFormat::gradescope ? gradescopeOf(rubric, room, sums)
                             : format == ResultFormat::submitty ? submittyOf(rubric, room, sums)
                                                                : githubOf(rubric, room, sums);
    return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace glibra::classroom
