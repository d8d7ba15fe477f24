#pragma once
// The lines of a text as editors count them: from 0, ended by LF, CR LF or CR; places in a line in units of
// UTF-16. A byte that is no UTF-8 is one unit.

#include <cstddef>
#include <string_view>
#include <vector>

#include "editor/text_range.h"

namespace glibra::editor {

struct TextPosition {
    std::size_t line = 0;
    std::size_t unit = 0;  ///< of UTF-16, in the line
    friend bool operator==(const TextPosition&, const TextPosition&) = default;
};

class TextLines {
  public:
    /// The text must outlive the object.
    explicit TextLines(std::string_view text);

    [[nodiscard]] std::size_t count() const { return begins_.size(); }
    /// Without its line end; empty beyond the last line.
    [[nodiscard]] TextRange line(std::size_t index) const;
    /// The place of a byte; the end of the text for bytes beyond it.
    [[nodiscard]] TextPosition position(std::size_t byte) const;
    /// The byte at a place; the end of its line, or of the text, for places beyond it.
    [[nodiscard]] std::size_t byte(TextPosition position) const;

  private:
    std::string_view text_;
    std::vector<std::size_t> begins_;
};

}  // namespace glibra::editor
