#include "classroom/rubric.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/files.h"
#include "base/text.h"
#include "classroom/hand_in.h"
#include "classroom/names.h"
#include "glib/messages.h"
#include "suite/file/selection.h"
#include "suite/file/toml_reader.h"

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
    for (const Diagnostic& each : entry.diagnostics) {
        // A note with the id of an error says more about that.
        if ((each.severity == Severity::note && severityOf(each.id) != Severity::note) ||
            std::ranges::none_of(check.ids, [&](const std::string& id) { return suite::fits(id, each.id); }))
            continue;
        ++count;
        if (first.empty()) first = each.id;
    }
    if (count == 0) return {1, ""};
    // One oversight costs half.
    return {count == 1 ? 0.5 : 0.0,
            count == 1 ? "it has " + first : fmt::format("it has {} of them, first {}", count, first)};
}

Judgement judgeCalls(const Check& check, const Entry& entry) {
    if (entry.programs.empty()) return {0, "it has no program"};
    const bool uses = std::ranges::find(entry.calls, check.of) != entry.calls.end();
    const bool isRight = uses == (check.kind == Check::Kind::uses);
    return {isRight ? 1.0 : 0.0, uses ? fmt::format("its shaders call {}", check.of)
                                      : fmt::format("no shader calls {}", check.of)};
}

Judgement judge(const Check& check, const Classroom& room, const Entry& entry) {
    using enum Check::Kind;
    const bool isOfPictures = check.kind == stage || check.kind == uses || check.kind == avoids;
    if (isOfPictures && drawnCount(entry) == 0) return {0, "no picture was drawn"};
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

using suite::TomlEntry;
using suite::TomlList;
using suite::TomlReader;
using suite::TomlTable;
using suite::TomlValue;

constexpr double kMostCheckPoints = 1'000;
constexpr std::array<std::string_view, 11> kKinds{"drawn",   "slider", "stage",  "reacts",  "ignores", "like",
                                                  "without", "uses",   "avoids", "by-hand", "solved"};
constexpr std::array<std::string_view, 18> kCheckKeys{
    "name",    "points", "bonus",  "drawn", "slider", "stage", "reacts",  "ignores", "like",
    "without", "uses",   "avoids", "range", "at",     "none",  "measure", "by-hand", "solved"};
/// Keys that only one kind of check has, and that kind.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kKindOfKey{
    {{"range", "slider"}, {"at", "like"}, {"none", "like"}, {"measure", "like"}}};
constexpr std::array<std::string_view, 3> kLateKeys{"due", "per-day", "most"};
constexpr std::array<std::string_view, 5> kStages{"vertex", "tessellation", "geometry", "fragment",
                                                  "compute"};

std::string defaultName(const Check& check) {
    // In the order of Check::Kind; {} is what the check asks for.
    constexpr std::array<std::string_view, kKinds.size()> kNames{"is drawn",
                                                                 "has the slider {}",
                                                                 "has a {} shader",
                                                                 "changes with {}",
                                                                 "does not change with {}",
                                                                 "is like the reference",
                                                                 "has no {}",
                                                                 "uses {}",
                                                                 "does not use {}",
                                                                 "by hand",
                                                                 "is solved"};
    return fmt::format(
        fmt::runtime(kNames.at(static_cast<std::size_t>(check.kind))),
        check.kind == Check::Kind::without ? fmt::format("{}", fmt::join(check.ids, ", ")) : check.of);
}

class RubricReader {
  public:
    RubricReader(const std::string& file, std::string_view text) : file_(file), reader_(file, text) {}

    Result<Rubric> read() {
        const TomlTable* table = reader_.root();
        if (!table) return reader_.take();
        for (const TomlEntry& each : *table) {
            constexpr std::array<std::string_view, 2> kKeys{"check", "late"};
            if (each.key == "check")
                readChecks(each.value);
            else if (each.key == "late")
                readLate(each.value);
            else
                reader_.unknownKey(each, "at the top of the file", kKeys);
        }
        if (rubric_.checks.empty() && !reader_.hasErrors())
            reader_.report("suite-E24", "the rubric has no [[check]]", Place{file_, 1, 1});
        if (reader_.hasErrors()) return reader_.take();
        return {std::move(rubric_), reader_.take()};
    }

  private:
    void readChecks(const TomlValue& value) {
        const auto* list = value.as<TomlList>();
        if (!list) return reader_.wrongType(value, "check", "[[check]] tables");
        for (const TomlValue& each : *list)
            if (const TomlTable* table = reader_.table(each, "check")) readCheck(*table, each);
    }

