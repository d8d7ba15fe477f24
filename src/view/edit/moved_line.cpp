#include "view/edit/moved_line.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glibra::view {
namespace {

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

}  // namespace

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

}  // namespace glibra::view
