#include "suite/options/option_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <system_error>

#include "glib/text.h"
#include "suite/number_of.h"
#include "system/folder.h"

namespace glibra::suite {
namespace {

constexpr std::string_view kUnits = "KMGT";                       // 1024 to the power of 1, 2, 3, 4
constexpr std::uint64_t kLeastMemory = std::uint64_t{64} << 20U;  // what a driver needs to start
constexpr std::uint64_t kMostMemory = std::uint64_t{1} << 60U;

/// Numbers separated by commas, finite as 32-bit floats; nothing if the text is anything else.
std::optional<std::vector<double>> numbersOf(std::string_view text) {
    std::vector<double> values;
    for (;;) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const auto value = numberOf<double>(text.substr(0, comma));
        // Written so that NaN is refused, too.
        if (!value || !(std::abs(*value) <= std::numeric_limits<float>::max())) return std::nullopt;
        values.push_back(*value);
        if (comma == text.size()) return values;
        text.remove_prefix(comma + 1);
    }
}

std::string numberList(const auto& values) {
    return fmt::format("{}", fmt::join(values, ","));
}

/// Reads the text of an option; returns what would be right, or nothing if it is.
struct TextReader {
    std::string_view text;
    Shot& shot;
    const OptionRow& row;

    std::string operator()(const FlagValue& flag) const {
        flag.member.edit(shot) = flag.whenGiven;
        return {};
    }
    std::string operator()(const WholeValue& whole) const {
        const auto value = numberOf<int>(text);
        if (!value || *value < whole.least || *value > whole.most)
            return "a whole number from " + limits(row);
        whole.member.edit(shot) = *value;
        return {};
    }
    std::string operator()(const NumberValue& number) const {
        std::string_view digits = text;
        if (digits.ends_with(number.unit)) digits.remove_suffix(number.unit.size());
        const auto value = numberOf<double>(digits);
        // Written so that NaN is refused, too.
        if (!value || !(*value >= number.least && *value <= number.most))
            return fmt::format("a number from {}{}", limits(row),
                               number.unit.empty() ? "" : fmt::format(", as 0.25{}", number.unit));
        number.member.edit(shot) = *value;
        return {};
    }
    std::string operator()(const SizeValue& size) const {
        const std::size_t x = text.find('x');
        const auto width = numberOf<int>(text.substr(0, x));
        const auto height = x == text.npos ? std::nullopt : numberOf<int>(text.substr(x + 1));
        if (!width || !height || std::min(*width, *height) < 1 || std::max(*width, *height) > size.most)
            return fmt::format("WxH with 1 to {} pixels a side, as 800x600", size.most);
        size.width.edit(shot) = *width;
        size.height.edit(shot) = *height;
        return {};
    }
    std::string operator()(const WordValue& word) const {
        const auto found = std::ranges::find(word.words, text);
        if (found == word.words.end()) return fmt::format("{}", fmt::join(word.words, " or "));
        word.set(shot, static_cast<int>(found - word.words.begin()));
        return {};
    }
    std::string operator()(const UniformsValue& uniforms) const {
        uniforms.member.edit(shot).emplace_back(text);
        return {};
    }
    std::string operator()(const MatrixValue& matrix) const {
        return readMatrix(text, matrix.member.edit(shot));
    }
    std::string operator()(const ObjectsValue& objects) const {
        constexpr const char* kExpected = "LINE:M, the line of the object in the scene and a matrix";
        const std::size_t colon = text.find(':');
        const auto line = numberOf<int>(text.substr(0, colon));
        if (colon == text.npos || !line || *line < 1) return kExpected;
        ViewState::Object object{*line, kIdentity};
        std::string expected = readMatrix(text.substr(colon + 1), object.matrix);
        if (expected.empty()) objects.member.edit(shot).push_back(object);
        return expected;
    }
    std::string operator()(const ColorValue& color) const {
        const auto values = numbersOf(text);
        if (!values || (values->size() != 3 && values->size() != 4)) return "R,G,B or R,G,B,A, as 0,.5,1";
        color.member.edit(shot) = {(*values)[0], (*values)[1], (*values)[2],
                                   values->size() == 4 ? (*values)[3] : 1};
        return {};
    }
    std::string operator()(const MemoryValue& memory) const {
        const auto bytes = parseMemory(text);
        if (!bytes) return std::string(kMemoryForm);
        memory.member.edit(shot) = *bytes;
        return {};
    }
    std::string operator()(const FoldersValue& folders) const {
        if (text.empty()) return "a folder";
        folders.member.edit(shot).emplace_back(text);
        return {};
    }

