#pragma once
// Lines and words of a source, as an editor finds and changes them.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/completion.h"
#include "editor/declared_names.h"
#include "editor/reference.h"
#include "editor/text_range.h"

namespace glibra::view {

// Find and replace in a text.

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

// A text whose long lines are broken into rows, for a widget that knows line feeds only.

/// The bytes of the text, ascending, at which a row begins inside of a line, so that no row is wider than
/// `room`: after the last blank that is not too far, or inside of a word that is wider than a row.
/// `widthOf` is that of a character; besides tabs, none is wider than `widest` for each of its bytes.
std::vector<std::size_t> breaksOf(std::string_view text, float room, float widest,
                                  const std::function<float(std::string_view)>& widthOf);

/// A text and its rows. A byte of the text that a row begins with has two places in the rows: before and
/// after the line feed of its break.
struct WrappedText {
    std::string text, rows;  ///< `rows` has a line feed more at each break
    std::vector<std::size_t> breaks;

    WrappedText() = default;
    WrappedText(std::string_view ofText, std::vector<std::size_t> withBreaks);
    /// The place in the rows, after the break.
    [[nodiscard]] std::size_t placeInRows(std::size_t at) const;
    [[nodiscard]] std::size_t placeInText(std::size_t at) const;
};

/// What an edit of the rows makes of the text.
class EditedRows {
  public:
    /// `now`: the rows after the edit; `cursor` and `cursorNow`: the places in the rows before and after it.
    /// Who removes the line feed of a break alone, with nothing selected, means the character beside it.
    EditedRows(const WrappedText& before, std::string_view now, std::size_t cursor, std::size_t cursorNow,
               bool hadSelection);
    [[nodiscard]] const std::string& text() const { return text_; }
    /// The place in the text of one in the edited rows.
    [[nodiscard]] std::size_t placeInText(std::size_t at) const;

  private:
    const WrappedText& before_;
    std::string text_;
    std::size_t begin_ = 0, end_ = 0, added_ = 0;  ///< rows begin_ to end_ were replaced by so many bytes
    std::size_t from_ = 0, to_ = 0;                ///< the same of the text
};

}  // namespace glibra::view
