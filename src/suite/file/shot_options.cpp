#include "suite/file/shot_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "glib/text.h"
#include "suite/file/missing_folder.h"
#include "suite/file/sweep.h"
#include "suite/number_of.h"
#include "suite/options/option_words.h"

namespace glibra::suite {
namespace {

constexpr double kLargestNumber = std::numeric_limits<float>::max();

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
            const std::string expected = readOptionText(row, *text, to.shot);
            if (!expected.empty())
                reader.report("suite-E04",
                              fmt::format("{}: expected {}, found {}", key, expected, glib::inQuotes(*text)),
                              value);
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
                          fmt::format("{}: {} is not a folder", key, glib::inQuotes(path.string())), value);
        else if (const std::string why = whyNoFolder(path); !why.empty())
            reader.report("suite-E10", fmt::format("{}: {}", key, why), value);
        all.push_back(path);
    }
}

}  // namespace

void readOption(TomlReader& reader, const OptionRow& row, const TomlValue& value,
                const std::filesystem::path& folder, ShotTemplate& shot) {
    std::visit(OptionReader{reader, row.key, value, folder, shot, row}, row.value);
}

}  // namespace glibra::suite
