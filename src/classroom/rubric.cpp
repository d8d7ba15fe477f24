#include "classroom/rubric.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "classroom/hand_in_time.h"
#include "suite/file/selection.h"

namespace glibra::classroom {
namespace {

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
    std::string idle;
    for (const UsedProgram& program : entry.programs)
        for (const std::string& stage : program.stages) {
            if (stage != check.of && (check.of != "tessellation" || !stage.starts_with("tessellation")))
                continue;
            if (std::ranges::find(program.idle, stage) == program.idle.end())
                return {1, fmt::format("in program '{}'", program.name)};
            idle = program.name;
        }
    return {0, idle.empty()
                   ? fmt::format("no program has a {} shader", check.of)
                   : fmt::format("nothing is drawn with the {} shader of program '{}'", check.of, idle)};
}

Judgement judgeReaction(const Check& check, const Classroom& room, const Entry& entry) {
    const auto slider = std::ranges::find(room.sliders, check.of, &Slider::name);
    if (slider == room.sliders.end()) return {0, "it was not varied"};
    const auto index = static_cast<std::size_t>(slider - room.sliders.begin());
    const std::size_t moment = slider->pairs.front().second;
    const std::optional<Change> own = index < entry.reactions.size() ? entry.reactions[index] : std::nullopt;
    if (!own) return {0, "its pictures were not drawn"};
    std::string figure = fmt::format("its pictures differ by {:.4f}", own->mean);
    const bool isSeen = own->mean >= kLeastReaction;
    if (check.kind == Check::Kind::ignores) return {isSeen ? 0.0 : 1.0, figure, moment};
    if (isSeen) figure += fmt::format(", by {:.3f} where they change", own->strength);
    switch (reactsOf(room, entry, index)) {
        case Reacts::yes:
            return {1, figure, moment};
        case Reacts::weakly:
            return {0.5,
                    figure + (own->isOtherwise ? ", in another way than those of the reference"
                                               : ", those of the reference by more"),
                    moment};
        case Reacts::unknown:
            return {isSeen ? 1.0 : 0.0, figure, moment};
        case Reacts::no:
            break;
    }
    return {0, figure, moment};
}

/// The mean over the moments, and the moment that is worst.
Judgement judgeLikeness(const Check& check, const Classroom& room, const Entry& entry) {
    const bool isFlip = check.of == "flip";
    double sum = 0, worst = -1;
    std::size_t count = 0;
    Judgement verdict;
    for (std::size_t i = 0; i < room.moments.size() && i < entry.pictures.size(); ++i) {
        if (!check.at.empty() && std::ranges::none_of(check.at, [&](const std::string& at) {
                return suite::fits(at, room.moments[i].label);
            }))
            continue;
        ++count;
        const std::optional<Score>& score = entry.pictures[i].score;
        const double value = score ? (isFlip ? score->flip : score->likeness) : 0;
        if (score)
            sum += (isFlip ? score->kept : 1) *
                   (check.full == check.none
                        ? (isFlip ? value <= check.full : value >= check.full)
                        : std::clamp((value - check.none) / (check.full - check.none), 0., 1.));
        // How far it is from the reference, also beyond where the points begin and end.
        const double distance = !score ? 2 : isFlip ? value : 1 - value;
        if (distance <= worst) continue;
        worst = distance;
        verdict.moment = i;
        verdict.reason = score ? fmt::format("{} {:.3f}", isFlip ? "FLIP" : "likeness", value)
                               : std::string("a picture was not drawn");
        constexpr double kUnlike = .5;
        if (score && score->effect && *score->effect < kUnlike)
            verdict.reason += ", because it does not change as the reference does";
        else if (score && !isFlip && room.moments.size() == 1)
            verdict.reason += " of the whole picture, the only one";
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
            return {0, "not yet marked by hand"};
    }
    return {};
}

}  // namespace

std::string adviceOf(const Check& check) {
    constexpr const char* kPictures = "compare the two pictures on the page";
    switch (check.kind) {
        case Check::Kind::drawn:
            return "correct the errors, and see that something is in the window";
        case Check::Kind::slider:
            return check.range ? fmt::format("write '{} <{:g} VALUE {:g}>' after the program", check.of,
                                             check.range->first, check.range->second)
                               : fmt::format("write '{} <LEAST VALUE MOST>' after the program", check.of);
        case Check::Kind::stage:
            return fmt::format("draw with a program that has a {} shader", check.of);
        case Check::Kind::reacts:
            return fmt::format("let '{}' change the picture as it changes the reference's", check.of);
        case Check::Kind::ignores:
            return fmt::format("let '{}' change nothing", check.of);
        case Check::Kind::like:
            return fmt::format("{}; all points begin at {} {:g}", kPictures,
                               check.of == "flip" ? "FLIP" : "likeness", check.full);
        case Check::Kind::without:
            return "correct what the message says";
        case Check::Kind::uses:
            return fmt::format("call '{}' in a shader that is drawn with", check.of);
        case Check::Kind::avoids:
            return fmt::format("do it without '{}'", check.of);
        case Check::Kind::solved:
            return kPictures;
        case Check::Kind::byHand:
            return "a person gives these points";
    }
    return {};
}

void giveMarks(const Rubric& rubric, const Classroom& room, const HandedIn& handedIn, Entry& entry) {
    entry.marks.clear();
    for (const Check& check : rubric.checks) {
        Judgement verdict = judge(check, room, entry);
        // To the hundredth, so that the sum is that of what is shown.
        entry.marks.push_back({check.name, std::round(verdict.part * check.points * 100) / 100, check.points,
                               check.isBonus, std::move(verdict.reason), verdict.moment, false,
                               check.kind == Check::Kind::byHand});
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

}  // namespace glibra::classroom
