#include "view/edit/selected_lines.h"

#include <algorithm>
#include <ranges>
#include <vector>

namespace glibra::view {

namespace {

constexpr std::size_t kNone = std::string_view::npos;
constexpr std::size_t kIndent = 4;

struct Line {
    std::size_t begin = 0, first = 0;  ///< its first letter
};

TextRange inside(std::string_view text, const TextRange& selection) {
    return {std::min(selection.begin, text.size()), std::min(selection.end, text.size())};
}

std::size_t beginOfLine(std::string_view text, std::size_t at) {
    const std::size_t before = at == 0 ? kNone : text.rfind('\n', at - 1);
    return before == kNone ? 0 : before + 1;
}

/// The lines of the selection that are not blank. The last one does not count if nothing of it is selected.
std::vector<Line> linesOf(std::string_view text, const TextRange& selected) {
    std::size_t last = selected.end;
    if (last > selected.begin && last > 0 && text[last - 1] == '\n') --last;
    const std::size_t end = std::min(text.find('\n', last), text.size());
    std::vector<Line> lines;
    for (std::size_t line = beginOfLine(text, selected.begin); line <= end;) {
        const std::size_t lineEnd = std::min(text.find('\n', line), text.size());
        const std::size_t first = text.find_first_not_of(" \t", line);
        if (first != kNone && first < lineEnd) lines.push_back({line, first});
        line = lineEnd + 1;
    }
    return lines;
}

/// Replaces text of a line. Changes go from the last line to the first, so that earlier offsets stay valid.
void change(EditedText& edited, std::size_t at, std::size_t removed, const std::string& inserted) {
    edited.text.replace(at, removed, inserted);
    for (std::size_t* edge : {&edited.selection.begin, &edited.selection.end}) {
        if (*edge < at || (*edge == at && edge == &edited.selection.begin)) continue;
        *edge = *edge < at + removed ? at : *edge - removed + inserted.size();
    }
}

}  // namespace

EditedText indentedLines(std::string_view text, const TextRange& selection, bool back) {
    const TextRange selected = inside(text, selection);
    EditedText result{std::string(text), selected};
    if (selected.begin == selected.end && !back) {
        const std::size_t column = selected.begin - beginOfLine(text, selected.begin);
        const std::string blanks(kIndent - column % kIndent, ' ');
        result.text.insert(selected.begin, blanks);
        result.selection.begin = result.selection.end = selected.begin + blanks.size();
        return result;
    }
    std::vector<Line> lines = linesOf(text, selected);
    // The blanks of an empty line move, too, if the cursor is there.
    if (lines.empty()) lines.push_back({beginOfLine(text, selected.begin), selected.end});
    for (const Line& each : std::ranges::reverse_view(lines)) {
        if (!back) {
            change(result, each.begin, 0, std::string(kIndent, ' '));
            continue;
        }
        std::size_t removed = 0;
        while (removed < kIndent && each.begin + removed < each.first && text[each.begin + removed] == ' ')
            ++removed;
        if (removed == 0 && each.begin < each.first && text[each.begin] == '\t') removed = 1;
        change(result, each.begin, removed, {});
    }
    if (selected.begin == selected.end) result.selection.begin = result.selection.end;
    return result;
}

EditedText toggledComments(std::string_view text, const TextRange& selection, std::string_view marker) {
    const TextRange selected = inside(text, selection);
    const std::vector<Line> lines = linesOf(text, selected);
    EditedText result{std::string(text), selected};
    if (lines.empty()) return result;
    std::size_t column = kNone;
    bool areComments = true;
    for (const Line& each : lines) {
        column = std::min(column, each.first - each.begin);
        areComments = areComments && text.substr(each.first).starts_with(marker);
    }
    const std::string added = std::string(marker) + " ";
    for (const Line& line : std::ranges::reverse_view(lines)) {
        const std::size_t at = areComments ? line.first : line.begin + column;
        const std::size_t removed =
            !areComments ? 0 : marker.size() + (text.substr(at + marker.size()).starts_with(' ') ? 1 : 0);
        change(result, at, removed, areComments ? std::string() : added);
    }
    if (selected.begin == selected.end) result.selection.begin = result.selection.end;
    return result;
}

}  // namespace glibra::view
