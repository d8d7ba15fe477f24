#include "view/edit/source_lines.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <ranges>
#include <span>
#include <utility>

#include "base/text.h"

namespace glibra::view {
namespace {

bool isOfWord(char c) {
    // Bytes of non-ASCII letters count as letters.
    return base::isOfName(c) || (static_cast<unsigned char>(c) & 0x80U) != 0;
}

bool standsAlone(std::string_view text, const TextRange& range) {
    const bool beginsInWord =
        range.begin > 0 && isOfWord(text[range.begin - 1]) && isOfWord(text[range.begin]);
    const bool endsInWord =
        range.end < text.size() && isOfWord(text[range.end]) && isOfWord(text[range.end - 1]);
    return !beginsInWord && !endsInWord;
}

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

using Lines = std::span<const std::string_view>;
constexpr std::string_view kAroundWords = " \t\r";

std::vector<std::string_view> trimmedLines(std::string_view text) {
    std::vector<std::string_view> lines;
    while (true) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        line.remove_prefix(std::min(line.find_first_not_of(kAroundWords), line.size()));
        line = line.substr(0, line.find_last_not_of(kAroundWords) + 1);
        lines.push_back(line);
        if (end == text.size()) return lines;
        text.remove_prefix(end + 1);
    }
}

std::string_view firstWord(std::string_view line) {
    return line.substr(0, line.find_first_of(kAroundWords));
}

/// By line of `before`: the index of the equal line of `after` in a longest common subsequence; -1: it has
/// none.
std::vector<int> commonLines(Lines before, Lines after) {
    std::vector<int> matched(before.size(), -1);
    const std::size_t columns = after.size() + 1;
    constexpr std::size_t kMost = 4'000'000;  // otherwise lines are known by their first words alone
    if (before.empty() || after.empty() || (before.size() + 1) * columns > kMost) return matched;
    // The length for the rests of both texts.
    std::vector<std::uint16_t> lengths((before.size() + 1) * columns, 0);
    for (std::size_t i = before.size(); i-- > 0;)
        for (std::size_t k = after.size(); k-- > 0;)
            lengths[i * columns + k] =
                before[i] == after[k]
                    ? static_cast<std::uint16_t>(lengths[(i + 1) * columns + k + 1] + 1)
                    : std::max(lengths[(i + 1) * columns + k], lengths[i * columns + k + 1]);
    for (std::size_t i = 0, k = 0; i < before.size() && k < after.size();) {
        if (before[i] == after[k])
            matched[i++] = static_cast<int>(k++);
        else if (lengths[(i + 1) * columns + k] >= lengths[i * columns + k + 1])
            ++i;
        else
            ++k;
    }
    return matched;
}

bool isInsideCharacter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

std::size_t nextCharacter(std::string_view text, std::size_t at) {
    do ++at;
    while (at < text.size() && isInsideCharacter(text[at]));
    return at;
}

std::size_t previousCharacter(std::string_view text, std::size_t at) {
    do --at;
    while (at > 0 && isInsideCharacter(text[at]));
    return at;
}

}  // namespace

std::vector<TextRange> findAll(std::string_view text, const TextSearch& search) {
    std::vector<TextRange> found;
    if (search.words.empty()) return found;
    const auto isSame = [&](char a, char b) {
        return search.matchesCase ? a == b : base::lower(a) == base::lower(b);
    };
    for (auto at = text.begin();;) {
        at = std::search(at, text.end(), search.words.begin(), search.words.end(), isSame);
        if (at == text.end()) return found;
        const auto begin = static_cast<std::size_t>(at - text.begin());
        const TextRange range{begin, begin + search.words.size()};
        const bool counts = !search.wholeWords || standsAlone(text, range);
        if (counts) found.push_back(range);
        at += counts ? static_cast<std::ptrdiff_t>(search.words.size()) : 1;
    }
}

std::size_t nextFound(const std::vector<TextRange>& found, std::size_t from) {
    const auto next = std::ranges::lower_bound(found, from, {}, &TextRange::begin);
    return next == found.end() && !found.empty() ? 0 : static_cast<std::size_t>(next - found.begin());
}

std::size_t previousFound(const std::vector<TextRange>& found, std::size_t from) {
    if (found.empty()) return 0;
    const auto next = std::ranges::lower_bound(found, from, {}, &TextRange::begin);
    return static_cast<std::size_t>((next == found.begin() ? found.end() : next) - found.begin()) - 1;
}

std::string replaced(std::string_view text, const std::vector<TextRange>& places, std::string_view by) {
    std::string result;
    std::size_t done = 0;
    for (const TextRange& each : places) {
        result += text.substr(done, each.begin - done);
        result += by;
        done = each.end;
    }
    return result += text.substr(done);
}

