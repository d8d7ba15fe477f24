#include "suite/file/shot_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "base/suggest.h"
#include "glib/diagnostic_catalogue.h"
#include "glib/text.h"
#include "suite/day.h"
#include "suite/file/shot_name.h"
#include "suite/file/shot_options.h"

namespace glibra::suite {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::max();

struct Context {
    TomlReader& reader;
    ShotTemplate& to;
    const std::filesystem::path& folder;
};

void readSweep(const Context& in, const TomlValue& value) {
    if (const TomlTable* table = in.reader.table(value, "sweep"))
        in.to.sweeps = readUniforms(in.reader, *table, UniformTable::sweep);
}

void readTolerance(const Context& in, const TomlValue& value) {
    struct Field {
        std::string_view key;
        double most;
        void (*store)(image::Tolerance&, double);
        bool isWhole = false;
    };
    static constexpr std::array<Field, 9> kFields{{
        {"max", 255, [](image::Tolerance& to, double v) { to.largest = v; }},
        {"fraction", 1, [](image::Tolerance& to, double v) { to.fraction = v; }},
        {"cluster", 1e9, [](image::Tolerance& to, double v) { to.cluster = static_cast<int>(v); }, true},
        {"line", 1e9, [](image::Tolerance& to, double v) { to.line = static_cast<int>(v); }, true},
        {"bias", 255, [](image::Tolerance& to, double v) { to.bias = v; }},
        {"flip", 1, [](image::Tolerance& to, double v) { to.flip = v; }},
        {"structure", 1, [](image::Tolerance& to, double v) { to.structure = v; }},
        {"relative", kNoLimit, [](image::Tolerance& to, double v) { to.relative = v; }},
        {"absolute", kNoLimit, [](image::Tolerance& to, double v) { to.absolute = v; }},
    }};
    const TomlTable* table = in.reader.table(value, "tolerance");
    if (!table) return;
    in.to.shot.statesTolerance = true;
    for (const TomlEntry& entry : *table) {
        const auto* const field = std::ranges::find(kFields, entry.key, &Field::key);
        if (field == kFields.end()) {
            std::array<std::string_view, kFields.size()> keys;
            std::ranges::transform(kFields, keys.begin(), [](const Field& f) { return f.key; });
            in.reader.unknownKey(entry, "in tolerance", keys);
        } else {
            const std::string name = fmt::format("tolerance.{}", field->key);
            std::optional<double> number;
            if (!field->isWhole)
                number = in.reader.number(entry.value, name, 0, field->most);
            else if (const auto pixels = in.reader.whole(entry.value, name, 0, static_cast<int>(field->most)))
                number = *pixels;
            if (number) field->store(in.to.shot.tolerance, *number);
        }
    }
}

void readTags(const Context& in, const TomlValue& value) {
    const auto tags = in.reader.texts(value, "tags");
    if (!tags) return;
    for (const std::string& each : *tags) {
        std::string why = whyNotAName(each);
        if (why.empty() && each.find('/') != std::string::npos) why = "has '/' in it";
        if (!why.empty())
            in.reader.report("suite-E05", fmt::format("tag {} {}", glib::inQuotes(each), why), value);
        else if (std::ranges::find(in.to.shot.tags, each) == in.to.shot.tags.end())
            in.to.shot.tags.push_back(each);
    }
}

/// An id of the catalogue, or suite-E17 with the nearest.
void readErrorId(const Context& in, const TomlValue& value, std::string_view name, ExpectedError& expected) {
    const auto id = in.reader.text(value, name);
    if (!id) return;
    expected.id = *id;
    if (glib::findDiagnostic(*id)) return;
    std::vector<std::string_view> ids;
    for (const glib::CatalogueRow& row : glib::diagnosticCatalogue()) ids.push_back(row.id);
    const std::string meant = base::suggestion(*id, ids);
    in.reader.report("suite-E17",
                     fmt::format("{}: there is no message {}{}", name, glib::inQuotes(*id),
                                 meant.empty() ? "; 'glibra language --diagnostics' lists them" : meant),
                     value);
}

void readExpectedError(const Context& in, const TomlValue& value) {
    constexpr std::string_view kName = "expect-error";
    ExpectedError expected;
    if (const auto* table = value.as<TomlTable>()) {
        static constexpr std::array<std::string_view, 3> kKeys{"id", "text", "line"};
        for (const TomlEntry& entry : *table) {
            if (entry.key == "id") {
                readErrorId(in, entry.value, "expect-error.id", expected);
            } else if (entry.key == "text") {
                expected.text = in.reader.text(entry.value, "expect-error.text").value_or("");
            } else if (entry.key == "line") {
                expected.line =
                    in.reader.whole(entry.value, "expect-error.line", 1, std::numeric_limits<int>::max())
                        .value_or(0);
            } else {
                in.reader.unknownKey(entry, "in expect-error", kKeys);
            }
        }
    } else if (value.as<std::string>()) {
        readErrorId(in, value, kName, expected);
    } else if (const auto* any = value.as<bool>(); !any || !*any) {
        return in.reader.wrongType(value, kName,
                                   "an id, as \"glsl-E01\", a table { id, text, line } or true");
    }
    in.to.shot.expectedError = std::move(expected);
}

void readScript(const Context& in, const TomlValue& value) {
    const auto* list = value.as<TomlList>();
    if (const auto scripts = in.reader.texts(value, "script"))
        for (std::size_t i = 0; i < scripts->size(); ++i)
            in.to.scripts.push_back({(*scripts)[i], in.reader.placeOf(list ? (*list)[i] : value)});
    in.to.isList = list != nullptr;
}

void readExceptions(const Context& in, const TomlValue& value) {
    if (const auto patterns = in.reader.texts(value, "except"))
        for (const std::string& each : *patterns)
            in.to.exceptions.push_back({each, in.reader.placeOf(value)});
}

template <std::optional<PlacedText> ShotTemplate::* field>
void readName(const Context& in, const TomlValue& value) {
    constexpr std::string_view kWord = field == &ShotTemplate::name    ? "name"
                                       : field == &ShotTemplate::match ? "match"
                                                                       : "differ";
    const auto text = in.reader.text(value, kWord);
    if (!text) return;
    if (const std::string why = whyNotAName(*text); !why.empty())
        return in.reader.report("suite-E05", fmt::format("{}: {} {}", kWord, glib::inQuotes(*text), why),
                                value);
    in.to.*field = PlacedText{*text, in.reader.placeOf(value)};
}

/// A day, or suite-E30.
std::optional<std::string> readDay(const Context& in, const TomlValue& value, std::string_view name) {
    auto day = in.reader.text(value, name);
    if (!day || isDay(*day)) return day;
    in.reader.report("suite-E30",
                     fmt::format("{}: {} is not a day, as \"2026-12-31\"", name, glib::inQuotes(*day)),
                     value);
    return std::nullopt;
}

void readQuarantine(const Context& in, const TomlValue& value) {
    if (auto day = readDay(in, value, "quarantine")) in.to.shot.quarantine = *std::move(day);
}

void readRetries(const Context& in, const TomlValue& value) {
    constexpr int kMostRetries = 20;
    if (const auto count = in.reader.whole(value, "retries", 0, kMostRetries)) in.to.shot.retries = *count;
}

/// [x, y, width, height]
void readRectangle(const Context& in, const TomlValue& value, std::string until) {
    constexpr int kMost = 1 << 20;
    const auto* list = value.as<TomlList>();
    if (!list || list->size() != 4) return in.reader.wrongType(value, "ignore", "[X, Y, WIDTH, HEIGHT]");
    std::array<int, 4> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto number = in.reader.whole((*list)[i], "ignore", i < 2 ? 0 : 1, kMost);
        if (!number) return;
        numbers.at(i) = *number;
    }
    in.to.shot.ignored.push_back(
        {numbers[0], numbers[1], numbers[2], numbers[3], std::move(until), in.reader.placeOf(value)});
}

