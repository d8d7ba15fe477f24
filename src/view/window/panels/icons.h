#pragma once
// Icons, drawn as lines and shapes in the colour of the text, and buttons with them.

#include <imgui.h>

#include <cstddef>
#include <span>

namespace glibra::view {

enum class Icon {
    open,      ///< a folder
    examples,  ///< a grid of pictures
    source,    ///< < / >
    reload,    ///< a circle with an arrow
    help,      ///< ?
    play,
    pause,
    back,     ///< one frame back
    forward,  ///< one frame forward
    restart,  ///< to the begin
    step,     ///< one step forward
    undo      ///< back to the value of the scene
};

/// Draws the icon into a square.
void drawIcon(ImDrawList& list, Icon icon, const ImVec2& at, float side, ImU32 color);

/// A square button as high as a field. The tooltip is shown while the mouse is over it. With `isOn` the icon
/// has the accent's colour.
bool iconButton(Icon icon, const char* id, const char* tooltip, bool isOn = false);
/// A button with an icon and a word; with `isShort` only the icon.
bool toolButton(Icon icon, const char* word, const char* tooltip, bool isShort);
/// How many of toolButton()s with these words must be short, from the first one on, so that all of them fit
/// side by side into that width.
std::size_t shortTools(std::span<const char* const> words, float width);

/// Continues the row if an item of that width fits into it; otherwise the next item begins a new row.
void continueRow(float width);
/// The same for a button, a check box or a radio button with that label.
void continueRowForButton(const char* label);
void continueRowForCheck(const char* label);
/// The same for iconButton().
void continueRowForIcon();
/// The same for toolButton().
void continueRowForTool(const char* word, bool isShort);

}  // namespace glibra::view
