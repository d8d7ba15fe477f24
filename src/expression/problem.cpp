#include "expression/problem.h"

#include <algorithm>

namespace glibra::expression {
namespace {

bool isContinuationByte(char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
}

}  // namespace

Place placeAt(std::string_view text, std::size_t offset, const Place& origin) {
    Place place = origin;
    offset = std::min(offset, text.size());
    for (std::size_t i = 0; i < offset; ++i) {
        const bool ends = text[i] == '\n' || (text[i] == '\r' && text.substr(i + 1, 1) != "\n");
        place.line += ends ? 1 : 0;
        place.column = ends ? 1 : place.column + 1;
    }
    return place;
}

std::string quoted(std::string_view text, Range range) {
    constexpr std::size_t kShown = 60;
    constexpr std::size_t kHalf = 28;
    const std::size_t begin = std::min<std::size_t>(range.begin, text.size());
    std::string part(text.substr(begin, range.end - std::min<std::size_t>(begin, range.end)));
    if (part.size() > kShown) {
        std::size_t left = kHalf;
        std::size_t right = part.size() - kHalf;
        while (left > 0 && isContinuationByte(part[left])) --left;
        while (right < part.size() && isContinuationByte(part[right])) ++right;
        part = part.substr(0, left) + "..." + part.substr(right);
    }
    for (char& c : part)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    return "'" + part + "'";
}

}  // namespace glibra::expression
