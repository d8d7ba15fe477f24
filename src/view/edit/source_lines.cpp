#include "view/edit/source_lines.h"

#include <algorithm>
#include <fstream>
#include <vector>

namespace glibra::view {

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
    const auto behind = std::upper_bound(starts.begin(), starts.end(), wanted) - starts.begin();
    const std::size_t marked = wanted >= line.size() ? count : static_cast<std::size_t>(behind) - 1;
    starts.push_back(line.size());
    const std::size_t all = std::max(count, marked + 1);  // the caret may be after the text
    const std::size_t first =
        all <= room ? 0 : std::min(marked > room / 2 ? marked - room / 2 : 0, all - room);
    const std::size_t end = std::min(count, first + room);
    // The column is in the middle, or nearer to an end of the line that is not cut.
    const bool isCutBefore = first > 0, isCutBehind = end < count;
    const std::size_t from = starts[first + (isCutBefore ? kLeftOut.size() : 0)];
    const std::size_t to = starts[end - (isCutBehind ? kLeftOut.size() : 0)];
    Excerpt shown;
    if (isCutBefore) shown.text = kLeftOut;
    shown.text += line.substr(from, to - from);
    if (isCutBehind) shown.text += kLeftOut;
    shown.caret = std::string(marked - first, ' ') + '^';
    return shown;
}

}  // namespace glibra::view
