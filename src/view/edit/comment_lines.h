#pragma once
// Makes lines comments and back.

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

}  // namespace glibra::view
