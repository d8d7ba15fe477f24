#include "view/edit/wrapped_text.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace glibra::view {
namespace {

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
