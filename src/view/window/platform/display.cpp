#include "view/window/platform/display.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <thread>
#include <tuple>

namespace glibra::view {

struct Display::Events {
    bool active = true;
    std::vector<std::filesystem::path> dropped;
    std::vector<InputEvent> input;
};

namespace {

constexpr std::array<std::pair<int, int>, 6> kVersions{{{4, 6}, {4, 5}, {4, 4}, {4, 3}, {4, 2}, {4, 1}}};
constexpr double kDefaultRefreshRate = 60;

std::string lastError() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "unknown reason";
}

/// A window with the highest OpenGL version that the driver has; null if it has none. Its context is lost
/// with a reset of the device, and tells so, if the driver has such contexts.
GLFWwindow* createWindow(int width, int height, const std::string& title) {
    for (const auto& [major, minor] : kVersions)
        for (const int robustness : {GLFW_LOSE_CONTEXT_ON_RESET, GLFW_NO_ROBUSTNESS}) {
            glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
            glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
            glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, robustness);
            if (GLFWwindow* window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr))
                return window;
        }
    return nullptr;
}

/// Left, top, width and height of the primary monitor without the desktop's bars.
std::optional<std::array<int, 4>> workArea() {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return std::nullopt;
    std::array<int, 4> area{};
    glfwGetMonitorWorkarea(monitor, &area[0], &area[1], &area[2], &area[3]);
    if (area[2] < 1 || area[3] < 1) return std::nullopt;
    return area;
}

/// What the window's frame takes: left, top, right, bottom.
std::array<int, 4> frameOf(GLFWwindow* window) {
    std::array<int, 4> frame{};
    glfwGetWindowFrameSize(window, &frame[0], &frame[1], &frame[2], &frame[3]);
    return frame;
}

}  // namespace

Display::Events& Display::eventsOf(GLFWwindow* window) {
    return *static_cast<Events*>(glfwGetWindowUserPointer(window));
}

void Display::note(GLFWwindow* window, const InputEvent& event) {
    eventsOf(window).active = true;
    eventsOf(window).input.push_back(event);
}

/// Registers the callbacks that write into `events`, which must outlive the window.
void Display::listen(GLFWwindow* window, Events& events) {
    glfwSetWindowUserPointer(window, &events);
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* at) { eventsOf(at).active = true; });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* at, int, int) { eventsOf(at).active = true; });
    using Kind = InputEvent::Kind;
    glfwSetCursorPosCallback(
        window, [](GLFWwindow* at, double x, double y) { note(at, {Kind::move, 0, false, {x, y}}); });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* at, int button, int action, int) {
        note(at, {Kind::button, button, action == GLFW_PRESS, {}});
    });
    glfwSetScrollCallback(
        window, [](GLFWwindow* at, double x, double y) { note(at, {Kind::wheel, 0, false, {x, y}}); });
    glfwSetWindowContentScaleCallback(window,
                                      [](GLFWwindow* at, float, float) { eventsOf(at).active = true; });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* at, int) { eventsOf(at).active = true; });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* at, int enters) {
        eventsOf(at).active = true;
        if (enters == GLFW_FALSE) note(at, {Kind::leave, 0, false, {}});
    });
    glfwSetKeyCallback(window, [](GLFWwindow* at, int key, int, int action, int) {
        eventsOf(at).active = true;
        if (action != GLFW_REPEAT) note(at, {Kind::key, key, action == GLFW_PRESS, {}});
    });
    glfwSetCharCallback(window, [](GLFWwindow* at, unsigned int character) {
        note(at, {Kind::character, static_cast<int>(character), true, {}});
    });
    glfwSetDropCallback(window, [](GLFWwindow* at, int count, const char** paths) {
        eventsOf(at).active = true;
        eventsOf(at).dropped.insert(eventsOf(at).dropped.end(), paths, paths + count);
    });
}

Result<Display> Display::open(int width, int height, const std::string& title) {
#ifdef GLFW_PLATFORM
    // GLFW 3.4 looks for Wayland before X, and the library of Wayland complains to standard error if there is
    // none.
    if (std::getenv("WAYLAND_DISPLAY") == nullptr && std::getenv("DISPLAY") != nullptr &&
        glfwPlatformSupported(GLFW_PLATFORM_X11) == GLFW_TRUE)
        glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
    if (glfwInit() == GLFW_FALSE)
        return diagnose("view-E02", "no display found (" + lastError() +
                                        "); `glibra render SCENE` writes a picture without one");
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    GLFWwindow* window = createWindow(width, height, title);
    if (!window) {
        const std::string why = lastError();
        glfwTerminate();
        return diagnose("view-E02", "cannot open a window with OpenGL 4.1 or later (" + why +
                                        "); `glibra render SCENE` writes a picture without one");
    }
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    auto events = std::make_unique<Events>();
    listen(window, *events);
    Display display(window, std::move(events));
    display.title_ = title;
    return display;
}

Diagnostics Display::renew() {
    const auto [width, height] = size();
    int left = 0, top = 0;
    glfwGetWindowPos(window_, &left, &top);
    const bool isMaximized = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE;
    // The size is that in screen coordinates already.
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_FALSE);
    // A driver may need some time before it gives a context again.
    constexpr int kTries = 20;
    GLFWwindow* window = createWindow(width, height, title_);
    for (int i = 1; i < kTries && window == nullptr; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        window = createWindow(width, height, title_);
    }
    if (window == nullptr) return {diagnose("view-E02", "cannot open a window again (" + lastError() + ")")};
    glfwSetWindowPos(window, left, top);
    if (isMaximized) glfwMaximizeWindow(window);
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    glfwDestroyWindow(std::exchange(window_, window));
    *events_ = {};
    listen(window_, *events_);
    return {};
}