std::size_t endOfWord(std::string_view text, std::size_t at) {
    const auto kindOf = [](char letter) {
        if (letter == '\n') return 0;
        if (letter == ' ' || letter == '\t') return 1;
        const bool isName = letter == '_' || static_cast<unsigned char>(letter) >= 0x80U ||
                            std::isalnum(static_cast<unsigned char>(letter)) != 0;
        return isName ? 2 : 3;
    };
    const auto skip = [&](int kind) {
        while (at < text.size() && kindOf(text[at]) == kind) ++at;
    };
    if (at < text.size() && text[at] == '\n') return at + 1;
    skip(1);
    if (at < text.size() && text[at] != '\n') skip(kindOf(text[at]));
    return at;
}

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

std::string sourceLine(const Place& place) {
    std::ifstream file(place.file);
    std::string line;
    for (int i = 0; i < place.line; ++i)
        if (!std::getline(file, line)) return {};
    std::replace(line.begin(), line.end(), '\t', ' ');
    if (line.ends_with('\r')) line.pop_back();
    return line;
}

Excerpt excerpt(std::string_view line, int column, int most) {
    constexpr std::size_t kLeast = 12;
    constexpr std::string_view kLeftOut = "...";
    const auto room = std::max(kLeast, static_cast<std::size_t>(std::max(0, most)));
    const auto wanted = static_cast<std::size_t>(std::max(column, 1)) - 1;
    std::vector<std::size_t> starts;  // byte offsets of the characters
    for (std::size_t i = 0; i < line.size(); ++i)
        if (i == 0 || (static_cast<unsigned char>(line[i]) & 0xC0U) != 0x80U) starts.push_back(i);
    const std::size_t count = starts.size();
    const auto after = std::upper_bound(starts.begin(), starts.end(), wanted) - starts.begin();
    const std::size_t marked = wanted >= line.size() ? count : static_cast<std::size_t>(after) - 1;
    starts.push_back(line.size());
    const std::size_t all = std::max(count, marked + 1);  // the caret may be after the text
    const std::size_t first =
        all <= room ? 0 : std::min(marked > room / 2 ? marked - room / 2 : 0, all - room);
    const std::size_t end = std::min(count, first + room);
    // The column is in the middle, or nearer to an end of the line that is not cut.
    const bool isCutBefore = first > 0, isCutAfter = end < count;
    const std::size_t from = starts[first + (isCutBefore ? kLeftOut.size() : 0)];
    const std::size_t to = starts[end - (isCutAfter ? kLeftOut.size() : 0)];
    Excerpt shown;
    if (isCutBefore) shown.text = kLeftOut;
    shown.text += line.substr(from, to - from);
    if (isCutAfter) shown.text += kLeftOut;
    shown.caret = std::string(marked - first, ' ') + '^';
    return shown;
}

int movedLine(std::string_view before, std::string_view after, int line) {
    const std::vector<std::string_view> old = trimmedLines(before), now = trimmedLines(after);
    if (line < 1 || static_cast<std::size_t>(line) > old.size()) return 0;
    const std::size_t wanted = static_cast<std::size_t>(line) - 1;
    const std::size_t least = std::min(old.size(), now.size());
    std::size_t first = 0, last = 0;  // as many lines are equal at the beginning and at the end
    while (first < least && old[first] == now[first]) ++first;
    while (last < least - first && old[old.size() - 1 - last] == now[now.size() - 1 - last]) ++last;
    if (wanted < first) return line;
    if (wanted >= old.size() - last) return static_cast<int>(now.size() - (old.size() - wanted)) + 1;
    const Lines oldRest = Lines(old).subspan(first, old.size() - first - last);
    const Lines nowRest = Lines(now).subspan(first, now.size() - first - last);
    const std::vector<int> matched = commonLines(oldRest, nowRest);
    const std::size_t at = wanted - first;
    const auto place = [&](std::size_t index) { return static_cast<int>(first + index) + 1; };
    if (matched[at] >= 0) return place(static_cast<std::size_t>(matched[at]));
    // Between the neighbours that stay.
    std::size_t begin = at, end = at;
    while (begin > 0 && matched[begin - 1] < 0) --begin;
    while (end < oldRest.size() && matched[end] < 0) ++end;
    const std::size_t from = begin == 0 ? 0 : static_cast<std::size_t>(matched[begin - 1]) + 1;
    const std::size_t to = end == oldRest.size() ? nowRest.size() : static_cast<std::size_t>(matched[end]);
    const auto isAlike = [&](std::string_view each) { return firstWord(each) == firstWord(oldRest[at]); };
    auto order = std::count_if(oldRest.begin() + static_cast<std::ptrdiff_t>(begin),
                               oldRest.begin() + static_cast<std::ptrdiff_t>(at), isAlike);
    for (std::size_t i = from; i < to; ++i)
        if (isAlike(nowRest[i]) && order-- == 0) return place(i);
    return 0;
}

