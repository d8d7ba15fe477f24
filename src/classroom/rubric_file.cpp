#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

#include "classroom/hand_in_time.h"
#include "classroom/rubric.h"
#include "suite/file/glob.h"
#include "suite/file/toml_reader.h"

namespace glibra::classroom {
namespace {

using suite::TomlEntry;
using suite::TomlList;
using suite::TomlReader;
using suite::TomlTable;
using suite::TomlValue;

constexpr double kMostCheckPoints = 1'000;
constexpr std::array<std::string_view, 10> kKinds{"drawn", "slider",  "stage", "reacts", "ignores",
                                                  "like",  "without", "uses",  "avoids", "by-hand"};
constexpr std::array<std::string_view, 17> kCheckKeys{
    "name",    "points", "bonus",  "drawn", "slider", "stage", "reacts",  "ignores", "like",
    "without", "uses",   "avoids", "range", "at",     "none",  "measure", "by-hand"};
constexpr std::array<std::string_view, 3> kLateKeys{"due", "per-day", "most"};
constexpr std::array<std::string_view, 5> kStages{"vertex", "tessellation", "geometry", "fragment",
                                                  "compute"};

std::string defaultName(const Check& check) {
    switch (check.kind) {
        case Check::Kind::drawn:
            return "is drawn";
        case Check::Kind::slider:
            return "has the slider " + check.of;
        case Check::Kind::stage:
            return "has a " + check.of + " shader";
        case Check::Kind::reacts:
            return "changes with " + check.of;
        case Check::Kind::ignores:
            return "does not change with " + check.of;
        case Check::Kind::like:
            return "is like the reference";
        case Check::Kind::without:
            return fmt::format("has no {}", fmt::join(check.ids, ", "));
        case Check::Kind::uses:
            return "uses " + check.of;
        case Check::Kind::avoids:
            return "does not use " + check.of;
        case Check::Kind::byHand:
            return "by hand";
    }
    return {};
}

class RubricReader {
  public:
    RubricReader(const std::string& file, std::string_view text) : reader_(file, text) {}

    Result<Rubric> read() {
        const TomlValue* root = reader_.root();
        const TomlTable* table = root ? reader_.table(*root, "the rubric") : nullptr;
        if (!table) return reader_.take();
        for (const TomlEntry& each : *table) {
            constexpr std::array<std::string_view, 2> kKeys{"check", "late"};
            if (each.key == "check")
                readChecks(each.value);
            else if (each.key == "late")
                readLate(each.value);
            else
                reader_.unknownKey(each, "a rubric", kKeys);
        }
        if (rubric_.checks.empty() && !reader_.hasErrors())
            reader_.report("suite-E24", "the rubric has no [[check]]", reader_.placeOf(*root));
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
        Check check;
        std::vector<std::string_view> kinds;
        for (const TomlEntry& each : table) {
            const auto kind = std::find(kKinds.begin(), kKinds.end(), each.key);
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
        if (check.none == 0 && check.kind == Check::Kind::like) {
            if (check.of.empty()) check.of = "likeness";
            check.none = check.of == "flip" ? 5 * check.full : check.full / 2;
        }
        if (check.name.empty()) check.name = defaultName(check);
        if (std::any_of(rubric_.checks.begin(), rubric_.checks.end(),
                        [&](const Check& other) { return other.name == check.name; }))
            return reader_.report("suite-E25", fmt::format("there are two checks '{}'", check.name), place);
        rubric_.checks.push_back(std::move(check));
    }

    void readKind(const TomlEntry& entry, Check& check) {
        switch (check.kind) {
            case Check::Kind::drawn:
            case Check::Kind::byHand:
                (void)reader_.truth(entry.value, entry.key);
                break;
            case Check::Kind::like:
                if (const auto number = reader_.number(entry.value, entry.key, 0, 1)) check.full = *number;
                break;
            case Check::Kind::without:
                if (auto ids = reader_.texts(entry.value, entry.key)) check.ids = std::move(*ids);
                break;
            case Check::Kind::stage:
                if (auto text = reader_.text(entry.value, entry.key)) check.of = std::move(*text);
                if (std::find(kStages.begin(), kStages.end(), check.of) == kStages.end() && !check.of.empty())
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
            if (low && high) check.range = std::pair(*low, *high);
        } else {
            reader_.unknownKey(entry, "a check", kCheckKeys);
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
                reader_.unknownKey(each, "late", kLateKeys);
            }
        }
        rubric_.late = rule;
    }

    TomlReader reader_;
    Rubric rubric_;
};

}  // namespace

Result<Rubric> readRubricText(std::string_view text, const std::string& file) {
    return RubricReader(file, text).read();
}

Result<Rubric> readRubric(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    if (!in)
        return withoutId(Severity::error, fmt::format("cannot read the rubric '{}'", file.string()),
                         {file.string(), 1, 1});
    return readRubricText(text, file.string());
}

Diagnostics problemsOf(const Rubric& rubric, const std::vector<Moment>& moments,
                       const std::vector<Slider>& sliders, bool hasReference) {
    Diagnostics problems;
    const auto report = [&](const Check& check, const std::string& text) {
        problems.push_back(diagnose("suite-E26", fmt::format("the check '{}': {}", check.name, text)));
    };
    for (const Check& check : rubric.checks) {
        const bool varies = check.kind == Check::Kind::reacts || check.kind == Check::Kind::ignores;
        if (varies && std::none_of(sliders.begin(), sliders.end(),
                                   [&](const Slider& each) { return each.name == check.of; }))
            report(check, fmt::format("no two pictures differ in '{0}' alone; --sweep '{0} = [...]' or a "
                                      "suite with such a sweep draws them",
                                      check.of));
        if (check.kind == Check::Kind::like && !hasReference) report(check, "there is no --reference");
        for (const std::string& at : check.at)
            if (std::none_of(moments.begin(), moments.end(),
                             [&](const Moment& each) { return suite::fits(at, each.label); }))
                report(check, fmt::format("no picture is labelled '{}'", at));
    }
    return problems;
}

}  // namespace glibra::classroom