Display::Display(GLFWwindow* window, std::unique_ptr<Events> events)
    : window_(window), events_(std::move(events)) {}
Display::Display(Display&& other) noexcept
    : window_(std::exchange(other.window_, nullptr)),
      events_(std::move(other.events_)),
      title_(std::move(other.title_)),
      before_(other.before_) {}
Display::~Display() {
    if (!window_) return;
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void* Display::address(const char* function) {
    return reinterpret_cast<void*>(glfwGetProcAddress(function));
}

bool Display::isOpen() const {
    return glfwWindowShouldClose(window_) == GLFW_FALSE;
}
void Display::close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}
void Display::keepOpen() {
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
}
void Display::setTitle(const std::string& title) {
    title_ = title;
    glfwSetWindowTitle(window_, title.c_str());
}
void Display::setSize(int width, int height) {
    glfwSetWindowSize(window_, std::max(1, width), std::max(1, height));
}
void Display::setFullScreen(bool on) {
    if (on == isFullScreen()) return;
    if (!on) {
        const auto [left, top, width, height] = before_;
        return glfwSetWindowMonitor(window_, nullptr, left, top, width, height, GLFW_DONT_CARE);
    }
    glfwGetWindowPos(window_, &before_[0], &before_[1]);
    std::tie(before_[2], before_[3]) = size();
    int count = 0;
    GLFWmonitor** const monitors = glfwGetMonitors(&count);
    GLFWmonitor* best = nullptr;
    long most = -1;
    for (int i = 0; i < count; ++i) {
        const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
        if (mode == nullptr) continue;
        int left = 0, top = 0;
        glfwGetMonitorPos(monitors[i], &left, &top);
        const auto shared = [](int a, int aSize, int b, int bSize) {
            return static_cast<long>(std::max(0, std::min(a + aSize, b + bSize) - std::max(a, b)));
        };
        const long area = shared(before_[0], before_[2], left, mode->width) *
                          shared(before_[1], before_[3], top, mode->height);
        if (area <= most) continue;
        most = area;
        best = monitors[i];
    }
    if (best == nullptr) return;
    const GLFWvidmode* mode = glfwGetVideoMode(best);
    glfwSetWindowMonitor(window_, best, 0, 0, mode->width, mode->height, mode->refreshRate);
}
bool Display::isFullScreen() const {
    return glfwGetWindowMonitor(window_) != nullptr;
}
std::pair<int, int> Display::size() const {
    std::pair<int, int> size;
    glfwGetWindowSize(window_, &size.first, &size.second);
    return size;
}
std::pair<int, int> Display::framebufferSize() const {
    std::pair<int, int> size;
    glfwGetFramebufferSize(window_, &size.first, &size.second);
    return size;
}
float Display::contentScale() const {
    float x = 1;
    float y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    constexpr float kSteps = 20;
    return std::clamp(std::round(x * kSteps) / kSteps, .5F, 8.F);
}
float Display::density() const {
    const int width = size().first;
    const int pixels = framebufferSize().first;
    return width > 0 && pixels > 0 ? static_cast<float>(pixels) / static_cast<float>(width) : 1;
}

std::optional<std::pair<int, int>> Display::largestSize() const {
    const auto area = workArea();
    if (!area) return std::nullopt;
    const auto [left, top, right, bottom] = frameOf(window_);
    return std::pair((*area)[2] - left - right, (*area)[3] - top - bottom);
}
void Display::moveInside(int width, int height) {
    const auto area = workArea();
    if (!area) return;
    std::array<int, 2> at{};
    glfwGetWindowPos(window_, &at[0], &at[1]);
    const auto [left, top, right, bottom] = frameOf(window_);
    const bool isOnOther = at[0] < (*area)[0] || at[1] < (*area)[1] || at[0] >= (*area)[0] + (*area)[2] ||
                           at[1] >= (*area)[1] + (*area)[3];
    if (isOnOther) return;
    const auto moved = [](int place, int first, int size, int from, int room) {
        return std::max(from + first, std::min(place, from + room - size));
    };
    const int x = moved(at[0], left, width + right, (*area)[0], (*area)[2]);
    const int y = moved(at[1], top, height + bottom, (*area)[1], (*area)[3]);
    if (x != at[0] || y != at[1]) glfwSetWindowPos(window_, x, y);
}
double Display::refreshRate() const {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    return mode && mode->refreshRate > 0 ? mode->refreshRate : kDefaultRefreshRate;
}

bool Display::hasSwapControl() {
    constexpr std::array<const char*, 3> kExtensions{"GLX_EXT_swap_control", "GLX_MESA_swap_control",
                                                     "GLX_SGI_swap_control"};
    return std::ranges::any_of(kExtensions,
                               [](const char* each) { return glfwExtensionSupported(each) == GLFW_TRUE; });
}

void Display::present() {
    glfwSwapBuffers(window_);
}
void Display::takeEvents(double seconds) {
    if (seconds < 0)
        glfwWaitEvents();
    else if (seconds > 0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
}
void Display::wake() {
    glfwPostEmptyEvent();
}
bool Display::takeActivity() {
    return std::exchange(events_->active, false);
}
std::vector<Display::InputEvent> Display::takeInput() {
    return std::exchange(events_->input, {});
}
std::vector<std::filesystem::path> Display::takeDropped() {
    return std::exchange(events_->dropped, {});
}

}  // namespace glibra::view
