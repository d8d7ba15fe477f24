#include "view/source_lines.h"

#include <algorithm>
#include <fstream>

namespace glibra::view {

std::string sourceLine(const Place& place) {
    constexpr std::size_t kMostShown = 200;
    std::ifstream file(place.file);
    std::string line;
    for (int i = 0; i < place.line; ++i)
        if (!std::getline(file, line)) return {};
    std::replace(line.begin(), line.end(), '\t', ' ');
    if (line.ends_with('\r')) line.pop_back();
    if (line.size() > kMostShown) line.resize(kMostShown);
    return line;
}

std::string caretLine(const std::string& line, int column) {
    const auto blanks =
        std::clamp<std::size_t>(static_cast<std::size_t>(std::max(column, 1)) - 1, 0, line.size());
    return std::string(blanks, ' ') + '^';
}

}  // namespace glibra::view