std::vector<std::size_t> breaksOf(std::string_view text, float room, float widest,
                                  const std::function<float(std::string_view)>& widthOf) {
    std::vector<std::size_t> breaks;
    const float tab = widthOf("\t");
    for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
        end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        const auto tabs = static_cast<float>(std::ranges::count(line, '\t'));
        if (static_cast<float>(line.size()) * widest + tabs * tab <= room) continue;
        std::size_t row = begin, afterBlank = begin;
        float wide = 0;
        for (std::size_t at = begin, next = 0; at < end; at = next) {
            next = std::min(nextCharacter(text, at), end);
            const bool isBlank = text[at] == ' ' || text[at] == '\t';
            const float width = widthOf(text.substr(at, next - at));
            // A blank after a word may stand in the margin.
            if (at > row && wide + (isBlank ? 0 : width) > room) {
                row = afterBlank > row ? afterBlank : at;
                breaks.push_back(row);
                wide = 0;
                for (std::size_t i = row; i < at; i = nextCharacter(text, i))
                    wide += widthOf(text.substr(i, nextCharacter(text, i) - i));
            }
            wide += width;
            if (isBlank) afterBlank = next;
        }
    }
    return breaks;
}

WrappedText::WrappedText(std::string_view ofText, std::vector<std::size_t> withBreaks)
    : text(ofText), breaks(std::move(withBreaks)) {
    rows.reserve(text.size() + breaks.size());
    std::size_t begin = 0;
    for (const std::size_t each : breaks) {
        rows.append(text, begin, each - begin).push_back('\n');
        begin = each;
    }
    rows.append(text, begin);
}

std::size_t WrappedText::placeInRows(std::size_t at) const {
    return at + static_cast<std::size_t>(std::ranges::upper_bound(breaks, at) - breaks.begin());
}

std::size_t WrappedText::placeInText(std::size_t at) const {
    // The line feed of break i stands at breaks[i] + i.
    std::size_t low = 0, high = breaks.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (breaks[middle] + middle < at)
            low = middle + 1;
        else
            high = middle;
    }
    return at - low;
}

EditedRows::EditedRows(const WrappedText& before, std::string_view now, std::size_t cursor,
                       std::size_t cursorNow, bool hadSelection)
    : before_(before) {
    const std::string_view old = before.rows;
    const std::size_t common = std::min(old.size(), now.size());
    // An edit begins at the cursor or before it and ends at the cursor after it: beside a break the rows
    // alone do not tell which line feed was typed.
    const auto least = static_cast<std::ptrdiff_t>(std::min(common, cursor));
    begin_ = static_cast<std::size_t>(std::mismatch(old.begin(), old.begin() + least, now.begin()).first -
                                      old.begin());
    std::size_t after = 0;
    while (after < common - begin_ && old[old.size() - 1 - after] == now[now.size() - 1 - after]) ++after;
    const std::size_t afterCursor = now.size() - std::min(cursorNow, now.size());
    if (now != old && afterCursor < after) {
        const std::size_t end = old.size() - afterCursor;
        const std::size_t taken = end - (old.size() - after);
        const bool isOneBreak =
            taken - (before.placeInText(end) - before.placeInText(old.size() - after)) == 1;
        if (isOneBreak) after = afterCursor;
    }
    end_ = old.size() - after;
    added_ = now.size() - after - begin_;
    from_ = before.placeInText(begin_);
    to_ = before.placeInText(end_);
    if (added_ == 0 && end_ > begin_ && from_ == to_ && !hadSelection) {
        if (cursor >= end_)
            from_ = previousCharacter(before.text, from_);
        else
            to_ = nextCharacter(before.text, to_);
    }
    text_ = before.text.substr(0, from_);
    text_.append(now, begin_, added_).append(before.text, to_);
}

std::size_t EditedRows::placeInText(std::size_t at) const {
    if (at < begin_) return std::min(before_.placeInText(at), from_);
    if (at <= begin_ + added_) return from_ + (at - begin_);
    const std::size_t old = std::max(before_.placeInText(at - begin_ - added_ + end_), to_);
    return old - to_ + from_ + added_;
}

}  // namespace glibra::view
