#include "classroom/rubric.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/contained.h"
#include "base/whole_file.h"
#include "classroom/hand_in_time.h"
#include "suite/file/glob.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::uint64_t kLargestMarks = 16u << 20u;
constexpr std::size_t kLongestComment = 10'000;

/// The part of the points (0 to 1), why, and the moment that shows it.
struct Judgement {
    double part = 0;
    std::string reason;
    std::optional<std::size_t> moment = {};
};

Judgement judgeSlider(const Check& check, const Entry& entry) {
    const auto range = std::ranges::find(entry.ranges, check.of, &RangedUniform::name);
    if (range == entry.ranges.end()) {
        const bool isDeclared = std::ranges::any_of(entry.programs, [&](const UsedProgram& program) {
            return std::ranges::find(program.uniforms, check.of, &DeclaredUniform::name) !=
                   program.uniforms.end();
        });
        return isDeclared ? Judgement{0.5, fmt::format("'{}' is a uniform without a range", check.of)}
                          : Judgement{0, fmt::format("there is no slider '{}'", check.of)};
    }
    if (!check.range) return {1, fmt::format("from {:g} to {:g}", range->least, range->largest)};
    const double tolerance =
        1e-6 * std::max({1.0, std::abs(check.range->first), std::abs(check.range->second)});
    if (std::abs(range->least - check.range->first) <= tolerance &&
        std::abs(range->largest - check.range->second) <= tolerance)
        return {1, ""};
    return {0.5, fmt::format("its range is {:g} to {:g}, expected {:g} to {:g}", range->least, range->largest,
                             check.range->first, check.range->second)};
}

Judgement judgeStage(const Check& check, const Entry& entry) {
    for (const UsedProgram& program : entry.programs)
        for (const std::string& stage : program.stages)
            if (stage == check.of || (check.of == "tessellation" && stage.starts_with("tessellation")))
                return {1, fmt::format("in program '{}'", program.name)};
    return {0, fmt::format("no program has a {} shader", check.of)};
}

Judgement judgeReaction(const Check& check, const Classroom& room, const Entry& entry) {
    const auto slider = std::ranges::find(room.sliders, check.of, &Slider::name);
    if (slider == room.sliders.end()) return {0, "it was not varied"};
    const auto index = static_cast<std::size_t>(slider - room.sliders.begin());
    const std::size_t moment = slider->pairs.front().second;
    const std::optional<double> own = index < entry.reactions.size() ? entry.reactions[index] : std::nullopt;
    if (!own) return {0, "its pictures were not drawn"};
    constexpr double kVisible = 5e-4;
    const std::string figure = fmt::format("its pictures differ by {:.4f}", *own);
    if (check.kind == Check::Kind::ignores) return {*own < kVisible ? 1.0 : 0.0, figure, moment};
    switch (reactionOf(room, entry, index)) {
        case Reaction::full:
            return {1, figure, moment};
        case Reaction::weak:
            return {0.5, figure + ", those of the reference by more", moment};
        case Reaction::unknown:
            return {*own >= kVisible ? 1.0 : 0.0, figure, moment};
        case Reaction::none:
            break;
    }
    return {0, figure, moment};
}

