#pragma once
// A widget for the text of a program: line numbers, colours, marked lines.

#include <glibra/diagnostic.h>

#include <optional>
#include <span>
#include <string>

#include "view/code_paint.h"

namespace glibra::view {

/// A message about a line, counted from 1.
struct CodeMark {
    int line = 1;
    Severity severity = Severity::error;
    std::string text;
};

/// What the widget keeps of one text from frame to frame.
struct CodeView {
    int line = 1, column = 1;          ///< of the cursor; columns count characters
    bool isActive = false;             ///< it has the keyboard
    std::optional<int> goTo;           ///< a line that is to be shown, and to get the cursor
    int generation = 0;                ///< counted up when somebody else than the widget changes the text
    int cursor = 0, previousSize = 0;  ///< bytes
    float height = 0;                  ///< of what was seen
};

/// Fills what is left of the current window but `below` pixels. True if the user changed the text. `name`
/// tells widgets apart.
bool codeEditor(const char* name, std::string& text, CodeView& view, std::span<const CodeMark> marks,
                Dialect dialect, bool isReadOnly, float below);

}  // namespace glibra::view
