#include "glsl/emit/emitted_lines.h"

#include <algorithm>
#include <string_view>

namespace glibra::glsl {

std::vector<EmittedLine> emittedLines(const TranslatedStage& stage, const Place& place) {
    const LineMap& map = stage.lineMap;
    const auto file = std::ranges::find(map.files, place.file);
    if (file == map.files.end()) return {};
    const auto index = static_cast<int>(file - map.files.begin());
    std::vector<EmittedLine> lines;
    std::string_view rest = stage.source;
    for (std::size_t i = 0; i < map.lines.size() && !rest.empty(); ++i) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view text = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const bool isThere = map.lines[i].file == index && map.lines[i].line == place.line;
        const bool isBlank = text.find_first_not_of(" \t\r") == std::string_view::npos;
        if (isThere && !isBlank && !text.starts_with("#line"))
            lines.push_back({static_cast<int>(i) + 1, std::string(text)});
    }
    return lines;
}

}  // namespace glibra::glsl
