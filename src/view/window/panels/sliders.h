#pragma once
// The state that the sliders of a tab share (value_slider.h): which one has the keyboard, and what is typed.

#include <optional>
#include <string>
#include <vector>

namespace glibra::view {

/// A slider that the mouse drags.
struct SliderDrag {
    float mouse = 0;      ///< x where `position` was
    double position = 0;  ///< of the thumb, 0..1
    bool isFine = false;
};

struct Sliders {
    std::vector<unsigned> drawn;  ///< in this frame, for Tab; ImGui's numbers of widgets
    unsigned focused = 0;         ///< gets the keys; 0: none
    SliderDrag drag;
    double moves = 0;         ///< by keys of this frame, as a part of the scale
    std::optional<bool> end;  ///< keys of this frame: to the minimum (false), to the maximum (true)
    bool isTyped = false, wasClicked = false, reveals = false;
    std::string typing;         ///< the slider that is a text field now: "uniform/Dots/uKd/0"
    bool typingBegins = false;  ///< the text field needs the keyboard focus
    double typed = 0;
    std::vector<double> valuesBeforeClick;
};

}  // namespace glibra::view
