#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "base/files.h"
#include "classroom/hand_in_time.h"
#include "classroom/names.h"
#include "classroom/rubric.h"
#include "suite/file/selection.h"
#include "suite/file/toml_reader.h"

namespace glibra::classroom {
namespace {

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

Rubric solvedRubric() {
    Check check;
    check.kind = Check::Kind::solved;
    check.name = defaultName(check);
    return {{std::move(check)}, std::nullopt};
}

Result<Rubric> readRubricText(std::string_view text, const std::string& file) {
    return RubricReader(file, text).read();
}

Result<Rubric> readRubric(const std::filesystem::path& file) {
    constexpr std::uint64_t kLargest = 1U << 20U;
    const Result<std::string> text = givenText(file, kLargest);
    if (!text) return text.diagnostics;
    return readRubricText(*text, file.generic_string());
}

Diagnostics problemsOf(const Rubric& rubric, const std::vector<Moment>& moments,
                       const std::vector<Slider>& sliders, bool hasReference) {
    Diagnostics problems;
    const auto report = [&](const Check& check, const std::string& text) {
        problems.push_back(diagnose("suite-E26", fmt::format("the check '{}': {}", check.name, text)));
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