    void readCheck(const TomlTable& table, const TomlValue& whole) {
        const std::size_t earlierErrors = reader_.errorCount();
        Check check;
        std::vector<std::string_view> kinds;
        for (const TomlEntry& each : table) {
            const auto kind = std::ranges::find(kKinds, each.key);
            if (kind != kKinds.end()) {
                kinds.push_back(each.key);
                check.kind = static_cast<Check::Kind>(kind - kKinds.begin());
                readKind(each, check);
            } else {
                readOther(each, check);
            }
        }
        const Place place = reader_.placeOf(whole);
        if (kinds.size() != 1)
            return reader_.report(
                "suite-E24",
                kinds.empty()
                    ? fmt::format("the check asks for nothing; expected one of {}", fmt::join(kKinds, ", "))
                    : fmt::format("the check asks for {}; each check asks for one thing",
                                  fmt::join(kinds, " and ")),
                place);
        refuseKeysOfOthers(table, kinds.front());
        if (reader_.errorCount() > earlierErrors) return;
        if (check.kind == Check::Kind::like) completeLikeness(table, check);
        if (check.name.empty()) check.name = defaultName(check);
        if (std::ranges::find(rubric_.checks, check.name, &Check::name) != rubric_.checks.end())
            return reader_.report("suite-E25", fmt::format("there are two checks '{}'", check.name), place);
        check.place = place;
        rubric_.checks.push_back(std::move(check));
    }

    void refuseKeysOfOthers(const TomlTable& table, std::string_view kind) {
        for (const auto& [key, owner] : kKindOfKey)
            if (const TomlEntry* entry = entryOf(table, key); entry && kind != owner)
                reader_.report(
                    "suite-E24",
                    fmt::format("'{}' belongs to a check that asks for '{}'; this one asks for '{}'", key,
                                owner, kind),
                    entry->position);
    }

    /// Sets what the table leaves out, and reports a `none` on the wrong side of `like`.
    void completeLikeness(const TomlTable& table, Check& check) {
        if (check.of.empty()) check.of = "likeness";
        const bool isFlip = check.of == "flip";
        const TomlEntry* none = entryOf(table, "none");
        if (!none) {
            check.none = isFlip ? 5 * check.full : check.full / 2;
        } else if (isFlip ? check.none < check.full : check.none > check.full) {
            reader_.report(
                "suite-E04",
                isFlip ? fmt::format("none: {:g} is less than {:g}, the FLIP of 'like'; FLIP grows with "
                                     "the difference, so points end at a larger one",
                                     check.none, check.full)
                       : fmt::format("none: {:g} is more than {:g}, the likeness of 'like'; points "
                                     "begin at a smaller one",
                                     check.none, check.full),
                none->value);
        }
    }

    /// Null if the table does not have the key.
    static const TomlEntry* entryOf(const TomlTable& table, std::string_view key) {
        const auto found = std::ranges::find(table, key, &TomlEntry::key);
        return found == table.end() ? nullptr : &*found;
    }

    void readKind(const TomlEntry& entry, Check& check) {
        switch (check.kind) {
            case Check::Kind::drawn:
            case Check::Kind::byHand:
            case Check::Kind::solved:
                if (reader_.truth(entry.value, entry.key) == false)
                    reader_.wrongType(entry.value, entry.key, "true");
                break;
            case Check::Kind::like:
                if (const auto number = reader_.number(entry.value, entry.key, 0, 1)) check.full = *number;
                break;
            case Check::Kind::without:
                if (auto ids = reader_.texts(entry.value, entry.key)) check.ids = std::move(*ids);
                for (const std::string& id : check.ids)
                    if (std::ranges::none_of(
                            glib::diagnosticCatalogue(),
                            [&](const glib::CatalogueRow& each) { return suite::fits(id, each.id); }))
                        reader_.report("suite-E17",
                                       fmt::format("without: there is no message {}; 'glibra language "
                                                   "--diagnostics' lists them",
                                                   base::inQuotes(id)),
                                       entry.value);
                break;
            case Check::Kind::stage:
                if (auto text = reader_.text(entry.value, entry.key)) check.of = std::move(*text);
                if (std::ranges::find(kStages, check.of) == kStages.end() && !check.of.empty())
                    reader_.wrongType(entry.value, entry.key,
                                      "vertex, tessellation, geometry, fragment or compute");
                break;
            default:
                if (auto text = reader_.text(entry.value, entry.key)) check.of = std::move(*text);
        }
    }

