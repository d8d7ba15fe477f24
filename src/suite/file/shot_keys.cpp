#include "suite/file/shot_keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <system_error>
#include <utility>

#include "base/suggest.h"
#include "glib/messages.h"
#include "glib/text.h"
#include "suite/file/shot_name.h"
#include "suite/number_of.h"
#include "suite/options/option_words.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostEntries = 10'000;

std::vector<std::string> foldersIn(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code failure;
    fs::directory_iterator each(folder, failure);
    for (; !failure && each != fs::directory_iterator() && names.size() < kMostEntries;
         each.increment(failure)) {
        std::error_code ignored;
        if (each->is_directory(ignored)) names.push_back(each->path().filename().generic_string());
    }
    std::ranges::sort(names);
    return names;
}

}  // namespace

std::string whyNoFolder(const fs::path& folder) {
    fs::path known;
    for (const fs::path& part : folder) {
        std::error_code failure;
        const fs::path next = known / part;
        if (part.empty() || fs::is_directory(next, failure)) {
            known = next;
            continue;
        }
        const std::vector<std::string> beside = foldersIn(known.empty() ? "." : known);
        const std::vector<std::string_view> names(beside.begin(), beside.end());
        return fmt::format("there is no folder {}{}", glib::inQuotes(next.generic_string()),
                           base::suggestion(part.generic_string(), names));
    }
    return {};
}

namespace {

constexpr double kLargestNumber = std::numeric_limits<float>::max();

/// Gives `to` the value of one option. Uniform variables and objects' matrices are set one by one; other
/// values are replaced as a whole. Folders are relative to `folder`. A wrong value is reported and changes
/// nothing.
struct OptionReader {
    TomlReader& reader;
    std::string_view key;
    const TomlValue& value;
    const std::filesystem::path& folder;
    ShotTemplate& to;
    const OptionRow& row;

    void operator()(const FlagValue& flag) const {
        if (const auto truth = reader.truth(value, key)) flag.member.edit(to.shot) = *truth;
    }
    void operator()(const WholeValue& whole) const {
        if (const auto number = reader.whole(value, key, whole.least, whole.most))
            whole.member.edit(to.shot) = *number;
    }
    void operator()(const NumberValue& number) const {
        // A text as on the command line, with the unit.
        if (const auto* text = value.as<std::string>(); text && !number.unit.empty()) {
            if (const std::string wrong = readOptionText(row, *text, to.shot); !wrong.empty())
                reader.report("suite-E04", fmt::format("{}: {}", key, wrong), value);
            return;
        }
        if (const auto read = reader.number(value, key, number.least, number.most))
            number.member.edit(to.shot) = *read;
    }
    void operator()(const TimeValue& time) const;
    void operator()(const SizeValue& size) const;
    void operator()(const WordValue& word) const {
        const auto* text = value.as<std::string>();
        const auto found = text ? std::ranges::find(word.words, *text) : word.words.end();
        if (found != word.words.end()) {
            word.set(to.shot, static_cast<int>(found - word.words.begin()));
            return;
        }
        std::string expected;
        for (std::size_t i = 0; i < word.words.size(); ++i)
            expected += fmt::format("{}\"{}\"",
                                    i == 0                       ? ""
                                    : i + 1 == word.words.size() ? " or "
                                                                 : ", ",
                                    word.words[i]);
        reader.wrongType(value, key, expected);
    }
    void operator()(const UniformsValue&) const;
    void operator()(const MatrixValue& matrix) const {
        readMatrix(value, std::string(key), matrix.member.edit(to.shot));
    }
    void operator()(const ObjectsValue& objects) const;
    void operator()(const ColorValue& color) const {
        if (const auto read = numbers(value, key, "[R, G, B] or [R, G, B, A]", 3, 4))
            color.member.edit(to.shot) = {(*read)[0], (*read)[1], (*read)[2],
                                          read->size() == 4 ? (*read)[3] : 1};
    }
    void operator()(const MemoryValue& memory) const {
        const auto* text = value.as<std::string>();
        const auto bytes = text ? parseMemory(*text) : std::nullopt;
        if (bytes)
            memory.member.edit(to.shot) = *bytes;
        else
            reader.wrongType(value, key, kMemoryForm);
    }
    void operator()(const FoldersValue& folders) const;