/// A list of rectangles: [X, Y, WIDTH, HEIGHT], or { rectangle = [...], until = "2026-12-31" }.
void readIgnored(const Context& in, const TomlValue& value) {
    constexpr std::string_view kForm =
        "a list of [X, Y, WIDTH, HEIGHT] or { rectangle = [...], until = \"DATE\" }";
    const auto* list = value.as<TomlList>();
    if (!list) return in.reader.wrongType(value, "ignore", kForm);
    in.to.shot.ignored.clear();
    for (const TomlValue& each : *list) {
        const auto* table = each.as<TomlTable>();
        if (!table) {
            readRectangle(in, each, {});
            continue;
        }
        static constexpr std::array<std::string_view, 2> kKeys{"rectangle", "until"};
        const TomlValue* rectangle = nullptr;
        std::string until;
        for (const TomlEntry& entry : *table)
            if (entry.key == "rectangle")
                rectangle = &entry.value;
            else if (entry.key == "until")
                until = readDay(in, entry.value, "ignore.until").value_or("");
            else
                in.reader.unknownKey(entry, "in ignore", kKeys);
        if (rectangle)
            readRectangle(in, *rectangle, std::move(until));
        else
            in.reader.wrongType(each, "ignore", kForm);
    }
}

void readMask(const Context& in, const TomlValue& value) {
    const auto file = in.reader.text(value, "mask");
    if (!file) return;
    in.to.shot.mask = (in.folder / *file).lexically_normal();
    in.to.shot.maskPlace = in.reader.placeOf(value);
}

