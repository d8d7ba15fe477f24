#pragma once
// Changes of the lines that are selected: comments and back, more or less indented.

#include <string>
#include <string_view>

#include "view/edit/text_search.h"

namespace glibra::view {

struct EditedText {
    std::string text;
    TextRange selection;
};

/// Puts the marker ("//" or "#") with a blank before the first letter of all selected lines, in one column.
/// If all of them that are not blank begin with the marker, it is removed instead, with one blank after it.
/// The last line does not count if the selection ends before its first letter. The selection stays on the
/// same letters.
EditedText toggledComments(std::string_view text, const TextRange& selection, std::string_view marker);

/// Moves all selected lines that are not blank to the right by four blanks, or `back` by four at most.
/// Without a selection blanks at the cursor lead to the next column that is a multiple of four; `back`, the
/// line moves. The selection stays on the same letters.
EditedText indentedLines(std::string_view text, const TextRange& selection, bool back);

}  // namespace glibra::view
