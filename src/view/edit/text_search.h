#pragma once
// Find and replace in a text.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "editor/text_range.h"

namespace glibra::view {

using editor::TextRange;

struct TextSearch {
    std::string words;         ///< searched literally
    bool matchesCase = false;  ///< if false, A to Z equal a to z
    bool wholeWords = false;   ///< no letter, digit or '_' directly before or after
};

/// All matches in order, without overlap. An empty search has no matches.
std::vector<TextRange> findAll(std::string_view text, const TextSearch& search);

/// The index of the first match that begins at or after `from`; without one, the first match. Returns
/// found.size() if there are no matches.
std::size_t nextFound(const std::vector<TextRange>& found, std::size_t from);
/// The index of the last match that begins before `from`; without one, the last match. Returns 0 if there are
/// no matches.
std::size_t previousFound(const std::vector<TextRange>& found, std::size_t from);

/// The text with each match, as findAll returns them, replaced by `by`.
std::string replaced(std::string_view text, const std::vector<TextRange>& places, std::string_view by);

/// The end of the word that begins at that byte, after blanks: a run of letters, digits and '_', or of other
/// signs. At the end of a line, the beginning of the next one.
std::size_t endOfWord(std::string_view text, std::size_t at);

}  // namespace glibra::view
