#pragma once
// The operating system's window: GLFW, an OpenGL context of the highest core version, and events.

#include <glibra/result.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace glibra::view {

class Display {
  public:
    /// Opens a window of that size in screen coordinates. Fails with view-E02.
    static Result<Display> open(int width, int height, const std::string& title);
    Display(Display&&) noexcept;
    Display& operator=(Display&&) noexcept;
    ~Display();

    [[nodiscard]] GLFWwindow* handle() const { return window_; }
    /// The address of a GL function.
    static void* address(const char* function);

    [[nodiscard]] bool isOpen() const;
    void close();
    /// Cancels a request of the user to close the window.
    void keepOpen();
    void setTitle(const std::string& title);
    void setSize(int width, int height);
    /// Screen coordinates.
    [[nodiscard]] std::pair<int, int> size() const;
    /// Pixels.
    [[nodiscard]] std::pair<int, int> framebufferSize() const;
    /// The scale of text, relative to 96 dots per inch.
    [[nodiscard]] float contentScale() const;
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
    };
    /// A key that was pressed or released; or, if `character` is not 0, a character that was typed.
    struct KeyEvent {
        int key = 0;  ///< GLFW key code
        bool isDown = false;
        unsigned character = 0;
    };
    /// The key events since the last call, in order.
    std::vector<KeyEvent> takeKeyEvents();
    /// The files dropped on the window since the last call.
    std::vector<std::filesystem::path> takeDropped();

  private:
    struct Events;
    static Events& eventsOf(GLFWwindow* window);
    static void listen(GLFWwindow* window, Events& events);
    Display(GLFWwindow* window, std::unique_ptr<Events> events);
    GLFWwindow* window_ = nullptr;
    std::unique_ptr<Events> events_;
};

}  // namespace glibra::view
