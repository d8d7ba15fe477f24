#pragma once
// The operating system's window: GLFW, an OpenGL context of the highest core version, and events.

#include <glibra/result.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace glibra::view {

/// In screen coordinates, from the upper left corner of the window.
struct MousePoint {
    double x = 0, y = 0;
    friend bool operator==(const MousePoint&, const MousePoint&) = default;
};

class Display {
  public:
    /// Opens a window of that size in screen coordinates. Fails with view-E02.
    static Result<Display> open(int width, int height, const std::string& title);
    Display(Display&&) noexcept;
    Display& operator=(Display&&) = delete;
    ~Display();

    [[nodiscard]] GLFWwindow* handle() const { return window_; }
    /// The address of a GL function.
    static void* address(const char* function);

    /// Opens another window with a context of its own in place of this one, whose context is lost. Fails with
    /// view-E02; the window stays then.
    Diagnostics renew();

    [[nodiscard]] bool isOpen() const;
    void close();
    /// Cancels a request of the user to close the window.
    void keepOpen();
    void setTitle(const std::string& title);
    void setSize(int width, int height);
    /// Covers the monitor that most of the window is on, or gives the window its place back.
    void setFullScreen(bool on);
    [[nodiscard]] bool isFullScreen() const;
    /// Screen coordinates.
    [[nodiscard]] std::pair<int, int> size() const;
    /// Pixels.
    [[nodiscard]] std::pair<int, int> framebufferSize() const;
    /// The scale of text in pixels, relative to 96 dots per inch, in steps of a twentieth: X11 knows the size
    /// of screens in whole millimetres only.
    [[nodiscard]] float contentScale() const;
    /// Pixels per screen coordinate: 1 on X11.
    [[nodiscard]] float density() const;
    /// The size that a window may have on the primary monitor, without the desktop's bars and the window's
    /// own frame, in screen coordinates; empty if it is unknown.
    [[nodiscard]] std::optional<std::pair<int, int>> largestSize() const;
    /// Moves the window, which will have that size, so that it is whole on the primary monitor, if it was
    /// there before.
    void moveInside(int width, int height);
    /// The refresh rate of the primary monitor in Hz; 60 if it is unknown.
    [[nodiscard]] double refreshRate() const;
    /// True if the driver can wait for the monitor between two frames. If so, it does.
    [[nodiscard]] static bool hasSwapControl();

    void present();
    /// Processes events. First waits up to `seconds` for one; a negative value waits without limit.
    void takeEvents(double seconds);
    /// Ends a wait in takeEvents(); may be called from any thread.
    static void wake();
    /// True if any event has reached the window since the last call.
    bool takeActivity();
    /// A key that was pressed.
    struct KeyPress {
        int key = 0;  ///< GLFW key code
        bool control = false;
        bool shift = false;  ///< when the key went down; it may be up again when the frame begins
    };
    /// What a key, the mouse or its wheel did.
    struct InputEvent {
        enum class Kind { key, character, button, move, leave, wheel };
        Kind kind = Kind::key;
        int code = 0;         ///< of a key or button in GLFW; a character in Unicode
        bool isDown = false;  ///< of a key or button
        MousePoint at{};      ///< where the mouse moved to; how far the wheel turned
    };
    /// The events since the last call, in order.
    std::vector<InputEvent> takeInput();
    /// The files dropped on the window since the last call.
    std::vector<std::filesystem::path> takeDropped();

  private:
    struct Events;
    static Events& eventsOf(GLFWwindow* window);
    static void note(GLFWwindow* window, const InputEvent& event);
    static void listen(GLFWwindow* window, Events& events);
    Display(GLFWwindow* window, std::unique_ptr<Events> events);
    GLFWwindow* window_ = nullptr;
    std::unique_ptr<Events> events_;
    std::string title_;
    std::array<int, 4> before_{};  ///< place and size before full screen
};

}  // namespace glibra::view
