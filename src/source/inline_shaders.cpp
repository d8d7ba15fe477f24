#include "source/inline_shaders.h"

#include <algorithm>
#include <array>
#include <utility>

#include "glib/text.h"

namespace glibra::source {
namespace {

/// Removes the next word from the line and returns it; a comment has no words.
std::string_view takeWord(std::string_view& line) {
    constexpr std::string_view kBlanks = " \t\r";
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    line = line.substr(0, line.find('#'));
    const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
    line.remove_prefix(word.size());
    return word;
}

constexpr std::string_view kEnd = "End";
constexpr std::array<std::pair<std::string_view, glsl::Stage>, 6> kStages{
    {{"Vertex", glsl::Stage::vertex},
     {"TessControl", glsl::Stage::tessControl},
     {"TessEvaluation", glsl::Stage::tessEvaluation},
     {"Geometry", glsl::Stage::geometry},
     {"Fragment", glsl::Stage::fragment},
     {"Compute", glsl::Stage::compute}}};

std::optional<glsl::Stage> stageOfWord(std::string_view word) {
    for (const auto& [name, stage] : kStages)
        if (glib::sameWord(word, name)) return stage;
    return std::nullopt;
}

}  // namespace

std::string endWordOf(glsl::Stage stage) {
    const auto* const row =
        std::find_if(kStages.begin(), kStages.end(), [&](const auto& each) { return each.second == stage; });
    return std::string(kEnd) + std::string(row->first);
}

std::optional<glsl::Stage> stageOfEndWord(std::string_view word) {
    if (word.size() <= kEnd.size() || !glib::sameWord(word.substr(0, kEnd.size()), kEnd)) return std::nullopt;
    return stageOfWord(word.substr(kEnd.size()));
}

std::optional<glsl::Stage> InlineShaders::next(std::string_view line) {
    if (stage_) {
        const std::string_view word = takeWord(line);
        const bool isEnd = isShared_ ? glib::sameWord(word, "EndGlsl") : stageOfEndWord(word) == stage_;
        if (!isEnd || !takeWord(line).empty()) return stage_;
        stage_.reset();
        return std::nullopt;
    }
    const std::string_view word = takeWord(line);
    isShared_ = glib::sameWord(word, "Glsl");
    if (isShared_) takeWord(line);  // its name
    const std::optional<glsl::Stage> begun =
        isShared_ ? std::optional(glsl::Stage::fragment) : stageOfWord(word);
    if (begun && glib::sameWord(takeWord(line), "inline")) stage_ = begun;
    return std::nullopt;
}

}  // namespace glibra::source
