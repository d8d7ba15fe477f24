#include "view/edit/text_search.h"

#include <algorithm>
#include <cctype>

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

}  // namespace glibra::view
