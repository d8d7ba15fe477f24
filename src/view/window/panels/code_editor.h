#pragma once
// A widget that edits code, with line numbers, syntax colours and marked lines.

#include <string>

#include "view/edit/source_files.h"
#include "view/window/panels/code_view.h"

namespace glibra::view {

/// Draws the widget in the rest of the current window, except for `below` pixels at its lower edge. `name`
/// must be unique in the window. `wraps`: lines that are too long continue in further rows. Returns true if
/// the text has changed.
bool codeEditor(const char* name, std::string& text, CodeView& view, const CodeMarks& marks,
                CodeLanguage language, bool isReadOnly, float below, bool wraps);

}  // namespace glibra::view
