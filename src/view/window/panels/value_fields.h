#pragma once
// Sliders, fields for numbers, and fields for colours.

#include <array>
#include <optional>
#include <string_view>

#include "view/scene/slider_scale.h"
#include "view/window/panels/ui.h"

namespace glibra::view {

// The slider of all values with a range: the ends of the range in its track, the value beside the thumb, fine
// dragging, and the keyboard.

struct SliderUse {
    bool isChanged = false;    ///< by the mouse or the keyboard
    bool isActivated = false;  ///< the mouse has gone down on it
    bool isTyped = false;      ///< a text field is wanted in its place: double click or Enter
    bool wantsMenu = false;    ///< right click
};

/// Draws the slider and changes `value`. Its width is that of the next item. `unit` stands after the value.
/// Shift makes dragging and keys ten times finer.
SliderUse valueSlider(Ui& ui, const char* id, const SliderScale& scale, double& value, const char* unit = "");

/// The text field that stands in place of the slider of that id while Ui::typing names it, for any value.
/// Returns true when the user has finished: then `value` is what was typed.
bool sliderEntry(Ui& ui, const char* id, double& value);

/// A slider with its label beside it; a double click or Enter makes it a text field, whose value is brought
/// into the range. `name` is that for mark(). Its width is that of the next item. Returns true if `value` has
/// changed.
bool labelledSlider(Ui& ui, const char* label, std::string_view name, const SliderScale& scale, double& value,
                    const char* unit = "");

/// Before the widgets of a frame: Tab and Shift+Tab choose a widget (shortcuts.h); arrows, Page Up and Page
/// Down, Home and End move the chosen slider. Keys that the scene uses stay with the scene.
void beginSliders(Ui& ui);
/// After them: a click elsewhere takes the keyboard from the slider.
void endSliders(Ui& ui);

// Numbers in text fields, as view/scene/slider_scale.h reads them. Dear ImGui's own fields read digits up to
// the first other sign: 0,5 as 5 and 1/3 as 1.

/// Takes the place of a field of ImGui that is dragged (DragScalar and its like), while a number is typed
/// into it. Returns true if that has changed the value; nothing if none is typed: the caller draws the field.
std::optional<bool> typedInto(Ui& ui, const char* label, double& value);

/// A field for a number that is typed. Returns true if the value has changed.
bool numberEntry(const char* label, double& value, const char* format, int flags = 0);
/// The same for a whole number between those.
bool wholeEntry(const char* label, int& value, int least, int most, int flags = 0);
/// Two fields side by side, with the label to their right; ImGui takes them for one widget.
bool pairEntry(Ui& ui, const char* label, std::array<double, 2>& values, const char* format);
/// The same for the sides of a picture in pixels, from 1 to `most`.
bool sidesEntry(Ui& ui, const char* label, int& width, int& height, int most);

// Fields for colours.

/// A button in the colour, which opens a picker. Returns true if the colour has changed.
bool colorSwatch(Ui& ui, const char* id, std::string_view name, std::array<float, 4>& rgba, bool hasAlpha);

/// A swatch and a number for each component, which is dragged or typed; in two rows if one is too narrow to
/// show three digits. `name` is that of the numbers together, for mark(). Returns true if the colour has
/// changed.
bool colorField(Ui& ui, std::string_view name, std::array<float, 4>& rgba, bool hasAlpha);

}  // namespace glibra::view
