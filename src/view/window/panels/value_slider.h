#pragma once
// The slider of all values with a range: the ends of the range in its track, the value beside the thumb, fine
// dragging, and the keyboard.

#include <string_view>

#include "view/scene/slider_scale.h"
#include "view/window/panels/ui.h"

namespace glibra::view {

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

/// Before the widgets of a frame: Tab and Shift+Tab choose a widget (tab_stops.h); arrows, Page Up and Page
/// Down, Home and End move the chosen slider. Keys that the scene uses stay with the scene.
void beginSliders(Ui& ui);
/// After them: a click elsewhere takes the keyboard from the slider.
void endSliders(Ui& ui);

}  // namespace glibra::view
