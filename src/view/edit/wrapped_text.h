#pragma once
// A text whose long lines are broken into rows, for a widget that knows line feeds only.

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::view {

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