  private:
    static std::string readMatrix(std::string_view text, Matrix& matrix) {
        const auto values = numbersOf(text);
        if (!values || values->size() != matrix.size())
            return "16 numbers separated by commas, column by column";
        std::ranges::copy(*values, matrix.begin());
        return {};
    }
};

/// The shortest text that parseMemory() reads as these bytes.
std::string memoryText(std::uint64_t bytes) {
    std::string unit;
    for (const char each : kUnits) {
        if (bytes == 0 || bytes % 1024 != 0) break;
        bytes /= 1024;
        unit = each;
    }
    return std::to_string(bytes) + unit;
}

/// The texts of an option's values, one for each time that the option is given.
struct TextWriter {
    using Texts = std::vector<std::string>;
    const Shot& shot;

    Texts operator()(const FlagValue&) const { return {""}; }
    Texts operator()(const WholeValue& whole) const { return {std::to_string(whole.member.get(shot))}; }
    Texts operator()(const NumberValue& number) const {
        return {fmt::format("{}{}", number.member.get(shot), number.unit)};
    }
    Texts operator()(const SizeValue& size) const {
        return {fmt::format("{}x{}", size.width.get(shot), size.height.get(shot))};
    }
    Texts operator()(const WordValue& word) const {
        return {std::string(word.words[static_cast<std::size_t>(word.get(shot))])};
    }
    Texts operator()(const UniformsValue& uniforms) const { return uniforms.member.get(shot); }
    Texts operator()(const MatrixValue& matrix) const { return {numberList(matrix.member.get(shot))}; }
    Texts operator()(const ObjectsValue& objects) const {
        Texts all;
        for (const ViewState::Object& each : objects.member.get(shot))
            all.push_back(fmt::format("{}:{}", each.line, numberList(each.matrix)));
        return all;
    }
    Texts operator()(const ColorValue& color) const {
        const std::array<double, 4> values = color.member.get(shot).value();
        return {numberList(std::span(values).first(values[3] == 1 ? 3 : 4))};
    }
    Texts operator()(const MemoryValue& memory) const {
        return {memoryText(memory.member.get(shot).value())};
    }
    Texts operator()(const FoldersValue& folders) const {
        Texts all;
        for (const std::filesystem::path& each : folders.member.get(shot))
            all.push_back(each.generic_string());
        return all;
    }
};

}  // namespace

std::optional<std::uint64_t> parseMemory(std::string_view text) {
    const std::size_t unit = text.empty() ? text.npos : kUnits.find(text.back());
    const auto number = numberOf<std::uint64_t>(text.substr(0, text.size() - (unit == text.npos ? 0 : 1)));
    const std::uint64_t shift = unit == text.npos ? 0 : 10 * (unit + 1);
    if (!number || *number > kMostMemory >> shift) return std::nullopt;
    const std::uint64_t bytes = *number << shift;
    if (bytes != 0 && bytes < kLeastMemory) return std::nullopt;
    return bytes;
}

std::string readOptionText(const OptionRow& row, std::string_view text, Shot& shot) {
    const std::string expected = std::visit(TextReader{text, shot, row}, row.value);
    return expected.empty() ? expected : fmt::format("expected {}, found {}", expected, glib::inQuotes(text));
}

std::vector<std::string> optionWords(const OptionRow& row, const Shot& shot) {
    if (row.name.empty() || isDefault(row, shot)) return {};
    if (const OptionRow* needed = findOption(row.needs); needed && isDefault(*needed, shot)) return {};
    std::vector<std::string> words;
    for (std::string& each : std::visit(TextWriter{shot}, row.value)) {
        words.push_back("--" + std::string(row.name));
        if (!std::holds_alternative<FlagValue>(row.value)) words.push_back(std::move(each));
    }
    return words;
}

std::string optionArguments(const Shot& shot) {
    std::string text;
    for (const OptionRow& row : optionTable())
        for (const std::string& word : optionWords(row, shot)) text += " " + shellWord(word);
    return text;
}

namespace {

namespace fs = std::filesystem;

std::string list(const auto& values) {
    return fmt::format("[{}]", fmt::join(values, ", "));
}

/// A key that needs no quotes is written without them.
std::string keyText(std::string_view key) {
    const bool isBare = !key.empty() && std::ranges::all_of(key, base::isOfName);
    return isBare ? std::string(key) : tomlText(key);
}

/// The right side of the line.
struct TomlWriter {
    const Shot& shot;
    const fs::path& folder;