  private:
    /// Nothing if it is not a list of numbers of such a length, which has then been reported.
    std::optional<std::vector<double>> numbers(const TomlValue& from, std::string_view name,
                                               std::string_view expected, std::size_t least,
                                               std::size_t most) const {
        const auto* list = from.as<TomlList>();
        if (!list || list->size() < least || list->size() > most) {
            reader.wrongType(from, name, expected);
            return std::nullopt;
        }
        std::vector<double> values;
        for (const TomlValue& each : *list)
            if (const auto one = reader.number(each, name, -kLargestNumber, kLargestNumber))
                values.push_back(*one);
        return values.size() == list->size() ? std::optional(std::move(values)) : std::nullopt;
    }
    void readMatrix(const TomlValue& from, const std::string& name, Matrix& matrix) const {
        if (const auto read =
                numbers(from, name, "a list of 16 numbers, column by column", matrix.size(), matrix.size()))
            std::ranges::copy(*read, matrix.begin());
    }
};

/// One time, or a list of times, which makes one shot per time.
void OptionReader::operator()(const TimeValue& time) const {
    const auto* list = value.as<TomlList>();
    std::vector<double> times;
    if (list && list->empty()) reader.report("suite-E04", fmt::format("{}: the list is empty", key), value);
    for (const TomlValue& each : list ? std::span(*list) : std::span(&value, 1))
        if (const auto one = reader.number(each, key, time.least, time.most)) times.push_back(*one);
    if (times.empty()) return;
    to.times = std::move(times);
    to.namesTimes = list != nullptr;
}

void OptionReader::operator()(const SizeValue& size) const {
    constexpr std::string_view kExpected = "[WIDTH, HEIGHT] or \"WIDTHxHEIGHT\"";
    int width = 0;
    int height = 0;
    if (const auto* text = value.as<std::string>()) {
        const std::size_t x = std::min(text->find('x'), text->size());
        const auto first = numberOf<int>(std::string_view(*text).substr(0, x));
        const auto second = numberOf<int>(std::string_view(*text).substr(std::min(x + 1, text->size())));
        if (!first || !second) return reader.wrongType(value, key, kExpected);
        width = *first;
        height = *second;
        if (std::min(width, height) < 1 || std::max(width, height) > size.most)
            return reader.report("suite-E04",
                                 fmt::format("{}: {} is not 1 to {} pixels a side", key, *text, size.most),
                                 value);
    } else {
        const auto* list = value.as<TomlList>();
        if (!list || list->size() != 2) return reader.wrongType(value, key, kExpected);
        const auto first = reader.whole(list->front(), key, 1, size.most);
        const auto second = reader.whole(list->back(), key, 1, size.most);
        if (!first || !second) return;
        width = *first;
        height = *second;
    }
    size.width.edit(to.shot) = width;
    size.height.edit(to.shot) = height;
}

void OptionReader::operator()(const UniformsValue&) const {
    const TomlTable* table = reader.table(value, key);
    if (!table) return;
    for (UniformValues& each : readUniforms(reader, *table, UniformTable::set)) {
        const auto same = std::ranges::find(to.set, each.name, &UniformValues::name);
        if (same == to.set.end())
            to.set.push_back(std::move(each));
        else
            *same = std::move(each);
    }
}

/// { 12 = [16 numbers], 14 = ... }
void OptionReader::operator()(const ObjectsValue& objects) const {
    const TomlTable* table = reader.table(value, key);
    if (!table) return;
    std::vector<ViewState::Object>& all = objects.member.edit(to.shot);
    for (const TomlEntry& entry : *table) {
        const int line = numberOf<int>(entry.key).value_or(0);
        if (line < 1) {
            reader.report("suite-E04",
                          fmt::format("{}: {} is not the number of a line of the scene", key,
                                      glib::inQuotes(entry.key)),
                          entry.position);
            continue;
        }
        const auto same = std::ranges::find(all, line, &ViewState::Object::line);
        ViewState::Object& object =
            same == all.end() ? all.emplace_back(ViewState::Object{line, kIdentity}) : *same;
        readMatrix(entry.value, fmt::format("{}.{}", key, entry.key), object.matrix);
    }
}

void OptionReader::operator()(const FoldersValue& folders) const {
    const auto texts = reader.texts(value, key);
    if (!texts) return;
    std::vector<std::filesystem::path>& all = folders.member.edit(to.shot);
    all.clear();
    for (const std::string& each : *texts) {
        const std::filesystem::path path = (folder / each).lexically_normal();
        std::error_code failure;
        if (std::filesystem::is_regular_file(path, failure))
            reader.report("suite-E10",
                          fmt::format("{}: {} is not a folder", key, glib::inQuotes(path.generic_string())),
                          value);
        else if (const std::string why = whyNoFolder(path); !why.empty())
            reader.report("suite-E10", fmt::format("{}: {}", key, why), value);
        all.push_back(path);
    }
}

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
    const TomlTable* table = in.reader.table(value, "tolerance");
    if (!table) return;
    in.to.shot.statesTolerance = true;
    for (const TomlEntry& entry : *table) {
        const std::span<const ToleranceKey> known = toleranceKeys();
        const auto field = std::ranges::find(known, entry.key, &ToleranceKey::key);
        if (field == known.end()) {
            std::vector<std::string_view> keys;
            for (const ToleranceKey& each : known) keys.push_back(each.key);
            in.reader.unknownKey(entry, "in tolerance", keys);
        } else {
            const std::string name = fmt::format("tolerance.{}", field->key);
            std::optional<double> number;
            if (!field->isWhole)
                number = in.reader.number(entry.value, name, 0, field->most);
            else if (const auto pixels = in.reader.whole(entry.value, name, 0, static_cast<int>(field->most)))
                number = *pixels;
            if (number) field->set(in.to.shot.tolerance, *number);
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
            std::visit(OptionReader{reader, option->key, entry.value, folder, shot, *option}, option->value);
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