/// The mean over the moments, and the moment that is worst.
Judgement judgeLikeness(const Check& check, const Classroom& room, const Entry& entry) {
    const bool isFlip = check.of == "flip";
    double sum = 0, worstPart = 2;
    std::size_t count = 0;
    Judgement verdict;
    for (std::size_t i = 0; i < room.moments.size() && i < entry.pictures.size(); ++i) {
        if (!check.at.empty() && std::ranges::none_of(check.at, [&](const std::string& at) {
                return suite::fits(at, room.moments[i].label);
            }))
            continue;
        ++count;
        double part = 0;
        const std::optional<Score>& score = entry.pictures[i].score;
        const double value = score ? (isFlip ? score->flip : score->likeness) : 0;
        if (score)
            part = check.full == check.none
                       ? (isFlip ? value <= check.full : value >= check.full)
                       : std::clamp((value - check.none) / (check.full - check.none), 0., 1.);
        sum += part;
        if (part >= worstPart) continue;
        worstPart = part;
        verdict.moment = i;
        verdict.reason = score ? fmt::format("{} {:.3f}", isFlip ? "FLIP" : "likeness", value)
                               : std::string("a picture was not drawn");
    }
    if (count == 0) return {0, "no picture was drawn"};
    verdict.part = entry.drawsNothing ? 0 : sum / static_cast<double>(count);
    if (entry.drawsNothing) verdict.reason = "it draws nothing that is seen";
    if (count > 1 && !entry.drawsNothing) verdict.reason = "at worst " + verdict.reason;
    return verdict;
}

/// All pictures are those of the reference, or have what the exercise asks for.
Judgement judgeSolved(const Classroom& room, const Entry& entry) {
    if (entry.pictures.empty()) return {0, "there is no scene"};
    for (std::size_t i = 0; i < entry.pictures.size() && i < room.moments.size(); ++i) {
        const std::optional<Score>& score = entry.pictures[i].score;
        const std::string& label = room.moments[i].label;
        if (!score || !score->unsolved.empty())
            return {0,
                    (label.empty() ? "" : "at " + label + " ") +
                        (score ? score->unsolved : std::string("a picture was not drawn")),
                    i};
    }
    return {1, ""};
}

Judgement judgeMessages(const Check& check, const Entry& entry) {
    if (entry.submission.scene.empty()) return {0, "there is no scene"};
    std::size_t count = 0;
    std::string first;
    for (const Diagnostic& each : entry.diagnostics)
        if (std::ranges::any_of(check.ids, [&](const std::string& id) { return suite::fits(id, each.id); })) {
            ++count;
            if (first.empty()) first = each.id;
        }
    if (count == 0) return {1, ""};
    // One oversight costs half.
    return {count == 1 ? 0.5 : 0.0,
            count == 1 ? "it has " + first : fmt::format("it has {} of them, first {}", count, first)};
}

Judgement judgeCalls(const Check& check, const Entry& entry) {
    if (entry.submission.scene.empty() || entry.programs.empty()) return {0, "it has no program"};
    const bool uses = std::ranges::find(entry.calls, check.of) != entry.calls.end();
    const bool isRight = uses == (check.kind == Check::Kind::uses);
    return {isRight ? 1.0 : 0.0, uses ? fmt::format("its shaders call {}", check.of)
                                      : fmt::format("no shader calls {}", check.of)};
}

Judgement judge(const Check& check, const Classroom& room, const Entry& entry) {
    switch (check.kind) {
        case Check::Kind::drawn:
            return {entry.pictures.empty() || entry.drawsNothing
                        ? 0.0
                        : static_cast<double>(drawnCount(entry)) / static_cast<double>(entry.pictures.size()),
                    stateOf(entry) == "drawn" ? std::string() : reasonOf(entry)};
        case Check::Kind::slider:
            return judgeSlider(check, entry);
        case Check::Kind::stage:
            return judgeStage(check, entry);
        case Check::Kind::reacts:
        case Check::Kind::ignores:
            return judgeReaction(check, room, entry);
        case Check::Kind::like:
            return judgeLikeness(check, room, entry);
        case Check::Kind::without:
            return judgeMessages(check, entry);
        case Check::Kind::uses:
        case Check::Kind::avoids:
            return judgeCalls(check, entry);
        case Check::Kind::solved:
            return judgeSolved(room, entry);
        case Check::Kind::byHand:
            return {0, "to be marked by hand"};
    }
    return {};
}

}  // namespace

