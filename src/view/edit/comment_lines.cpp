#include "view/edit/comment_lines.h"

#include <algorithm>
#include <ranges>
#include <vector>

namespace glibra::view {

EditedText toggledComments(std::string_view text, const TextRange& selection, std::string_view marker) {
    const std::size_t size = text.size();
    const TextRange selected{std::min(selection.begin, size), std::min(selection.end, size)};
    const std::size_t before =
        selected.begin == 0 ? std::string_view::npos : text.rfind('\n', selected.begin - 1);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    // Lines from `begin` to `end`, which is the end of the last one.
    std::size_t last = selected.end;
    if (last > selected.begin && last > 0 && text[last - 1] == '\n') --last;
    const std::size_t end = std::min(text.find('\n', last), size);

    constexpr std::size_t kNone = std::string_view::npos;
    struct Line {
        std::size_t begin = 0, first = 0;  // its first letter
    };
    std::vector<Line> lines;  // that are not blank
    std::size_t column = kNone;
    bool areComments = true;
    for (std::size_t line = begin; line <= end;) {
        const std::size_t lineEnd = std::min(text.find('\n', line), size);
        const std::size_t first = text.find_first_not_of(" \t", line);
        if (first != kNone && first < lineEnd) {
            lines.push_back({line, first});
            column = std::min(column, first - line);
            areComments = areComments && text.substr(first).starts_with(marker);
        }
        line = lineEnd + 1;
    }
    EditedText result{std::string(text), selected};
    if (lines.empty()) return result;
    const std::string added = std::string(marker) + " ";
    // From the last line to the first, so that earlier offsets stay valid.
    for (const Line& line : std::ranges::reverse_view(lines)) {
        const std::size_t at = areComments ? line.first : line.begin + column;
        const std::size_t removed =
            !areComments ? 0 : marker.size() + (text.substr(at + marker.size()).starts_with(' ') ? 1 : 0);
        const std::string inserted = areComments ? std::string() : added;
        result.text.replace(at, removed, inserted);
        for (std::size_t* edge : {&result.selection.begin, &result.selection.end}) {
            if (*edge < at || (*edge == at && edge == &result.selection.begin)) continue;
            *edge = *edge < at + removed ? at : *edge - removed + inserted.size();
        }
    }
    if (selected.begin == selected.end) result.selection.begin = result.selection.end;
    return result;
}

}  // namespace glibra::view
