#pragma once
// Texts as words of a command line.

#include <algorithm>
#include <string>
#include <string_view>

#include "base/text.h"

namespace glibra::base {

/// In single quotes of a POSIX shell.
inline std::string shellQuoted(std::string_view text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

/// As one word of a POSIX shell; quoted only where it has to be: if it has other characters than letters,
/// digits and those of `plain`.
inline std::string shellWord(std::string_view text, std::string_view plain = "_-+=./,:@%") {
    const auto isPlain = [&](char c) { return isLetter(c) || isDigit(c) || plain.find(c) != plain.npos; };
    const bool needsNone = !text.empty() && std::all_of(text.begin(), text.end(), isPlain);
    return needsNone ? std::string(text) : shellQuoted(text);
}

}  // namespace glibra::base