void giveMarks(const Rubric& rubric, const Classroom& room, const HandedIn& handedIn, Entry& entry) {
    entry.marks.clear();
    for (const Check& check : rubric.checks) {
        Judgement verdict = judge(check, room, entry);
        // To the hundredth, so that the sum is that of what is shown.
        entry.marks.push_back({check.name, std::round(verdict.part * check.points * 100) / 100, check.points,
                               check.isBonus, std::move(verdict.reason), verdict.moment, false});
    }
    entry.lateFactor = 1;
    entry.lateReason.clear();
    if (!rubric.late) return;
    const MoodleStatus status = readMoodleStatus(handedIn.status);
    std::optional<double> days = handedIn.daysLate;
    if (!days && status.isExtended) days = status.daysLate.value_or(0);
    if (!days && handedIn.time && !rubric.late->due.empty())
        days = daysBetween(rubric.late->due, *handedIn.time);
    if (!days) days = status.daysLate;
    if (!days && handedIn.isLate) days = 1;
    if (!days || *days <= 0) return;
    const double lost = std::min(rubric.late->most, std::ceil(*days) * rubric.late->perDay);
    entry.lateFactor = 1 - lost;
    entry.lateReason = fmt::format("{:g} {} late, {:g} % less", std::ceil(*days),
                                   std::ceil(*days) == 1 ? "day" : "days", std::round(lost * 1000) / 10);
}

Result<TeacherMarks> parseTeacherMarks(std::string_view text) try {
    TeacherMarks marks;
    const Json json = Json::parse(text);
    for (const auto& [name, each] : json.items()) {
        OwnMarks own;
        if (!each.is_object())
            return diagnose(
                "suite-E27",
                fmt::format("this is no file of marks: '{}' is no object of points and comment", name));
        if (each.contains("comment"))
            own.comment = each.at("comment").get<std::string>().substr(0, kLongestComment);
        if (each.contains("points"))
            for (const auto& [check, points] : each.at("points").items())
                own.points[check] = points.get<double>();
        marks[name] = std::move(own);
    }
    return marks;
} catch (const Json::exception& failure) {
    return diagnose("suite-E27", fmt::format("this is no file of marks: {}", failure.what()));
}

std::string toText(const TeacherMarks& marks) {
    Json json = Json::object();
    for (const auto& [name, each] : marks) {
        if (each.points.empty() && each.comment.empty()) continue;
        json[name] = {{"comment", each.comment}, {"points", each.points}};
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<TeacherMarks> readTeacherMarks(const fs::path& site) {
    std::error_code failure;
    if (!fs::exists(fs::symlink_status(site / kMarksFile, failure))) return TeacherMarks{};
    const auto text = base::textIn(base::openBeneath(site, kMarksFile), kLargestMarks);
    if (!text) return diagnose("suite-E27", fmt::format("cannot read '{}'", (site / kMarksFile).string()));
    Result<TeacherMarks> marks = parseTeacherMarks(*text);
    for (Diagnostic& each : marks.diagnostics) each.place = {(site / kMarksFile).string(), 1, 1};
    return marks;
}

void limitPoints(const Entry& entry, OwnMarks& marks) {
    for (const Mark& each : entry.marks)
        if (const auto own = marks.points.find(each.check); own != marks.points.end())
            own->second = std::clamp(own->second, 0.0, each.most);
}

void applyTeacherMarks(const TeacherMarks& marks, Entry& entry) {
    const auto own = marks.find(entry.submission.name);
    if (own == marks.end()) return;
    entry.comment = own->second.comment;
    OwnMarks counted = own->second;
    limitPoints(entry, counted);
    for (const auto& [check, points] : counted.points) {
        if (!std::isfinite(points)) continue;
        const auto mark = std::ranges::find(entry.marks, check, &Mark::check);
        if (mark == entry.marks.end()) continue;
        mark->points = points;
        mark->isOwn = true;
        mark->reason = "the teacher's own points";
    }
}

}  // namespace glibra::classroom
