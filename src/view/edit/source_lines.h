#pragma once
// Lines and words of a source as an editor changes them.

#include <glibra/diagnostic.h>

#include <string>
#include <string_view>

#include "editor/completion.h"
#include "editor/declared_names.h"
#include "editor/reference.h"
#include "view/edit/text_search.h"

namespace glibra::view {

// The names of the room `editor` that the window's editor uses: words to propose, and their reference.

using editor::callAt;
using editor::CallHint;
using editor::CodeContext;
using editor::Completion;
using editor::completionsAt;
using editor::KnownName;
using editor::LanguageAt;
using editor::languageAt;
using editor::nameNear;
using editor::referenceAt;
using editor::ReferenceEntry;
using editor::referenceOf;
using editor::SignatureParts;
using editor::wordAt;
using editor::wordBefore;

// Changes of the lines that are selected: comments and back, more or less indented.

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

// The source line of a message.

/// The line as it is in the file now, without its end, with each tab as one blank. Empty if the file has no
/// such line.
std::string sourceLine(const Place& place);

/// The part of a line that fits into the available width, with a caret line below it.
struct Excerpt {
    std::string text;
    std::string caret;  ///< blanks up to the column and '^'
};

/// The line, with a caret under the byte at `column` (counted from 1; a column past the end puts the caret
/// after the line). If the line is longer than `most` UTF-8 characters (at least 12), only the part around
/// the column is shown, with "..." in place of the rest.
Excerpt excerpt(std::string_view line, int column, int most);

// Finds a line of a text again after an edit.

/// Where the line `line` (counted from 1) of the text `before` stands in the text `after`; 0 if it is gone.
/// Lines are known by their words; blanks at both ends do not count. A line that was edited is the one
/// between the same neighbours that begins with the same word, in order.
int movedLine(std::string_view before, std::string_view after, int line);

}  // namespace glibra::view
