#pragma once
// Letters and words of the language are those of all texts.

#include <algorithm>
#include <string_view>

#include "base/text.h"

namespace glibra::glib {

using base::beginsName;
using base::inQuotes;
using base::isDigit;
using base::isLetter;
using base::isOfName;
using base::lower;
using base::sameWord;

/// True if the word is one of these, in any case.
template <class Words>
bool isAmong(std::string_view word, const Words& words) {
    return std::ranges::any_of(words, [&](std::string_view each) { return sameWord(each, word); });
}

/// True for letters, digits and _, the first no digit.
inline bool isIdentifier(std::string_view text) {
    return !text.empty() && beginsName(text.front()) && std::ranges::all_of(text, isOfName);
}

}  // namespace glibra::glib
