#pragma once
// The window itself: GLFW, an OpenGL context of the highest core version, events.

#include <glibra/result.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace glibra::view {

class Display {
  public:
    /// Opens a window of that size in screen coordinates. The error view-E02 is one sentence.
    static Result<Display> open(int width, int height, const std::string& title);
    Display(Display&&) noexcept;
    Display& operator=(Display&&) noexcept;
    ~Display();

    [[nodiscard]] GLFWwindow* handle() const { return window_; }
    /// Address of a GL function.
    static void* address(const char* function);

    [[nodiscard]] bool isOpen() const;
    void close();
    /// Somebody asked to close it, and it is not to be.
    void keepOpen();
    void setTitle(const std::string& title);
    void setSize(int width, int height);
    /// Screen coordinates.
    [[nodiscard]] std::pair<int, int> size() const;
    /// Pixels.
    [[nodiscard]] std::pair<int, int> framebufferSize() const;
    /// How much larger than at 96 dots an inch text should be.
    [[nodiscard]] float contentScale() const;
    /// Pictures a second that the primary monitor shows; 60 if it does not say.
    [[nodiscard]] double refreshRate() const;
    /// True if the driver can wait for the monitor between two pictures, which it is then told to.
    [[nodiscard]] static bool hasSwapControl();

    void present();
    /// Takes events; waits for one if `seconds` is not 0, for ever if it is negative.
    void takeEvents(double seconds);
    /// Ends a wait, from any thread.
    static void wake();
    /// True once after any event reached the window.
    bool takeActivity();
    /// A key that went down.
    struct KeyPress {
        int key = 0;  ///< GLFW's number
        bool control = false;
    };
    /// A key that went down or up, or a character that was typed, if that is not 0.
    struct KeyEvent {
        int key = 0;  ///< GLFW's number
        bool isDown = false;
        unsigned character = 0;
    };
    /// In the order in which they came, since the last call.
    std::vector<KeyEvent> takeKeyEvents();
    /// Files dropped on the window since the last call.
    std::vector<std::filesystem::path> takeDropped();

  private:
    struct Events;
    Display(GLFWwindow* window, std::unique_ptr<Events> events);
    GLFWwindow* window_ = nullptr;
    std::unique_ptr<Events> events_;
};

}  // namespace glibra::view
