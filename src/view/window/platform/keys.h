#pragma once
// The keyboard, mouse and text of a frame for Dear ImGui, with keys by their GLFW codes. Dear ImGui has
// changed how keys are given and asked for (1.87); no other file of the window knows that Debian 12 has 1.86
// and Debian 13 has 1.90.

#include <memory>
#include <span>

#include "view/window/platform/input.h"

namespace glibra::view {

/// The input of a frame as ImGui gets it and as it is recorded. `way` stays empty.
FrameInput inputOf(const InputQueue& queue, const InputQueue::Frame& frame);

/// Gives ImGui the input of its next frame; call it before ImGui::NewFrame() and after the backend's.
void giveToImGui(const FrameInput& input);

/// True if the key is pressed in this frame, or, if `repeats`, held so long that it is pressed again.
bool isKeyPressed(int key, bool repeats = true);

/// The same for Enter, also that of the number pad.
bool isEnterPressed(bool repeats = true);

/// True if the key is down in this frame.
bool isKeyDown(int key);

/// Gives the keyboard to the next widget of the current window.
void giveKeyboardToNext();

/// Call it before ImGui::NewFrame(): ImGui does nothing by itself with Tab (its keyboard focus) or Escape
/// (its menus) in that frame.
void keepFromImGui(int key);

/// In the next frame the widget of that number does what a click does; a text field gets the keyboard.
/// `prefersInput`: fields that are dragged become text fields.
void activateItem(unsigned id, bool prefersInput);

/// While it lives, the widgets of this frame see these keys as not pressed.
class HiddenKeys {
  public:
    explicit HiddenKeys(std::span<const int> keys);
    HiddenKeys(const HiddenKeys&) = delete;
    HiddenKeys& operator=(const HiddenKeys&) = delete;
    ~HiddenKeys();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace glibra::view
