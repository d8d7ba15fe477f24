#pragma once
// Sources as HTML, in the colours that the window's editor has.

#include <string>
#include <string_view>

#include "source/syntax.h"

namespace glibra::source {

/// A list item per line with its number in `data-line`; words are in <span class="keyword"> and the like. All
/// of the text is escaped.
std::string codeHtml(std::string_view text, CodeLanguage language);

}  // namespace glibra::source
