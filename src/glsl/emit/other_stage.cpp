#include "glsl/emit/other_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/text.h"
#include "glsl/read/token.h"

namespace glibra::glsl {
namespace {

/// A word of one stage alone (GLSL 4.60, 7.1 and 8), and the word of the scene language for that stage.
struct StageWord {
    std::string_view word;
    Stage stage;
    std::string_view command;
};
constexpr std::array kWords = std::to_array<StageWord>({
    {"EmitVertex", Stage::geometry, "Geometry"},
    {"EndPrimitive", Stage::geometry, "Geometry"},
    {"gl_out", Stage::tessControl, "TessControl"},
    {"gl_TessCoord", Stage::tessEvaluation, "TessEvaluation"},
    {"gl_GlobalInvocationID", Stage::compute, "Compute"},
    {"gl_LocalInvocationID", Stage::compute, "Compute"},
    {"gl_WorkGroupID", Stage::compute, "Compute"},
    {"gl_FragCoord", Stage::fragment, "Fragment"},
    {"gl_FragDepth", Stage::fragment, "Fragment"},
    {"gl_FrontFacing", Stage::fragment, "Fragment"},
    {"discard", Stage::fragment, "Fragment"},
    {"gl_VertexID", Stage::vertex, "Vertex"},
});
constexpr std::array<std::string_view, kStageCount> kStageNames{
    "vertex", "tessellation control", "tessellation evaluation", "geometry", "fragment", "compute"};

/// The place of the word in the text; npos if it is not there.
std::size_t findWord(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool begins = at == 0 || !base::isOfName(text[at - 1]);
        if (begins && (end == text.size() || !base::isOfName(text[end]))) return at;
    }
    return std::string_view::npos;
}

}  // namespace

std::optional<OtherStage> findOtherStage(const TranslatedStage& stage) {
    const std::string_view source = stage.source;
    const StageWord* first = nullptr;
    std::size_t at = std::string_view::npos;
    for (const StageWord& each : kWords) {
        if (each.stage == stage.stage) continue;
        if (const std::size_t found = findWord(source, each.word); found < at) {
            at = found;
            first = &each;
        }
    }
    if (first == nullptr) return std::nullopt;
    const std::string_view before = source.substr(0, at);
    const auto line = static_cast<std::size_t>(std::ranges::count(before, '\n'));
    const std::size_t start = before.rfind('\n') + 1;
    const auto nameOf = [](Stage of) { return kStageNames.at(static_cast<std::size_t>(of)); };
    return OtherStage{
        fmt::format("'{}' belongs to a {} stage, but this is a {} stage; if the whole text is one, "
                    "write '{}' before it",
                    first->word, nameOf(first->stage), nameOf(stage.stage), first->command),
        userPlace(stage, {line, static_cast<int>(at - start) + 1})};
}

}  // namespace glibra::glsl