/// A key that is not an option of the picture.
struct Key {
    std::string_view name;
    bool inDefaults;
    void (*read)(const Context&, const TomlValue&);
};

constexpr std::array<Key, 14> kTemplateKeys{{
    {"script", false, readScript},
    {"except", false, readExceptions},
    {"name", false, readName<&ShotTemplate::name>},
    {"sweep", false, readSweep},
    {"tolerance", true, readTolerance},
    {"retries", true, readRetries},
    {"quarantine", true, readQuarantine},
    {"ignore", true, readIgnored},
    {"mask", true, readMask},
    {"tags", true, readTags},
    {"expect-error", false, readExpectedError},
    {"match", false, readName<&ShotTemplate::match>},
    {"differ", false, readName<&ShotTemplate::differ>},
    {"golden", true,
     [](const Context& in, const TomlValue& value) {
         if (const auto truth = in.reader.truth(value, "golden")) in.to.shot.golden = *truth;
     }},
}};

const Key* findKey(std::string_view name) {
    const auto* const found = std::ranges::find(kTemplateKeys, name, &Key::name);
    return found == kTemplateKeys.end() ? nullptr : found;
}

std::vector<std::string_view> keys(bool isDefaults) {
    std::vector<std::string_view> names;
    for (const Key& each : kTemplateKeys)
        if (each.inDefaults || !isDefaults) names.push_back(each.name);
    for (const OptionRow& each : optionTable())
        if (!each.key.empty()) names.push_back(each.key);
    return names;
}

}  // namespace

void readTemplate(TomlReader& reader, const TomlTable& table, const std::filesystem::path& folder,
                  bool isDefaults, ShotTemplate& shot) {
    const Context in{reader, shot, folder};
    for (const TomlEntry& entry : table) {
        const Key* key = findKey(entry.key);
        if (const OptionRow* option = findOptionKey(entry.key)) {
            readOption(reader, *option, entry.value, folder, shot);
        } else if (key && (key->inDefaults || !isDefaults)) {
            key->read(in, entry.value);
        } else if (key) {
            reader.report("suite-E02",
                          fmt::format("'{}' belongs to one shot and cannot stand in [defaults]", entry.key),
                          entry.position);
        } else {
            reader.unknownKey(entry, isDefaults ? "in [defaults]" : "in [[shot]]", keys(isDefaults));
        }
    }
}

bool isShotKey(std::string_view key) {
    return findKey(key) || findOptionKey(key);
}

bool isDefaultsKey(std::string_view key) {
    const Key* found = findKey(key);
    return found ? found->inDefaults : findOptionKey(key) != nullptr;
}

}  // namespace glibra::suite
