#pragma once
// Windows of the desktop: their frames, and one that nobody sees.

namespace glibra::system {

// The frames that the system draws around windows.

/// Gives the windows of this thread a dark title bar or a light one, where the system has both.
void setTitleBars(bool dark);

// A window that nobody sees, where the system makes contexts of OpenGL only for windows (WGL).

/// It belongs to the thread that makes it, and has to be destroyed there. Its pixels are RGBA with 8 bits
/// each and a depth of 24 bits, with two buffers, of the driver of the graphics card.
class HiddenWindow {
  public:
    /// Always empty where contexts need no window.
    HiddenWindow();
    HiddenWindow(const HiddenWindow&) = delete;
    HiddenWindow& operator=(const HiddenWindow&) = delete;
    ~HiddenWindow();  // NOLINT(performance-trivially-destructible): not on Windows

    /// False if there is no window or no such format.
    [[nodiscard]] bool isOpen() const { return context_ != nullptr; }
    /// What the system calls its device context (HDC); null if it is not open.
    [[nodiscard]] void* deviceContext() const { return context_; }

  private:
    [[maybe_unused]] void* window_ = nullptr;  // where windows are made
    void* context_ = nullptr;
};

}  // namespace glibra::system