    void readOther(const TomlEntry& entry, Check& check) {
        if (entry.key == "name") {
            if (auto text = reader_.text(entry.value, entry.key)) check.name = std::move(*text);
        } else if (entry.key == "points") {
            if (const auto number = reader_.number(entry.value, entry.key, 0, kMostCheckPoints))
                check.points = *number;
        } else if (entry.key == "bonus") {
            check.isBonus = reader_.truth(entry.value, entry.key).value_or(false);
        } else if (entry.key == "at") {
            if (auto texts = reader_.texts(entry.value, entry.key)) check.at = std::move(*texts);
        } else if (entry.key == "none") {
            check.none = reader_.number(entry.value, entry.key, 0, 1).value_or(0);
        } else if (entry.key == "measure") {
            if (auto text = reader_.text(entry.value, entry.key)) check.of = std::move(*text);
            if (check.of != "likeness" && check.of != "flip")
                reader_.wrongType(entry.value, entry.key, "likeness or flip");
        } else if (entry.key == "range") {
            const auto* list = entry.value.as<TomlList>();
            if (!list || list->size() != 2)
                return reader_.wrongType(entry.value, entry.key, "two numbers, as [0, 1]");
            const auto low = reader_.number((*list)[0], "range", -1e30, 1e30);
            const auto high = reader_.number((*list)[1], "range", -1e30, 1e30);
            if (!low || !high) return;
            if (*low >= *high)
                return reader_.report(
                    "suite-E04",
                    fmt::format("range: {:g} is not less than {:g}; the smaller number comes first", *low,
                                *high),
                    entry.value);
            check.range = std::pair(*low, *high);
        } else {
            reader_.unknownKey(entry, "in [[check]]", kCheckKeys);
        }
    }

    void readLate(const TomlValue& value) {
        const TomlTable* table = reader_.table(value, "late");
        if (!table) return;
        LateRule rule;
        for (const TomlEntry& each : *table) {
            if (each.key == "due") {
                if (auto text = reader_.text(each.value, each.key)) rule.due = std::move(*text);
                if (!rule.due.empty() && !isTime(rule.due))
                    reader_.wrongType(each.value, each.key, "a time, as \"2026-11-20 23:59\"");
            } else if (each.key == "per-day") {
                rule.perDay = reader_.number(each.value, each.key, 0, 1).value_or(0);
            } else if (each.key == "most") {
                rule.most = reader_.number(each.value, each.key, 0, 1).value_or(1);
            } else {
                reader_.unknownKey(each, "in [late]", kLateKeys);
            }
        }
        rubric_.late = rule;
    }

    const std::string& file_;
    TomlReader reader_;
    Rubric rubric_;
};

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
        // A part is rounded to the hundredth, so that the sum is that of what is shown.
        const double rounded = std::round(verdict.part * check.points * 100) / 100;
        const double points = verdict.part == 1 ? check.points : std::min(rounded, check.points);
        entry.marks.push_back({check.name, points, check.points, check.isBonus, std::move(verdict.reason),
                               verdict.moment, false, check.kind == Check::Kind::byHand});
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

Rubric solvedRubric() {
    Check check;
    check.kind = Check::Kind::solved;
    check.name = defaultName(check);
    return {{std::move(check)}, std::nullopt};
}

Result<Rubric> readRubricText(std::string_view text, const std::string& file) {
    return RubricReader(file, text).read();
}

Diagnostics problemsOf(const Rubric& rubric, const std::vector<Moment>& moments,
                       const std::vector<Slider>& sliders, bool hasReference) {
    Diagnostics problems;
    const auto report = [&](const Check& check, const std::string& text) {
        problems.push_back(
            diagnose("suite-E26", fmt::format("the check '{}': {}", check.name, text), check.place));
    };
    for (const Check& check : rubric.checks) {
        const bool varies = check.kind == Check::Kind::reacts || check.kind == Check::Kind::ignores;
        if (varies && std::ranges::find(sliders, check.of, &Slider::name) == sliders.end())
            report(check, fmt::format("no two pictures differ in '{0}' alone; --sweep '{0} = [...]' or a "
                                      "suite with such a sweep draws them",
                                      check.of));
        const bool needsReference = check.kind == Check::Kind::like || check.kind == Check::Kind::solved;
        if (needsReference && !hasReference) report(check, "there is no --reference");
        for (const std::string& at : check.at)
            if (std::ranges::none_of(moments,
                                     [&](const Moment& each) { return suite::fits(at, each.label); }))
                report(check, fmt::format("no picture is labelled '{}'", at));
    }
    return problems;
}

}  // namespace glibra::classroom
