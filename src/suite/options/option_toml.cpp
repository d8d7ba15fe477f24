#include "suite/options/option_toml.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <system_error>

#include "base/text.h"
#include "suite/options/option_words.h"

namespace glibra::suite {
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
    std::error_code failure;
    const fs::path whole = fs::weakly_canonical(file, failure);
    const fs::path relative = whole.lexically_relative(fs::weakly_canonical(folder, failure));
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

}  // namespace glibra::suite