    std::string operator()(const FlagValue& flag) const { return flag.member.get(shot) ? "true" : "false"; }
    std::string operator()(const WholeValue& whole) const { return std::to_string(whole.member.get(shot)); }
    std::string operator()(const NumberValue& number) const {
        return fmt::format("{}", number.member.get(shot));
    }
    std::string operator()(const SizeValue& size) const {
        return fmt::format("[{}, {}]", size.width.get(shot), size.height.get(shot));
    }
    std::string operator()(const WordValue& word) const {
        return tomlText(word.words[static_cast<std::size_t>(word.get(shot))]);
    }
    /// { uKd = "0.25", "Dots:uB" = true }. Where a name stands twice, the last value counts.
    std::string operator()(const UniformsValue& uniforms) const {
        const std::vector<std::string>& all = uniforms.member.get(shot);
        const auto nameOf = [](const std::string& each) { return each.substr(0, each.find('=')); };
        std::string text;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::string name = nameOf(all[i]);
            const bool comesAgain =
                std::any_of(all.begin() + static_cast<std::ptrdiff_t>(i) + 1, all.end(),
                            [&](const std::string& later) { return nameOf(later) == name; });
            if (comesAgain) continue;
            const std::string value = all[i].substr(std::min(name.size() + 1, all[i].size()));
            text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", keyText(name),
                                value == "true" || value == "false" ? value : tomlText(value));
        }
        return "{ " + text + " }";
    }
    std::string operator()(const MatrixValue& matrix) const { return list(matrix.member.get(shot)); }
    std::string operator()(const ObjectsValue& objects) const {
        std::string text;
        for (const ViewState::Object& each : objects.member.get(shot))
            text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", each.line, list(each.matrix));
        return "{ " + text + " }";
    }
    std::string operator()(const ColorValue& color) const { return list(color.member.get(shot).value()); }
    std::string operator()(const MemoryValue& memory) const {
        return tomlText(memoryText(memory.member.get(shot).value()));
    }
    std::string operator()(const FoldersValue& folders) const {
        std::string text;
        for (const fs::path& each : folders.member.get(shot))
            text += (text.empty() ? "" : ", ") + tomlText(each, folder);
        return "[" + text + "]";
    }
};

}  // namespace

std::string tomlText(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            result += {'\\', c};
        else if (byte < 0x20 || byte == 0x7F)
            result += fmt::format("\\u{:04X}", byte);
        else
            result += c;
    }
    return result + "\"";
}

std::string tomlText(const fs::path& file, const fs::path& folder) {
    const fs::path whole = system::realPath(file);
    const fs::path relative = whole.lexically_relative(system::realPath(folder));
    return tomlText((relative.empty() ? whole : relative).generic_string());
}

std::string optionLine(const OptionRow& row, const Shot& shot, const fs::path& folder) {
    if (row.key.empty() || isDefault(row, shot)) return {};
    return fmt::format("{} = {}\n", row.key, std::visit(TomlWriter{shot, folder}, row.value));
}

std::string optionLines(const Shot& shot, const fs::path& folder) {
    std::string text;
    for (const OptionRow& row : optionTable()) text += optionLine(row, shot, folder);
    return text;
}

namespace {

using image::Tolerance;

constexpr double kNoLimit = std::numeric_limits<double>::max();

constexpr std::array<ToleranceKey, 9> kKeys{{
    {"max", 255, [](const Tolerance& of) { return std::optional(of.largest); },
     [](Tolerance& to, double v) { to.largest = v; }},
    {"fraction", 1, [](const Tolerance& of) { return std::optional(of.fraction); },
     [](Tolerance& to, double v) { to.fraction = v; }},
    {"cluster", 1e9, [](const Tolerance& of) { return std::optional<double>(of.cluster); },
     [](Tolerance& to, double v) { to.cluster = static_cast<int>(v); }, true},
    {"line", 1e9, [](const Tolerance& of) { return std::optional<double>(of.line); },
     [](Tolerance& to, double v) { to.line = static_cast<int>(v); }, true},
    {"bias", 255, [](const Tolerance& of) { return std::optional(of.bias); },
     [](Tolerance& to, double v) { to.bias = v; }},
    {"flip", 1, [](const Tolerance& of) { return of.flip; }, [](Tolerance& to, double v) { to.flip = v; }},
    {"structure", 1, [](const Tolerance& of) { return of.structure; },
     [](Tolerance& to, double v) { to.structure = v; }},
    {"relative", kNoLimit, [](const Tolerance& of) { return std::optional(of.relative); },
     [](Tolerance& to, double v) { to.relative = v; }},
    {"absolute", kNoLimit, [](const Tolerance& of) { return std::optional(of.absolute); },
     [](Tolerance& to, double v) { to.absolute = v; }},
}};

}  // namespace

std::span<const ToleranceKey> toleranceKeys() {
    return kKeys;
}

std::string toleranceLine(const Tolerance& tolerance, bool isStated, bool isFloat) {
    const Tolerance usual;
    std::string line;
    for (const ToleranceKey& each : kKeys) {
        const std::optional<double> value = each.get(tolerance);
        const bool isOfFloats = each.key == "relative" || each.key == "absolute";
        const bool isOfBytes = each.key == "max" || each.key == "bias";
        const bool isNeeded = value != each.get(usual) || (isStated && !(isFloat ? isOfBytes : isOfFloats));
        if (value && isNeeded) line += fmt::format("{}{} = {}", line.empty() ? "" : ", ", each.key, *value);
    }
    return fmt::format("tolerance = {{ {} }}", line);
}

}  // namespace glibra::suite
