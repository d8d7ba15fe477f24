#pragma once
// Finding and replacing in a text.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::view {

/// Bytes from the beginning of a text.
struct TextRange {
    std::size_t begin = 0, end = 0;
    friend bool operator==(const TextRange&, const TextRange&) = default;
};

struct TextSearch {
    std::string words;         ///< taken as they are
    bool matchesCase = false;  ///< else the letters A to Z are the same as a to z
    bool wholeWords = false;   ///< no letter, digit or '_' before and behind
};

/// Every place of it, in order; they do not overlap. None of an empty text.
std::vector<TextRange> findAll(std::string_view text, const TextSearch& search);

/// The first of them that begins at `from` or behind it, and else the first of all; their number if there is
/// none.
std::size_t nextFound(const std::vector<TextRange>& found, std::size_t from);
/// The last of them that begins before `from`, and else the last of all; 0 if there is none.
std::size_t previousFound(const std::vector<TextRange>& found, std::size_t from);

/// The text with each of these places, as findAll gives them, replaced.
std::string replaced(std::string_view text, const std::vector<TextRange>& places, std::string_view by);

}  // namespace glibra::view
