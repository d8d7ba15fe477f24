#pragma once
// The state that the sliders of a tab share (value_slider.h): which one has the keyboard, and what is typed.
// The other widgets that Tab reaches (tab_stops.h) are in the same list.

#include <array>
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

/// A widget that Tab reaches.
struct TabStop {
    unsigned id = 0;          ///< ImGui's number
    unsigned window = 0;      ///< of the window that it belongs to, ImGui's number
    bool isValue = false;     ///< a slider, which takes the keys itself
    bool isEntry = false;     ///< a text field, which gets the keyboard at once
    bool isInValues = false;  ///< one of the values of the scene
};

struct Sliders {
    std::vector<TabStop> drawn;  ///< in this frame, in the order of Tab
    unsigned focused = 0;        ///< gets the keys; 0: none
    unsigned activated =
        0;  ///< by Enter or the space bar in this frame, for stops that are no widgets of ImGui
    SliderDrag drag;
    double moves = 0;         ///< by keys of this frame, as a part of the scale
    std::optional<bool> end;  ///< keys of this frame: to the minimum (false), to the maximum (true)
    bool isTyped = false, wasClicked = false, reveals = false;
    /// The space bar, for the stop that has the keyboard. ImGui does not see a key that goes up again within
    /// a frame.
    bool isSpacePressed = false;
    bool wantsMenu = false;        ///< the menu of the focused value, by its key
    std::string typing;            ///< the slider that is a text field now: "uniform/Dots/uKd/0"
    bool typingBegins = false;     ///< the text field needs the keyboard focus
    std::array<char, 64> typed{};  ///< an expression
    std::string typedBefore;       ///< as the field began
    unsigned typedField = 0;       ///< another field of a number that is typed into (number_field.h); 0: none
    double valueBefore = 0;        ///< of that field
    std::vector<double> valuesBeforeClick;
};

}  // namespace glibra::view
