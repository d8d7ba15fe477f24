#include "view/edit/save_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "image/file.h"

namespace glibra::view {
namespace {

struct Replacement {
    std::size_t begin = 0, end = 0;
    std::string text;
};

/// The byte offset of a line and column, both counted from 1. Lines end with LF, CR LF or CR.
std::optional<std::size_t> offsetOf(std::string_view text, const Place& place) {
    std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    for (int line = 1; line < place.line; ++line) {
        at = text.find_first_of("\r\n", at);
        if (at == std::string_view::npos) return std::nullopt;
        at += text.substr(at, 2) == "\r\n" ? 2 : 1;
    }
    at += static_cast<std::size_t>(place.column - 1);
    return at < text.size() ? std::optional(at) : std::nullopt;
}

/// The end of the value that begins at `begin`: after its closing bracket, or at the end of the number.
std::optional<std::size_t> valueEnd(std::string_view text, std::size_t begin) {
    constexpr std::string_view kOpening = "<[{(";
    constexpr std::string_view kClosing = ">]})";
    if (kOpening.find(text[begin]) != std::string_view::npos) {
        const std::size_t end = text.find_first_of(">]})#", begin);
        if (end == std::string_view::npos || kClosing.find(text[end]) == std::string_view::npos)
            return std::nullopt;
        return end + 1;
    }
    const std::size_t end = text.find_first_of(" \t\v\f\r\n<>[]{}()#\"", begin);
    return std::min(end, text.size());
}

}  // namespace

Result<std::string> withValues(std::string_view text, std::span<const Knob> knobs) {
    std::vector<Replacement> replacements;
    for (const Knob& each : knobs) {
        if (!each.isChanged() || !each.words.empty()) continue;
        const auto begin = offsetOf(text, each.place);
        const auto end = begin ? valueEnd(text, *begin) : std::nullopt;
        if (!end)
            return diagnose(
                "view-E01",
                fmt::format("the value of '{}' is no longer at this place; reload the scene", each.tag),
                each.place);
        replacements.push_back({*begin, *end, valueText(each)});
    }
    std::sort(replacements.begin(), replacements.end(),
              [](const Replacement& a, const Replacement& b) { return a.begin > b.begin; });
    std::string result(text);
    for (const Replacement& each : replacements) result.replace(each.begin, each.end - each.begin, each.text);
    return result;
}

Diagnostics saveValues(const std::filesystem::path& scene, std::span<const Knob> knobs) {
    const auto bytes = image::readFile(scene, {scene.string(), {scene.string(), 1, 1}});
    if (!bytes) return bytes.diagnostics;
    const Result<std::string> text =
        withValues({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, knobs);
    if (!text) return text.diagnostics;
    return image::writeFileAtomically(scene, std::as_bytes(std::span(*text)));
}

}  // namespace glibra::view
